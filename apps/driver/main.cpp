#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>

#include <sphonic/error.hpp>
#include <sphonic/log.hpp>
#include <sphonic/version.hpp>

#include "commands.hpp"
#include "interruption.hpp"
#include "threads.hpp"

namespace {

using namespace sphonic::driver;

void add_common(CLI::App& command, Common& options) {
    command.add_option("--plugin-path", options.plugin_path, "folder with more plugins (may be repeated)");
    command.add_flag("--json", options.json, "print the result as JSON on stdout");
}

void add_case(CLI::App& command, RunOptions& options, const char* what) {
    command.add_option(what, options.file, "JSON file")->required();
    command.add_option("--set", options.set, "override a value: /json/pointer=value (may be repeated)");
    add_common(command, options);
}

void add_output(CLI::App& command, RunOptions& options) {
    command.add_option("--out", options.out, "output folder; default runs/NAME");
    command.add_flag("--force", options.force, "replace the output folder if it exists");
    command.add_option("--threads", options.threads, "results do not depend on it; default: as many as the set is worth")->check(CLI::Range(1, 1024));
}

/// What the command line says, and the exit code of what it asked for.
struct Arguments {
    RunOptions options;
    StudyOptions study;
    StabilityOptions stability;
    PlanOptions planning;
    DescribeOptions described;
    KernelOptions card;
    AtlasOptions atlas;
    std::string kind, name, schema = "case";
    std::filesystem::path folder;
    int result = 0;
};

void add_case_commands(CLI::App& app, Arguments& a) {
    auto* run_command = app.add_subcommand("run", "run a case, compare it with its reference, write results and charts");
    add_case(*run_command, a.options, "CASE");
    add_output(*run_command, a.options);
    run_command->callback([&a] { a.result = run(a.options); });

    auto* check_command = app.add_subcommand("check", "validate a case and predict its stable step, error and cost; runs nothing");
    add_case(*check_command, a.options, "CASE");
    check_command->callback([&a] { a.result = check(a.options); });
}

void add_study_command(CLI::App& app, Arguments& a) {
    StudyOptions& options = a.study;
    auto* command = app.add_subcommand("study", "run a matrix of cases: tables, charts and a report; goes on where it was interrupted");
    add_case(*command, options, "STUDY");
    add_output(*command, options);
    command->add_flag("--report", options.report, "write report.html too: charts, ranked table and an interactive chart on one page");
    command->add_option("--jobs", options.jobs, "points side by side, each a process; times are then marked as in doubt")->check(CLI::Range(1, 1024));
    auto* launcher = command->add_option("--launcher", options.launcher, "run nothing: write the points as jobs of GNU parallel or as a Slurm array")
        ->check(CLI::IsMember({"parallel", "slurm"}));
    auto* point = command->add_option("--point", options.point, "run only this point, counted from 1; for launchers")->check(CLI::Range(1, 10000))->excludes(launcher);
    command->add_flag("--beside", options.beside, "with --point: others run at the same time")->needs(point);
    auto* collect = command->add_flag("--collect", options.collect, "run nothing: tables and charts of what the output folder holds")->excludes(launcher)->excludes(point);
    collect->needs(command->get_option("--out"));
    command->callback([&a] { a.result = study(a.study); });
}

void add_plan_command(CLI::App& app, Arguments& a) {
    PlanOptions& options = a.planning;
    auto* command = app.add_subcommand("plan", "the cheapest model of a scene that meets an accuracy, each decision with its reason");
    add_case(*command, options, "CASE");
    command->add_option("--target", options.target, "relative L2 error to stay below; default: the case's /accuracy/target, else 0.01")->check(CLI::Range(1e-6, 0.999));
    command->add_option("--norm", options.norm, "of the error")->check(CLI::IsMember({"l2"}))->capture_default_str();
    command->add_flag("--free", options.free, "decide anew what the case gives of method, kernel, equations, viscosity, spacing, motion and step");
    command->add_option("--budget", options.budget_s, "CPU seconds for runs that judge or confirm")->check(CLI::Range(0.0, 1e6))->capture_default_str();
    command->add_option("--out", options.out, "file for the planned case; default: printed");
    command->add_flag("--force", options.force, "replace that file if it exists");
    command->callback([&a] { a.result = plan(a.planning); });
}

void add_stability_command(CLI::App& app, Arguments& a) {
    StabilityOptions& options = a.stability;
    auto* command = app.add_subcommand("stability", "the largest stable step of a case by theory and by bisection; maps and spectra");
    auto* table = command->add_flag("--table", options.table, "no case: predicted and measured limits of all kernels, widths, integrators and dimensions, in minutes");
    auto* scene = command->add_option("CASE", options.file, "JSON file")->excludes(table);
    command->add_option("--set", options.set, "override a value: /json/pointer=value (may be repeated)")->needs(scene);
    add_common(*command, options);
    command->add_option("--vary", options.vary, "/pointer=a:b:n: a table and a chart over n values from a to b; twice: a map");
    command->add_flag("--spectrum", options.spectrum, "draw the eigenvalues in the integrator's stability region");
    command->add_option("--long", options.long_steps, "growth over so many steps at the case's own step, beside ln |xi|")->check(CLI::Range(10L, 100000000L));
    command->add_option("--steps", options.steps, "of a run that decides whether a step is stable")->check(CLI::Range(100L, 100000000L))->capture_default_str();
    command->add_option("--precision", options.precision, "of the bisection, relative")->check(CLI::Range(1e-6, 0.1))->capture_default_str();
    command->add_option("--seed", options.seed, "of the noise that sets runs off")->check(CLI::Range(0, 1000000000))->capture_default_str();
    command->add_option("--out", options.out, "output folder; default runs/NAME-stability if there is a chart");
    command->add_flag("--force", options.force, "replace the output folder if it exists");
    command->callback([&a] {
        if (!a.stability.table && a.stability.file.empty()) throw CLI::RequiredError("CASE");
        a.result = a.stability.table ? stability_table(a.stability) : stability(a.stability);
    });
}

void add_atlas_command(CLI::App& app, Arguments& a) {
    AtlasOptions& options = a.atlas;
    auto* command = app.add_subcommand("atlas", "run the failures of methods and their cures, and draw them on one page");
    command->add_option("FOLDER", options.folder, "of cases, with studies/atlas.json")->capture_default_str();
    command->add_option("--row", options.rows, "one row by its name (may be repeated); default: all");
    command->add_option("--out", options.out, "output folder; default runs/atlas");
    command->add_flag("--force", options.force, "replace the output folder if it exists");
    add_common(*command, options);
    command->callback([&a] { a.result = atlas(a.atlas); });
}

void add_calibrate_command(CLI::App& app, Arguments& a) {
    auto* command = app.add_subcommand("calibrate", "measure what steps cost on this machine, for predictions of CPU time");
    add_common(*command, a.described);
    command->callback([&a] { a.result = calibrate(a.described); });
}

void add_plugin_commands(CLI::App& app, Arguments& a) {
    auto* list_command = app.add_subcommand("list", "all plugins found");
    add_common(*list_command, a.options);
    list_command->callback([&a] { a.result = list(a.options); });

    auto* describe_command = app.add_subcommand("describe", "plugins and their parameters: all, those of a kind, or one");
    describe_command->add_option("KIND", a.described.kind, "kernel, viscosity, source, ...");
    describe_command->add_option("NAME", a.described.name, "cubic_spline, ...");
    add_common(*describe_command, a.described);
    describe_command->add_flag("--markdown", a.described.markdown, "print GitHub Markdown")->excludes("--json");
    describe_command->callback([&a] { a.result = describe(a.described); });

    auto* kernel_command = app.add_subcommand("kernel", "a kernel's report card: laws, pairing, waves and steps on lattices, a ranking");
    kernel_command->add_option("NAME", a.card.name, "cubic_spline, ...")->required();
    kernel_command->add_option("--compare", a.card.compare, "rank and draw it beside these");
    kernel_command->add_option("--dimension", a.card.dimension, "of the ranking")->check(CLI::Range(1, 3));
    kernel_command->add_option("--out", a.card.out, "folder for the card as HTML, PNG and SVG; default: none are written");
    kernel_command->add_flag("--force", a.card.force, "replace the output folder if it exists");
    add_common(*kernel_command, a.card);
    kernel_command->callback([&a] { a.result = kernel(a.card); });

    auto* schema_command = app.add_subcommand("schema", "the JSON Schema of a case, with the parameters of all plugins found, or of a study");
    schema_command->add_option("WHAT", a.schema, "case (default) or study")->check(CLI::IsMember({"case", "study"}));
    add_common(*schema_command, a.options);
    schema_command->callback([&a] { a.result = schema(a.options, a.schema); });

    auto* new_command = app.add_subcommand("new", "the source of a new plugin, which builds and works as it is");
    new_command->add_option("KIND", a.kind, "kernel, viscosity, source, ...")->required();
    new_command->add_option("NAME", a.name, "lower_snake_case")->required();
    new_command->add_option("--dir", a.folder, "folder to write to; default plugins/KINDS of the source tree around this folder");
    add_common(*new_command, a.options);
    new_command->callback([&a] { a.result = new_plugin(a.options, a.kind, a.name, a.folder); });
}

}    // namespace

