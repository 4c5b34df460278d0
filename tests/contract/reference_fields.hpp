#pragma once
/// References with their parameters by name, their fields at points, and whether these solve linear acoustics.

#include <map>

#include <sphonic/plugin/abi/reference.hpp>

#include "subjects.hpp"

namespace sphonic::contract {

struct Field {
    double p = 0, u[3] = {0, 0, 0};
};

inline Field at(const abi::Reference& reference, int d, double t, const double* x) {
    Field f;
    abi::Points points{.dimension = d, .n = 1};
    abi::AcousticField out{.p = &f.p};
    for (int a = 0; a < d; ++a) points.x[a] = x + a, out.u[a] = f.u + a;
    reference.evaluate(t, points, out);
    return f;
}

inline abi::Value vector_of(int d, const double* x) {
    return {.type = abi::ParameterType::vector, .vector = {x[0], d > 1 ? x[1] : 0, d > 2 ? x[2] : 0}, .size = d};
}
inline abi::Value vector_of(const std::vector<double>& x) { return vector_of(int(x.size()), x.data()); }
inline abi::Value real_of(double x) { return {.type = abi::ParameterType::real, .real = x}; }
inline abi::Value text_of(const char* text) { return {.type = abi::ParameterType::text, .text = text}; }

using Given = std::map<std::string, abi::Value>;

/// Not prepared; what is not given is at its default.
inline std::unique_ptr<abi::Reference> reference_with(const std::string& name, const Given& given) {
    const Plugin& plugin = registry().find("reference", name, "contract");
    std::vector<abi::Value> values;
    std::size_t known = 0;
    for (const auto& row : plugin.parameters) {
        const auto found = given.find(row.name);
        known += found != given.end();
        values.push_back(found != given.end() ? found->second : row.initial);
    }
    REQUIRE(known == given.size());
    return registry().create<abi::Reference>(plugin, values);
}

/// rho0 du/dt = -grad p and dp/dt = -rho0 c0^2 div u, by central differences: to a millionth of them, or of those of a wave whose
/// pressure changes by `steepest` [Pa/m] where one is given.
inline void check_acoustics(const abi::Reference& reference, const abi::Medium& medium, int d, double t, const double* x, double steepest = 0) {
    const double e = 1e-4;
    const auto close = [&](double value) { return Approx(value).epsilon(1e-6).scale(2 * e * steepest); };
    const Field after = at(reference, d, t + e, x), before = at(reference, d, t - e, x);
    double divergence = 0;
    for (int a = 0; a < d; ++a) {
        double right[3] = {0, 0, 0}, left[3] = {0, 0, 0};
        std::copy(x, x + d, right), std::copy(x, x + d, left);
        right[a] += e, left[a] -= e;
        const Field r = at(reference, d, t, right), l = at(reference, d, t, left);
        CHECK(medium.rho0 * (after.u[a] - before.u[a]) == close(-(r.p - l.p)));
        divergence += r.u[a] - l.u[a];
    }
    CHECK(after.p - before.p == close(-medium.rho0 * medium.c0 * medium.c0 * divergence));
}

}    // namespace sphonic::contract
