#include <cmath>
#include <cstdio>
#include <iostream>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/log.hpp>
#include <sphonic/registry.hpp>
#include <sphonic/result_folder.hpp>
#include <sphonic/simulation.hpp>
#include <sphonic/stability_report.hpp>

#include "commands.hpp"
#include "interruption.hpp"

namespace sphonic::driver {
namespace {

/// What is asked for, and where its parts tell of their progress and can be stopped.
class Stability {
public:
    explicit Stability(const StabilityOptions& options)
        : options_(options), trial_{.steps = options.steps, .precision = options.precision, .seed = unsigned(options.seed)},
          registry_(Registry::search_path(options.plugin_path)), scene_(load_case(options.file, options.set, registry_)) {
        for (const std::string& warning : scene_.warnings) log::warn(scene_.file + ": " + warning);
        silence(scene_);
    }
    void run();

private:
    const StabilityOptions& options_;
    const Interruptible interruptible_;
    StabilityTrial::Options trial_;
    Registry registry_;
    Case scene_;
    Json result_;

    StabilityTrial::Report report(const std::string& label) const {
        return [this, label](double dt, const std::string& outcome) {
            char step[80];
            std::snprintf(step, sizeof step, "dt %.5g s, c0 dt/dx = %.5g: ", dt, courant_dx(scene_, dt));
            log::info(label + step + outcome);
            interruptible_.stop_if_asked(scene_.file, "while looking for the limit; nothing was written");
        };
    }
    bool writes() const { return !options_.out.empty() || !options_.vary.empty() || options_.spectrum; }
    /// The case's own step, or the limit where it asks for a fraction of one.
    double own_step(const StepLimit& limit) const { return scene_.step.dt || scene_.step.courant ? asked_step(scene_, limit.dt) : limit.dt; }

    void print(const StabilityFinding& finding) const;
    void print(const GrowthFinding& growth) const;
    void refuse_unknown() const;
    void find();
    void draw_map(const ResultFolder& folder);
    void draw_spectrum(const ResultFolder& folder) const;
};

void print_step(const Case& scene, const char* what, double dt, const std::string& remark) {
    std::printf("  %-10s dt %-11.5g s   c0 dt/dx = %-9.5g %s\n", what, dt, courant_dx(scene, dt), remark.c_str());
}

void Stability::print(const StabilityFinding& finding) const {
    const StepLimit& limit = finding.predicted;
    std::printf("%s: %s\n", scene_.title.c_str(), limit.weak && limit.dt > 0 ? "largest step, at which the worst mode grows by e^12 in the run" : "largest stable step");
    if (finding.any_step)
        std::printf("  %-10s no step is stable: at dt %.5g s (c0 dt/dx = %.5g) the worst motion grows by e in %.0f steps (%.3g s); by %s\n", "predicted", finding.any_step->dt,
                    courant_dx(scene_, finding.any_step->dt), std::ceil(1 / finding.any_step->growth), finding.any_step->dt / finding.any_step->growth, finding.basis.c_str());
    else
        print_step(scene_, "predicted", limit.dt, "by " + finding.basis + (finding.inviscid ? ", viscosity at half strength" : ""));
    if (finding.inviscid) print_step(scene_, "", *finding.inviscid, "without viscosity");
    if (finding.always_on) print_step(scene_, "", *finding.always_on, "with viscosity always on");
    if (limit.weak && limit.dt > 0) print_step(scene_, "", limit.mild, "grows by e");
    if (!(finding.measured.dt > 0)) return void(std::printf("  %-10s every step grows, in %d runs of up to %ld steps\n", "measured", finding.measured.runs, trial_.steps));
    char how[120];
    std::snprintf(how, sizeof how, "to %.2g %%, in %d runs of up to %ld steps", 100 * finding.measured.precision, finding.measured.runs, trial_.steps);
    print_step(scene_, "measured", finding.measured.dt, how);
}

void Stability::print(const GrowthFinding& growth) const {
    std::printf("  over %ld steps of %.5g s (c0 dt/dx = %.5g) the worst mode grows\n", growth.steps, growth.dt, courant_dx(scene_, growth.dt));
    std::printf("    predicted  by %.5g a step, e^%.4g in all\n", growth.predicted, growth.predicted * double(growth.steps));
    std::printf("    measured   by %.5g a step, e^%.4g in all\n", growth.measured, growth.measured * double(growth.steps));
}

void Stability::find() {
    const StabilityFinding finding = find_stability(scene_, trial_, report(""));
    result_ = to_json(scene_, finding, trial_);
    if (!options_.json) print(finding);
    if (options_.long_steps == 0) return;
    const double dt = own_step(finding.predicted);
    if (!(dt > 0)) throw Error(Fault::input, scene_.file + ": /integrator", "no step is stable, and none is asked for", "Give dt or courant");
    const GrowthFinding growth = find_growth(scene_, dt, options_.long_steps, trial_);
    result_["long"] = to_json(growth);
    if (!options_.json) print(growth);
}

void Stability::draw_map(const ResultFolder& folder) {
    Json document = read_json(options_.file);
    for (const std::string& assignment : options_.set) set_at(document, assignment);
    std::vector<Varied> varied;
    for (const std::string& text : options_.vary) varied.emplace_back(text);
    StabilityMap map(std::move(document), options_.file, varied, registry_, trial_);
    for (int i = 0; i < map.points(); ++i) {
        const std::string counted = std::to_string(i + 1) + "/" + std::to_string(map.points()) + " " + map.label(i);
        map.find(i, [&](double, const std::string&) { interruptible_.stop_if_asked(scene_.file, "in " + counted + "; nothing was written"); });
        log::info(counted);
    }
    folder.write("table.csv", map.csv());
    if (!draw(map.chart(), folder.path() / "map")) log::warn("gnuplot is not installed: the charts are left as .gp scripts");
}

void Stability::draw_spectrum(const ResultFolder& folder) const {
    const StepTheory theory(scene_);
    const StepLimit limit = theory.limit();
    const double dt = own_step(limit) > 0 ? own_step(limit) : 1 / limit.frequency;
    if (!draw(spectrum_chart(scene_, theory, dt), folder.path() / "spectrum")) log::warn("gnuplot is not installed: the charts are left as .gp scripts");
}

void Stability::refuse_unknown() const {
    if (scene_.method->meshfree()) return;
    const std::string place = scene_.file + ": /method/type", name = "\"" + scene_.method_name + "\"";
    if (options_.long_steps > 0) throw Error(Fault::input, place, name + " tells its limit but not how it grows", "Leave --long out");
    if (options_.spectrum) throw Error(Fault::input, place, name + " does not show its operator", "Leave --spectrum out");
}

void Stability::run() {
    refuse_unknown();
    std::optional<ResultFolder> folder;
    if (writes()) folder.emplace(options_.out.empty() ? ResultFolder::unused(options_.file.stem().string() + "-stability") : options_.out, options_.force);
    if (folder && !options_.vary.empty()) draw_map(*folder);
    if (folder && options_.spectrum) draw_spectrum(*folder);
    find();
    if (folder) {
        folder->write("stability.json", json_text(result_));
        folder->write("resolved.json", json_text(*scene_.resolved));
        folder->commit();
        if (!options_.json) std::printf("  results in %s\n", folder->target().string().c_str());
    }
    if (options_.json) std::cout << json_text(result_);
}

}    // namespace

int stability(const StabilityOptions& options) {
    Stability(options).run();
    return 0;
}

}    // namespace sphonic::driver
