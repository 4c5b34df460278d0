#include <cstdio>
#include <fstream>
#include <iostream>

#include <sphonic/error.hpp>
#include <sphonic/log.hpp>
#include <sphonic/plan.hpp>

#include "commands.hpp"
#include "planned.hpp"

namespace sphonic::driver {
namespace {

Json rungs_json(const std::vector<Rung>& rungs) {
    Json list = Json::array();
    for (const Rung& rung : rungs) list.push_back({{"name", rung.name}, {"l2", rung.l2 ? Json(*rung.l2) : Json(nullptr)}, {"cpu_s", rung.cpu_s}});
    return list;
}

Json plan_json(const Plan& plan) {
    Json decisions = Json::array();
    for (const Decision& d : plan.decisions) decisions.push_back({{"what", d.what}, {"value", d.value}, {"why", d.why}, {"saves", d.saves}});
    Json measured = nullptr;
    if (plan.measured_l2) measured = {{"l2", *plan.measured_l2}, {"cpu_s", *plan.measured_cpu_s}};
    return {{"case", plan.document}, {"decisions", decisions}, {"predicted", {{"l2", plan.l2}, {"cpu_s", plan.cpu_s}, {"basis", plan.basis}}},
            {"measured", measured}, {"ladder", rungs_json(plan.ladder)}, {"families", rungs_json(plan.families)}, {"warnings", plan.warnings}};
}

void print_rungs(const char* title, const std::vector<Rung>& rungs) {
    if (rungs.empty()) return;
    std::printf("  %s\n", title);
    for (const Rung& rung : rungs)
        if (rung.l2)
            std::printf("    %-64s L2 %-10.3g %.3g s\n", rung.name.c_str(), *rung.l2, rung.cpu_s);
        else
            std::printf("    %-64s L2 unknown    %.3g s\n", rung.name.c_str(), rung.cpu_s);
}

void write_case(const Json& document, const std::filesystem::path& file, bool force) {
    if (std::filesystem::exists(file) && !force) throw Error(Fault::input, file.string(), "it exists", "Choose another --out, or --force to replace it");
    std::ofstream stream(file);
    stream << json_text(document) << std::flush;
    if (!stream) throw Error(Fault::io, file.string(), "it cannot be written", "Check the folder");
}

void print_decisions(const Plan& plan) {
    for (const Decision& d : plan.decisions) {
        std::printf("  %s = %s\n    %s\n", d.what.c_str(), d.value.dump().c_str(), d.why.c_str());
        if (!d.saves.empty()) std::printf("    otherwise %s\n", d.saves.c_str());
    }
}

}    // namespace

int plan(const PlanOptions& options) {
    Registry registry(Registry::search_path(options.plugin_path));
    Json document = read_json(options.file);
    for (const std::string& assignment : options.set) set_at(document, assignment);
    PlanRequest request;
    if (document.is_object() && document.contains("accuracy")) request = plan_request(document, options.file);
    if (options.target > 0) request.target = options.target;
    request.free = options.free;
    request.budget_s = options.budget_s;
    const Plan plan = make_plan(document, options.file, request, registry);
    if (!options.out.empty()) write_case(plan.document, options.out, options.force);
    for (const std::string& warning : plan.warnings) log::warn(options.file.string() + ": " + warning);
    if (options.json) {
        std::cout << json_text(plan_json(plan));
        return 0;
    }
    std::printf("%s to an L2 error of %g\n", options.file.string().c_str(), request.target);
    print_decisions(plan);
    print_rungs("from the case as given, each with one change more:", plan.ladder);
    print_rungs("the cheapest of each family that meets the target:", plan.families);
    std::printf("  predicted: L2 %.3g (%s), %.3g s of CPU\n", plan.l2, plan.basis.c_str(), plan.cpu_s);
    if (plan.measured_l2) std::printf("  confirmed by a run: L2 %.3g, %.3g s of CPU\n", *plan.measured_l2, *plan.measured_cpu_s);
    if (options.out.empty())
        std::cout << json_text(plan.document);
    else
        std::printf("  written to %s\n", options.out.string().c_str());
    return 0;
}

Case load_planned(const std::filesystem::path& file, const std::vector<std::string>& set, Registry& registry) {
    Json document = read_json(file);
    for (const std::string& assignment : set) set_at(document, assignment);
    if (!document.is_object() || !document.contains("accuracy")) return load_case(std::move(document), file, registry);
    const Plan plan = make_plan(document, file, plan_request(document, file), registry);
    for (const std::string& warning : plan.warnings) log::warn(file.string() + ": " + warning);
    for (const Decision& d : plan.decisions) log::info(file.string() + ": " + d.what + " = " + d.value.dump() + ": " + d.why);
    return load_case(plan.document, file, registry);
}

}    // namespace sphonic::driver
