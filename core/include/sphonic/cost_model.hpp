#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include <sphonic/json_fwd.hpp>
#include <sphonic/registry.hpp>

namespace sphonic {

/// What a particle costs in one evaluation of all equations, in one tier and dimension. `fixed` and `per_neighbour` are of sets
/// in the caches; in memory a lattice's particle or a listed pair costs `from_memory` more.
struct UnitCost {
    double fixed = 0, per_neighbour = 0;    ///< [ns]
    double viscous = 0;                     ///< more per neighbour with Monaghan's viscosity [ns]
    double from_memory = 0;                 ///< [ns]
    double call = 0;                        ///< of a call for rates, or of a grid's step, however few the particles are [ns]
};

/// What sets cost on a machine.
struct CostModel {
    std::string machine;     ///< its processor
    double cache = 32e6;     ///< of the last level [bytes]
    std::map<std::string, UnitCost> units;    ///< by tier and dimension: "lattice 2"

    /// Of a tier in `dimension`, or in the nearest one that is known; null if there is none.
    const UnitCost* find(const std::string& tier, int dimension) const;
};

/// Figures of the machine that the project's tables come from.
const CostModel& reference_costs();

/// Measures this machine on one thread, in some seconds; `progress` is told the share that is done.
CostModel calibrate(Registry& registry, const std::function<void(double)>& progress = {});

/// Where calibrated costs are kept: $XDG_CACHE_HOME/sphonic/costs.json, by default in ~/.cache.
std::filesystem::path costs_file();
void save_costs(const CostModel& costs, const std::filesystem::path& file);
/// What a file holds; nothing if there is none, or if it is of another machine or program version, or damaged.
std::optional<CostModel> load_costs(const std::filesystem::path& file);

/// Calibrated costs of this machine if there are any, else the reference's. Read once in a process.
const CostModel& present_costs();

Json to_json(const CostModel& costs);

}    // namespace sphonic
