#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sphonic/json.hpp>
#include <sphonic/registry.hpp>

namespace sphonic {

struct PlanRequest {
    double target = 0.01;    ///< relative L2 of p
    bool free = false;       ///< open all that can be, whatever the case says of it
    double budget_s = 60;    ///< CPU time for runs that judge or confirm [s]
};

struct Decision {
    std::string what;     ///< JSON pointer
    Json value;
    std::string why;
    std::string saves;    ///< against the cheapest that decides otherwise; empty where nothing was compared
};

/// A model of the scene with what theory, or else a run, says of it.
struct Rung {
    std::string name;
    std::optional<double> l2;
    double cpu_s = 0;    ///< predicted
};

struct Plan {
    Json document;                      ///< the case, with nothing left open
    std::vector<Decision> decisions;
    std::vector<Rung> ladder;           ///< from the case as it was given to the planned one, each with one change more; empty if it was left open
    std::vector<Rung> families;         ///< the cheapest of each that meets the target
    double l2 = 0, cpu_s = 0;           ///< predicted
    std::string basis;                  ///< of l2
    std::optional<double> measured_l2, measured_cpu_s;    ///< by a run of the planned case, where the budget allowed one
    std::vector<std::string> warnings;
};

/// Fills all that a case leaves open, or marks "auto", of method, kernel, equations, integrator and /particles/dx with what costs
/// least CPU time at an L2 error of at most the target, and drops axes along which nothing changes. The error is the larger one of two
/// moments, the end and 0.93 of it: theory's where there is one, else a run's beside the case's reference, else beside a fine run, else a
/// factor times the difference from a run of half the spacing. An input error names what came nearest if nothing meets the target.
Plan make_plan(const Json& document, const std::filesystem::path& file, const PlanRequest& request, Registry& registry);

/// What "accuracy" of a case asks for.
PlanRequest plan_request(const Json& document, const std::filesystem::path& file);

}    // namespace sphonic
