#include <cmath>
#include <cstdio>
#include <iostream>

#include <sphonic/json.hpp>
#include <sphonic/log.hpp>
#include <sphonic/prediction.hpp>
#include <sphonic/registry.hpp>

#include "commands.hpp"
#include "limit_words.hpp"
#include "planned.hpp"

namespace sphonic::driver {
namespace {

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json check_json(const Summary& s, const Prediction& p) {
    Json warnings = p.warnings;
    for (const std::string& warning : s.warnings) warnings.push_back(warning);
    Json layers = Json::array();
    for (const LayerReturn& layer : p.layers)
        layers.push_back({{"face", layer.face}, {"omega", layer.omega}, {"normal_db", layer.normal}, {"oblique_db", layer.oblique}, {"oblique_angle", oblique_angle}});
    return {{"title", s.title}, {"particles", s.particles}, {"tier", s.tier}, {"neighbours_mean", s.neighbours_mean},
            {"steps", s.steps}, {"dt", s.dt}, {"dt_limit", s.dt_limit}, {"weakly_unstable", s.weak},
            {"dt_mild", s.dt_mild}, {"growth_exponent", s.growth}, {"growth_rate", s.growth_rate},
            {"predicted", {{"l2", optional_json(p.l2)}, {"estimated", p.estimated}, {"rounding", optional_json(p.rounding)}, {"speed_error", optional_json(p.speed_error)}, {"cpu_s", p.cpu_s},
                           {"memory_bytes", p.memory_bytes}, {"basis", p.basis}, {"layers", layers}}},
            {"warnings", warnings}};
}

}    // namespace

int check(const RunOptions& options) {
    Registry registry(Registry::search_path(options.plugin_path));
    const Case scene = load_planned(options.file, options.set, registry);
    const Simulation simulation(scene);
    const Summary& s = simulation.summary();
    Prediction p = predict(scene, s, Trials::allowed);
    for (const std::string& warning : source_warnings(scene, s.dt)) p.warnings.push_back(warning);
    if (options.json) {
        std::cout << json_text(check_json(s, p));
        return 0;
    }
    const double courant = scene.media->fastest().c0 / scene.box.dx;
    std::printf("%s: the case is sound\n", s.title.c_str());
    std::printf("  %ld particles, %s tier, %.1f neighbours, %ld steps\n", s.particles, s.tier.c_str(), s.neighbours_mean, s.steps);
    std::printf("  step %.4g s (c0 dt/dx = %.4g), %s\n", s.dt, s.dt * courant, limit_words(scene, s).c_str());
    if (s.weak && s.dt_limit > 0)
        std::printf("  the worst mode grows by e^%.3g in this run; by e at the step %.4g s (c0 dt/dx = %.4g)\n", s.growth, s.dt_mild, s.dt_mild * courant);
    if (p.speed_error) std::printf("  predicted speed of long waves: %+.3g %%\n", 100 * *p.speed_error);
    if (p.l2) std::printf("  %s L2 error: %.3g\n", p.estimated ? "estimated" : "predicted", *p.l2);
    if (p.rounding) std::printf("  rounding of single precision: about %.1g\n", *p.rounding);
    for (const LayerReturn& layer : p.layers)
        std::printf("  the layer at %s returns %.1f dB at right angles, %.1f dB at %g degrees (at %.3g rad/s)\n", layer.face.c_str(), layer.normal, layer.oblique,
                    oblique_angle, layer.omega);
    for (const LayerReturn& layer : p.layers)
        std::printf("  the layer at %s suffices for errors down to %.2g %% at right angles (6 dB above what it returns)\n", layer.face.c_str(), 100 * std::pow(10, (layer.normal + 6) / 20));
    std::printf("  predicted cost: %.3g s of CPU, %.3g MB\n", p.cpu_s, 1e-6 * p.memory_bytes);
    for (const std::string& warning : s.warnings) log::warn(scene.file + ": " + warning);
    for (const std::string& warning : p.warnings) log::warn(scene.file + ": " + warning);
    return 0;
}

}    // namespace sphonic::driver
