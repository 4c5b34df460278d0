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
        {"fdtd 1", {0.117, 0.137, 0, 1.25, 7.95}},
        {"fdtd 2", {0.0696, 0.148, 0, 1.27, 120}},
        {"fdtd 3", {0, 0.276, 0, 1.08, 289}},
        {"frozen 1", {3.6, 0.669, 1.43, 1.67, 8.44}},
        {"frozen 2", {9.2, 0.935, 1.71, 1.77, 0}},
        {"frozen 3", {0.548, 1.9, 2.01, 0.584, 0}},
        {"frozen_dissipation 1", {0, 4.64, 0, 0, 0}},
        {"frozen_dissipation 2", {0, 6.94, 0, 0, 0}},
        {"frozen_dissipation 3", {0, 10.6, 0, 0, 0}},
        {"frozen_fitted 1", {2.97, 2.81, 0, 0, 0}},
        {"frozen_fitted 2", {21.7, 2.25, 0, 0, 0}},
        {"frozen_fitted 3", {7.24, 3.45, 0, 0, 0}},
        {"kspace 1", {5.77, 0, 0, 0, 17.8}},
        {"kspace 2", {23.4, 0, 0, 0, 0}},
        {"kspace 3", {30.2, 0, 0, 0, 0}},
        {"kspace_modes 1", {2.07, 0, 0, 0, 9.28}},
        {"kspace_modes 2", {1.36, 0, 0, 0, 45.6}},
        {"kspace_modes 3", {1.75, 0, 0, 0, 87.2}},
        {"lattice 1", {0.315, 0.0649, 0.213, 1.84, 35.4}},
        {"lattice 2", {1.15, 0.0591, 0.466, 0.805, 172}},
        {"lattice 3", {3.14, 0.056, 0.635, 3.14, 0}},
        {"lattice_single 1", {0.107, 0.0348, 0, 0.863, 37.1}},
        {"lattice_single 2", {0.591, 0.0325, 0, 0.185, 209}},
        {"lattice_single 3", {1.82, 0.0249, 0, 0.897, 194}},
        {"lattice_single_wide 2", {0.102, 0.0723, 0, 0, 0}},
        {"lattice_single_wide 3", {0, 0.106, 0, 0, 0}},
        {"lattice_wide 2", {0, 0.154, 0, 0, 0}},
        {"lattice_wide 3", {0, 0.172, 0, 0, 0}},
        {"moving 1", {13.4, 2.21, 0.713, 0, 48.2}},
        {"moving 2", {33.9, 2.23, 0.749, 0, 0}},
        {"moving 3", {50.9, 2.9, 0.91, 0, 0}},
        {"moving_densities 1", {22, 3.14, 1.04, 0, 57.9}},
        {"moving_densities 2", {55.2, 2.76, 1.28, 0, 0}},
        {"moving_densities 3", {67.4, 4.3, 1.48, 0, 0}}}};
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
