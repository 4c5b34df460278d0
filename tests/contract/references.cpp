/// References are solutions of linear acoustics, with the u that belongs to their p.
#include <catch2/catch.hpp>

#include <cmath>
#include <sphonic/plugin/abi/reference.hpp>
#include <sphonic/registry.hpp>

using namespace sphonic;

namespace {

struct Field {
    double p = 0, u[3] = {0, 0, 0};
};

Field at(const abi::Reference& reference, int d, double t, const double* x) {
    Field f;
    abi::Points points{.dimension = d, .n = 1};
    abi::AcousticField out{.p = &f.p};
    for (int a = 0; a < d; ++a) points.x[a] = x + a, out.u[a] = f.u + a;
    reference.evaluate(t, points, out);
    return f;
}

}    // namespace

TEST_CASE("travelling and standing waves solve linear acoustics in each dimension", "[reference]") {
    static Registry registry{Registry::search_path()};
    const abi::Medium medium{2, 1.5};
    const double k[3] = {2.1, -1.3, 0.7}, e = 1e-4;
    for (const char* name : {"travelling_wave", "standing_wave"}) {
        const Plugin& plugin = registry.find("reference", name, "test");
        std::vector<abi::Value> values;
        for (int d = 1; d <= 3; ++d) {
            INFO(name << " in " << d << "-D");
            values.clear();
            for (const auto& row : plugin.parameters) {
                values.push_back(row.initial);
                const std::string key = row.name;
                if (key == "amplitude") values.back().real = 3;
                if (key == "phase") values.back().real = 0.4;
                if (key == "wave_number")
                    values.back() = {.type = abi::ParameterType::vector,
                                     .vector = {k[0], d > 1 ? k[1] : 0, d > 2 ? k[2] : 0},
                                     .size = d};
            }
            const auto reference = registry.create<abi::Reference>(plugin, values);
            reference->prepare({.dimension = d, .medium = medium});
            const double t = 0.2, x[3] = {0.31, -0.52, 0.83};
            const Field after = at(*reference, d, t + e, x), before = at(*reference, d, t - e, x),
                        now = at(*reference, d, t, x);
            REQUIRE(std::abs(now.p) > 0.05);
            double divergence = 0;
            for (int a = 0; a < d; ++a) {
                double right[3] = {x[0], x[1], x[2]}, left[3] = {x[0], x[1], x[2]};
                right[a] += e, left[a] -= e;
                const Field r = at(*reference, d, t, right), l = at(*reference, d, t, left);
                CHECK(medium.rho0 * (after.u[a] - before.u[a]) == Approx(-(r.p - l.p)).epsilon(1e-6));
                divergence += r.u[a] - l.u[a];
            }
            CHECK(after.p - before.p == Approx(-medium.rho0 * medium.c0 * medium.c0 * divergence).epsilon(1e-6));
        }
        const auto unfit = registry.create<abi::Reference>(plugin, values);
        CHECK_THROWS_WITH(unfit->prepare({.dimension = 2, .medium = medium}),
                          "wave_number needs one component per dimension");
    }
}
