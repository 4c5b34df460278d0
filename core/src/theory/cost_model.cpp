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
    static const CostModel costs{.machine = "Intel Xeon with AVX-512, 2.6 GHz", .cache = 40e6, .units = {
        {"fdtd 1", {0.123, 0.139, 0, 0.899, 3.43}},
        {"fdtd 2", {0.0867, 0.143, 0, 0.912, 47.3}},
        {"fdtd 3", {0, 0.194, 0, 1.22, 56.7}},
        {"frozen 1", {3.71, 0.69, 1.56, 1.46, 3.72}},
        {"frozen 2", {11.9, 0.904, 1.76, 1.44, 0}},
        {"frozen 3", {0, 1.85, 2.04, 0.897, 0}},
        {"frozen_dissipation 1", {0, 4.81, 0, 0, 0}},
        {"frozen_dissipation 2", {1.69, 6.81, 0, 0, 0}},
        {"frozen_dissipation 3", {0, 10.8, 0, 0, 0}},
        {"frozen_fitted 1", {4.02, 2.65, 0, 0, 0}},
        {"frozen_fitted 2", {24, 2.26, 0, 0, 0}},
        {"frozen_fitted 3", {4.05, 3.39, 0, 0, 0}},
        {"frozen_runs 1", {0.654, 0.125, 0, 0, 119}},
        {"frozen_runs 2", {1.65, 0.276, 0, 0, 0}},
        {"frozen_runs 3", {6.21, 0.405, 0, 0, 0}},
        {"kspace 1", {5.99, 0, 0, 0, 20.5}},
        {"kspace 2", {23.1, 0, 0, 0, 0}},
        {"kspace 3", {29.5, 0, 0, 0, 0}},
        {"kspace_modes 1", {2.06, 0, 0, 0, 12.5}},
        {"kspace_modes 2", {1.33, 0, 0, 0, 49.7}},
        {"kspace_modes 3", {1.81, 0, 0, 0, 97.1}},
        {"lattice 1", {0.307, 0.0671, 0.242, 1.63, 34.7}},
        {"lattice 2", {1.07, 0.0634, 0.465, 0.549, 115}},
        {"lattice 3", {2.58, 0.0505, 0.557, 3.37, 0}},
        {"lattice_single 1", {0.121, 0.0362, 0, 0.892, 37.9}},
        {"lattice_single 2", {0.598, 0.0319, 0, 0.295, 169}},
        {"lattice_single 3", {1.6, 0.0221, 0, 1.42, 101}},
        {"lattice_single_wide 2", {0.332, 0.07, 0, 0, 0}},
        {"lattice_single_wide 3", {0, 0.0919, 0, 0, 0}},
        {"lattice_wide 2", {0, 0.158, 0, 0, 0}},
        {"lattice_wide 3", {0, 0.157, 0, 0, 0}},
        {"moving 1", {14.5, 2.32, 0.761, 0, 68.2}},
        {"moving 2", {31.4, 2.51, 0.708, 0, 0}},
        {"moving 3", {45.1, 3.12, 0.964, 0, 0}},
        {"moving_densities 1", {22.7, 3.11, 1.23, 0, 64.7}},
        {"moving_densities 2", {53.9, 3.09, 0.788, 0, 0}},
        {"moving_densities 3", {65.3, 4.23, 1.14, 0, 0}}}};
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
