#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sphonic/case.hpp>
#include <sphonic/stability.hpp>

namespace sphonic {

/// Difference from the reference at the end of a run, over the n particles of its region, each for the volume it stands for.
struct Errors {
    double eps = 0;    ///< sqrt(sum e^2) / (n P): the formula of Li et al. (2015), which hides 1/sqrt(n)
    double rms = 0;    ///< sqrt(sum e^2 / n) / P
    double l2 = 0;     ///< sqrt(sum e^2 / sum p_exact^2)
    double max = 0;    ///< [Pa]
    long n = 0;
    double scale = 0;  ///< P [Pa]
};

/// Pressure at the particles nearest to the asked-for points.
struct ProbeRecord {
    std::vector<std::vector<double>> asked, read_at;    ///< [probe][axis]
    std::vector<double> t;
    std::vector<std::vector<double>> p, exact;          ///< [probe][sample]; exact is empty without a reference
};

/// The set at one time, in particle order.
struct Profile {
    double t = 0;                          ///< [s]
    std::vector<double> x[3], p, exact;    ///< exact is empty without a reference
    std::vector<char> in_region;           ///< of the reference
    std::vector<double> share;             ///< by which each counts in sums; empty where all are alike

    double share_of(std::size_t i) const { return share.empty() ? 1 : share[i]; }
};

/// What a run was and what it came to; `to_json` gives summary.json.
struct Summary {
    std::string title, tier, method, integrator;
    long steps = 0;
    double dt = 0, dt_limit = 0;
    bool weak = false;    ///< the integrator has no limit of its own
    /// Of a weak one: the step at which the worst mode grows by e in the run [s], and the exponent by which it will grow at `dt`.
    double dt_mild = 0, growth = 0;
    double growth_rate = 0;             ///< of the set's own worst motion at any step, by theory [1/s]
    long particles = 0;
    double neighbours_mean = 0;
    int threads = 1;
    double wall_s = 0, cpu_s = 0;       ///< stepping only
    double setup_s = 0;                 ///< CPU time before the first step
    double particle_steps = 0;          ///< particles really stepped, summed over steps
    double ideal_particle_steps = -1;   ///< of sound at the speed c0 that can matter; negative: all
    double asleep_error = 0;            ///< bound of what the others can have changed, over the largest amplitude
    std::string all_because;            ///< why all were stepped where less was wanted
    double memory_bytes = 0;
    std::optional<Errors> errors;
    double energy_initial = 0, energy_final = 0;
    bool diverged = false;
    std::string diverged_how;           ///< when, where, how large
    double t = 0;                       ///< reached [s]
    double last_good_t = 0;             ///< the last time at which all was well [s]
    std::vector<std::string> warnings;
};

Json to_json(const Summary& summary);

/// The step that a case asks for [s], of which the stable limit is dt_limit: by dt, Courant number or safety.
double asked_step(const Case& scene, double dt_limit);

struct Progress {
    long step, steps;
    double wall_s;
};

class Sentinel;

/// One case made ready to run. The step is fixed here: one beyond the stable limit is refused unless the case allows it.
class Simulation {
public:
    /// The case must outlive the simulation.
    explicit Simulation(const Case& scene);
    ~Simulation();

    const Summary& summary() const { return summary_; }
    /// Runs to the end, or until it diverges (then the summary says so). `progress` is called some ten times a second.
    void run(const std::function<void(const Progress&)>& progress = {});
    /// Runs until `step` steps are done, or the run's own end if that is sooner, and can go on from there. The summary's errors wait for the end.
    void run_to(long step, const std::function<void(const Progress&)>& progress = {});

    const ProbeRecord& probes() const { return probes_; }
    /// The present state beside the reference; not a number where a case asks for no fields, and for nothing else there.
    Profile profile();
    /// The last state that was seen while all was well: what a run that diverged has to show.
    Profile last_good();
    abi::Solver& solver() { return *solver_; }

private:
    const Case& scene_;
    std::unique_ptr<abi::Solver> solver_;
    std::unique_ptr<Sentinel> sentinel_;
    Summary summary_;
    SetGrowth set_;
    ProbeRecord probes_;
    std::vector<long> probe_particles_;
    std::vector<char> in_region_;    ///< by initial position
    bool beyond_linear_at_start_ = false;
    Profile measured_;               ///< that errors were taken from: some references are dear

    void take_step(const std::string& place);
    void fix_step();
    void predict_growth();
    void judge_set();
    std::string likely_cause() const;
    std::vector<double> places(const abi::Points& points) const;
    void find_probes();
    void sample();
    void complete(Profile& profile) const;
    long steps(long count);
    long steps_done() const;
    long next_sample(long done) const;
    void look(bool end = false);
    void advance_to(long step, const std::function<void(const Progress&)>& progress);
    Errors measure();
};

}    // namespace sphonic
