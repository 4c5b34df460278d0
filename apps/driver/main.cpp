#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>

#include <sphonic/error.hpp>
#include <sphonic/log.hpp>
#include <sphonic/version.hpp>

#include "commands.hpp"
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

}    // namespace

int main(int argc, char** argv) {
    wait_passively(argv);
    CLI::App app{"sphonic: meshfree acoustics from plugins and JSON", "sphonic"};
    app.set_version_flag("--version", std::string(sphonic::version()) + " (" + sphonic::commit() + ")");
    app.require_subcommand(1);
    RunOptions options;
    std::string kind, name;
    std::filesystem::path folder;
    int result = 0;

    auto* run_command = app.add_subcommand("run", "run a case, compare it with its reference, write results and charts");
    add_case(*run_command, options, "CASE");
    add_output(*run_command, options);
    run_command->callback([&] { result = run(options); });

    auto* check_command = app.add_subcommand("check", "validate a case and predict its stable step, error and cost; runs nothing");
    add_case(*check_command, options, "CASE");
    check_command->callback([&] { result = check(options); });

    auto* study_command = app.add_subcommand("study", "run a matrix of cases: tables and charts");
    add_case(*study_command, options, "STUDY");
    add_output(*study_command, options);
    study_command->callback([&] { result = study(options); });

    auto* list_command = app.add_subcommand("list", "all plugins found");
    add_common(*list_command, options);
    list_command->callback([&] { result = list(options); });

    auto* describe_command = app.add_subcommand("describe", "a plugin's parameters");
    describe_command->add_option("KIND", kind, "kernel, viscosity, source, ...")->required();
    describe_command->add_option("NAME", name, "cubic_spline, ...")->required();
    add_common(*describe_command, options);
    describe_command->callback([&] { result = describe(options, kind, name); });

    auto* schema_command = app.add_subcommand("schema", "the JSON Schema of a case, with the parameters of all plugins found");
    add_common(*schema_command, options);
    schema_command->callback([&] { result = schema(options); });

    auto* new_command = app.add_subcommand("new", "the source of a new plugin, which builds and works as it is");
    new_command->add_option("KIND", kind, "kernel, viscosity, source, ...")->required();
    new_command->add_option("NAME", name, "lower_snake_case")->required();
    new_command->add_option("--dir", folder, "folder to write to; default plugins/KINDS of the source tree around this folder");
    add_common(*new_command, options);
    new_command->callback([&] { result = new_plugin(options, kind, name, folder); });

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
        sphonic::log::error(std::string("there is no subcommand \"") + argv[1] + "\". Known: run, check, study, list, describe, schema, new");
        return int(sphonic::Fault::input);
    } catch (const CLI::ParseError& e) {
        return app.exit(e, std::cout, std::cerr) == 0 ? 0 : int(sphonic::Fault::input);
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
    return result;
}
