#pragma once
#include <functional>
#include <memory>
#include <string>

#include <sphonic/case.hpp>

namespace sphonic {

/// Leaves the equations to themselves: no sources, initial fields or reference.
void silence(Case& scene);

/// Runs of a silenced case's own solver, set off by noise, at steps of any size.
class StabilityTrial {
public:
    struct Options {
        long steps = 3000;          ///< of a run that decides whether a step is stable
        double precision = 1e-3;    ///< relative, of a limit
        unsigned seed = 1;
    };
    /// Called after each run: its step [s] and what came of it. It may throw to end the trial.
    using Report = std::function<void(double dt, const std::string& outcome)>;

    /// The case must outlive the trial.
    StabilityTrial(const Case& scene, const Options& options, Report report = {});
    ~StabilityTrial();

    /// Energy in a run from white noise over all fields; it ends early once it has grown by e^18.
    struct Run {
        bool stable;      ///< the energy's peak does not double from the second quarter of the run to its last
        double growth;    ///< ln of the amplitude's growth per step, over the second half; at least 0 if it is stable
    };
    Run run(double dt);

    /// ln of the amplitude's growth per step over `steps` of the fastest motion of the set: noise that the equations themselves, applied
    /// again and again, have left little else of.
    double growth(double dt, long steps);

    /// A limit by bisection, from near a guess.
    struct Limit {
        double dt = 0;           ///< the middle between the largest stable and the smallest unstable step [s]; 0: none is stable
        double precision = 0;    ///< half of what lies between them, relative
        int runs = 0;
    };
    /// Nothing above 20 guesses is looked at, nothing below a twentieth.
    Limit limit(double guess);
    /// Of an integrator that grows at any step: where the fastest motion grows by e^exponent within the run.
    Limit limit_of_growth(double guess, double exponent);

private:
    class Set;
    class Particles;
    class Other;
    const Case& scene_;
    Options options_;
    Report report_;
    std::unique_ptr<Set> set_;

    template <class Stable>
    Limit bisect(double guess, Stable stable);
};

}    // namespace sphonic
