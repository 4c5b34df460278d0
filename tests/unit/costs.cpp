#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <random>

#include <sphonic/cost_model.hpp>
#include <sphonic/json.hpp>

#include "cost.hpp"
#include "machine.hpp"

using namespace sphonic;

namespace {

std::filesystem::path scratch() { return std::filesystem::temp_directory_path() / ("sphonic_costs_" + std::to_string(std::random_device{}())); }

}    // namespace

TEST_CASE("the cost of a step follows particles, neighbours, evaluations and memory", "[cost]") {
    const CostModel costs{.machine = "", .cache = 32e6, .units = {{"lattice 2", {1, 0.1, 0.2, 3, 50}}}};
    const Work small{.tier = "lattice", .dimension = 2, .particles = 1e5, .neighbours = 20};
    const double base = step_cost(costs, small);
    CHECK(base == Approx(1e5 * (1 + 0.1 * 20)).epsilon(0.01));
    const auto with = [&](auto change) {
        Work work = small;
        change(work);
        return step_cost(costs, work) / base;
    };
    CHECK(with([](Work& w) { w.particles *= 2; }) == Approx(2).epsilon(0.01));
    CHECK(with([](Work& w) { w.viscous = true; }) == Approx(7.0 / 3).epsilon(0.01));
    CHECK(with([](Work& w) { w.evaluations = 4; }) == Approx(4).epsilon(0.01));
    CHECK(with([](Work& w) { w.neighbours = 40; }) == Approx(5.0 / 3).epsilon(0.01));
    CHECK(with([](Work& w) { w.particles *= 100; }) == Approx(100 * 2).epsilon(0.01));    // 240 MB
    CHECK(step_cost(costs, {.tier = "lattice", .dimension = 2, .particles = 0, .calls = 4}) == Approx(200));
    CHECK(costs.find("lattice", 3) != nullptr);
    CHECK(costs.find("frozen", 2) == nullptr);
}

TEST_CASE("calibrated costs are kept for this machine, and only for it", "[cost]") {
    const auto folder = scratch(), file = folder / "costs.json";
    CHECK_FALSE(load_costs(file));
    CostModel costs = reference_costs();
    costs.machine = processor();
    save_costs(costs, file);
    const auto read = load_costs(file);
    REQUIRE(read);
    CHECK(to_json(*read) == to_json(costs));
    costs.machine += " of another kind";
    save_costs(costs, file);
    CHECK_FALSE(load_costs(file));
    std::ofstream(file) << "{\"machine\": ";
    CHECK_FALSE(load_costs(file));
    std::filesystem::remove_all(folder);
}

TEST_CASE("there are costs of every tier", "[cost]") {
    for (const char* tier : {"lattice", "lattice_wide", "lattice_single", "lattice_single_wide", "frozen", "frozen_dissipation", "frozen_fitted", "moving", "moving_densities", "fdtd", "kspace", "kspace_modes"}) {
        INFO(tier);
        CHECK(reference_costs().find(tier, 3) != nullptr);
    }
}
