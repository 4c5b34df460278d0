#include <sphonic/cost_model.hpp>

#include <cstdlib>
#include <utility>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/result_folder.hpp>
#include <sphonic/version.hpp>

#include "machine.hpp"

namespace fs = std::filesystem;

namespace sphonic {

const UnitCost* CostModel::find(const std::string& tier, int dimension) const {
    for (const int d : {dimension, 2, dimension + 1, dimension - 1})
        if (const auto found = units.find(tier + " " + std::to_string(d)); found != units.end()) return &found->second;
    return nullptr;
}

/// Medians of five calibrations on one core of a shared machine.
const CostModel& reference_costs() {
    static const CostModel costs{.machine = "AMD EPYC with AVX-512, 2.6 GHz", .cache = 34e6, .units = {
        {"fdtd 1", {0.051, 0.13, 0, 0.74}},
        {"fdtd 2", {0.0859, 0.12, 0, 0.715}},
        {"fdtd 3", {0, 0.198, 0, 1.11}},
        {"frozen 1", {3.01, 0.813, 1.3, 0.312}},
        {"frozen 2", {7.41, 1.05, 1.53, 0.79}},
        {"frozen 3", {9.28, 1.43, 1.57, 1.24}},
        {"kspace 2", {26.4, 0, 0, 0}},
        {"kspace_modes 2", {1.37, 0, 0, 0}},
        {"lattice 1", {0.192, 0.097, 0.177, 0.171}},
        {"lattice 2", {1.07, 0.0816, 0.377, 0.658}},
        {"lattice 3", {3.32, 0.0822, 0.694, 2.94}},
        {"lattice_single 1", {0.106, 0.0513, 0, 0.0505}},
        {"lattice_single 2", {0.631, 0.043, 0, 0.133}},
        {"lattice_single 3", {2.75, 0.0528, 0, 0.0647}},
        {"moving 1", {14.2, 1.85, 0.512, 0}},
        {"moving 2", {29.4, 1.71, 0.886, 0}},
        {"moving 3", {37.1, 2.68, 0.862, 0}},
        {"moving_densities 1", {21.7, 2.56, 0.871, 0}},
        {"moving_densities 2", {42.7, 2.91, 0.679, 0}},
        {"moving_densities 3", {50.7, 3.79, 0.844, 0}}}};
    return costs;
}

fs::path costs_file() {
    const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
    const fs::path folder = cache && *cache ? fs::path(cache) : fs::path(home ? home : ".") / ".cache";
    return folder / "sphonic" / "costs.json";
}

Json to_json(const CostModel& costs) {
    Json units = Json::object();
    for (const auto& [tier, c] : costs.units)
        units[tier] = {{"fixed_ns", c.fixed}, {"per_neighbour_ns", c.per_neighbour}, {"viscous_ns", c.viscous}, {"from_memory_ns", c.from_memory}, {"call_ns", c.call}};
    return {{"machine", costs.machine}, {"commit", commit()}, {"cache_bytes", costs.cache}, {"units", units}};
}

void save_costs(const CostModel& costs, const fs::path& file) {
    std::error_code failed;
    fs::create_directories(file.parent_path(), failed);
    if (failed) throw Error(Fault::io, file.parent_path().string(), "cannot be created: " + failed.message(), "Set XDG_CACHE_HOME to a folder that can be written");
    const fs::path part = file.string() + ".part";
    write_file(part, json_text(to_json(costs)));
    fs::rename(part, file);
}

std::optional<CostModel> load_costs(const fs::path& file) try {
    if (!fs::exists(file)) return std::nullopt;
    const Json document = read_json(file);
    CostModel costs{.machine = document.at("machine"), .cache = document.at("cache_bytes"), .units = {}};
    if (costs.machine != processor() || document.at("commit") != commit()) return std::nullopt;
    for (const auto& [tier, c] : document.at("units").items())
        costs.units[tier] = {c.at("fixed_ns"), c.at("per_neighbour_ns"), c.at("viscous_ns"), c.at("from_memory_ns"), c.at("call_ns")};
    return costs;
} catch (const Json::exception&) {
    return std::nullopt;
} catch (const Error&) {
    return std::nullopt;
}

const CostModel& present_costs() {
    static const std::optional<CostModel> calibrated = load_costs(costs_file());
    return calibrated ? *calibrated : reference_costs();
}

}    // namespace sphonic
