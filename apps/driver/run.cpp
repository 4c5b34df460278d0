#include <cstdio>
#include <iostream>

#include <sphonic/chart.hpp>
#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/log.hpp>
#include <sphonic/registry.hpp>
#include <sphonic/result_folder.hpp>
#include <sphonic/run_report.hpp>
#include <sphonic/simulation.hpp>

#include "commands.hpp"
#include "interruption.hpp"
#include "limit_words.hpp"
#include "planned.hpp"
#include "progress.hpp"

namespace sphonic::driver {
namespace {

void print_summary(const Case& scene, const Summary& s, const std::filesystem::path& folder) {
    std::printf("%s\n", s.title.c_str());
    std::printf("  %ld particles, %s tier, %.1f neighbours, %s, %ld steps of %.4g s (%s)\n", s.particles, s.tier.c_str(),
                s.neighbours_mean, s.integrator.c_str(), s.steps, s.dt, limit_words(scene, s).c_str());
    if (s.weak && s.dt_limit > 0) std::printf("  its worst mode grows by e^%.3g in this run, by theory; by e at steps of %.4g s\n", s.growth, s.dt_mild);
    if (s.errors)
        std::printf("  error at t = %g s over %ld particles: L2 %.4g, rms %.4g P, eps %.4ge-4, largest %.4g Pa\n", s.t, s.errors->n,
                    s.errors->l2, s.errors->rms, 1e4 * s.errors->eps, s.errors->max);
    std::printf("  %.3g s of CPU on %d %s, %.3g ns per particle-step\n", s.cpu_s, s.threads, s.threads == 1 ? "thread" : "threads",
                s.particle_steps > 0 ? 1e9 * s.wall_s / s.particle_steps : 0.0);
    const double nominal = double(s.particles) * double(s.steps);
    if (s.particle_steps < nominal && !s.diverged)
        std::printf("  %.3g of the particle-steps, the rest asleep (%.3g would be ideal); error of that below %.1e of the largest amplitude\n",
                    s.particle_steps / nominal, s.ideal_particle_steps / nominal, s.asleep_error);
    if (s.diverged) std::printf("  DIVERGED %s\n", s.diverged_how.c_str());
    std::printf("  results in %s\n", folder.string().c_str());
}

}    // namespace

int run(const RunOptions& options) {
    const Interruptible interruptible;
    Registry registry(Registry::search_path(options.plugin_path));
    Case scene = load_planned(options.file, options.set, registry);
    scene.threads = options.threads;
    ResultFolder folder(options.out.empty() ? ResultFolder::unused(options.file.stem().string()) : options.out, options.force);
    Simulation simulation(scene);
    const Summary& summary = simulation.summary();
    for (const std::string& warning : summary.warnings) log::warn(scene.file + ": " + warning);
    const auto stop_if_asked = [&](long step) {
        char state[80];
        std::snprintf(state, sizeof state, "at t = %.4g s; nothing was written", double(step) * summary.dt);
        interruptible.stop_if_asked(scene.file, state);
    };
    stop_if_asked(0);
    {
        ProgressBar bar(options.file.stem().string());
        simulation.run([&](const Progress& p) {
            bar.show(p);
            stop_if_asked(p.step);
        });
    }
    try {
        write_results(scene, simulation, folder);
    } catch (const Error&) {
        stop_if_asked(summary.steps);    // a terminal interrupts the program that draws, too
        throw;
    }
    stop_if_asked(summary.steps);
    folder.commit();
    if (options.json)
        std::cout << json_text(to_json(summary));
    else
        print_summary(scene, summary, folder.target());
    if (!summary.diverged) return 0;
    log::error(scene.file + ": the run diverged " + summary.diverged_how + "; the outputs until then are kept");
    return int(Fault::diverged);
}

}    // namespace sphonic::driver