int main(int argc, char** argv) {
    wait_passively(argv);
    CLI::App app{"sphonic: meshfree acoustics from plugins and JSON", "sphonic"};
    app.set_version_flag("--version", std::string(sphonic::version()) + " (" + sphonic::commit() + ")");
    app.require_subcommand(1);
    Arguments arguments;
    add_case_commands(app, arguments);
    add_plan_command(app, arguments);
    add_study_command(app, arguments);
    add_stability_command(app, arguments);
    add_atlas_command(app, arguments);
    add_calibrate_command(app, arguments);
    add_plugin_commands(app, arguments);
    try {
        app.parse(argc, argv);
        std::cout.flush();
        if (!std::cout || std::fflush(stdout) != 0)
            throw sphonic::Error(sphonic::Fault::io, "stdout", "the result cannot be written", "Check where it goes");
    } catch (const CLI::RequiredError& e) {
        if (!app.get_subcommands().empty() || argc < 2 || argv[1][0] == '-') {
            app.exit(e, std::cout, std::cerr);
            return int(sphonic::Fault::input);
        }
        sphonic::log::error(std::string("there is no subcommand \"") + argv[1] + "\". Known: run, check, plan, study, stability, atlas, calibrate, list, describe, kernel, schema, new");
        return int(sphonic::Fault::input);
    } catch (const CLI::ParseError& e) {
        return app.exit(e, std::cout, std::cerr) == 0 ? 0 : int(sphonic::Fault::input);
    } catch (const Interruption& e) {
        sphonic::log::error(e.what());
        return e.exit_code();
    } catch (const sphonic::Error& e) {
        sphonic::log::error(e.what());
        return int(e.fault);
    } catch (const std::bad_alloc&) {
        sphonic::log::error("memory: there is not enough for this set. Choose a larger dx or a smaller box");
        return int(sphonic::Fault::input);
    } catch (const std::exception& e) {
        sphonic::log::error(std::string("internal: ") + e.what());
        return 1;
    }
    return arguments.result;
}
