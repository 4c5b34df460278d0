#pragma once
#include <optional>
#include <string>
#include <vector>

#include <sphonic/chart.hpp>
#include <sphonic/json_fwd.hpp>
#include <sphonic/registry.hpp>
#include <sphonic/stability.hpp>
#include <sphonic/stability_trial.hpp>

namespace sphonic {

/// The limit of a silenced case's step by theory, viscosity at half strength, and by bisection.
struct StabilityFinding {
    std::string basis;
    StepLimit predicted;
    /// Where viscosity acts on waves of a box: the limit lies between them, the smaller of them is safe [s].
    std::optional<double> inviscid, always_on;
    StabilityTrial::Limit measured;
    /// Where no step is stable: ln of the worst mode's growth in a step of `dt`, the case's own or a small one.
    struct AnyStep {
        double dt, growth;
    };
    std::optional<AnyStep> any_step{};
};
StabilityFinding find_stability(const Case& scene, const StabilityTrial::Options& options, const StabilityTrial::Report& report = {});

/// c0 dt/dx of a step, by the fastest medium.
double courant_dx(const Case& scene, double dt);

/// Weak growth at a step: ln of the amplitude's per step, by theory for the worst mode and measured on the fastest motion.
struct GrowthFinding {
    double dt;
    long steps;
    double predicted, measured;
};
GrowthFinding find_growth(const Case& scene, double dt, long steps, const StabilityTrial::Options& options);

Json to_json(const Case& scene, const StabilityFinding& finding, const StabilityTrial::Options& options);
Json to_json(const GrowthFinding& finding);

/// A parameter that is varied: `count` values from `from` to `to`.
struct Varied {
    std::string pointer;
    double from, to;
    int count;

    /// Reads "/pointer=a:b:n".
    explicit Varied(const std::string& text);
    double value(int i) const { return from + (to - from) * i / (count - 1); }
};

/// How stability depends on one parameter, or two. Of one: the limit at each of its values. Of two, or where the one is the step
/// itself: what each case's own step does.
class StabilityMap {
public:
    /// `document` is the case's, with all overrides.
    StabilityMap(Json document, std::filesystem::path file, std::vector<Varied> varied, Registry& registry, const StabilityTrial::Options& options);

    int points() const;
    /// Finds out about the next point; its values stand in `label`.
    std::string label(int point) const;
    void find(int point, const StabilityTrial::Report& report);

    std::string csv() const;
    Chart chart() const;

private:
    struct Point {
        double courant_per_dt = 0;                    ///< c0/dx [1/s]
        double dt = 0;                                ///< its own step [s]
        double predicted = 0, predicted_growth = 0;    ///< limit [s]; ln |xi| at dt
        bool weak = false;
        StabilityFinding finding{};    ///< of one parameter
        StabilityTrial::Run run{};     ///< of a weak integrator, `stable` while it grows by less than e^12 within `until`
    };
    std::shared_ptr<const Json> document_;
    std::filesystem::path file_;
    std::vector<Varied> varied_;
    Registry& registry_;
    StabilityTrial::Options options_;
    std::vector<Point> points_;
    std::string title_, courant_length_ = "dx";
    bool own_step_;

    double value(int point, std::size_t parameter) const;
    Case load(int point) const;
    Chart line_chart() const;
    Chart growth_chart() const;
    Chart cell_chart() const;
    std::string axis_label(std::size_t parameter) const;
};

/// Eigenvalues times dt in the region where the integrator does not grow.
Chart spectrum_chart(const Case& scene, const StepTheory& theory, double dt);

}    // namespace sphonic
