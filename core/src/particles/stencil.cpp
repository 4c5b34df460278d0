#include "stencil.hpp"

#include <cmath>

#include <sphonic/error.hpp>

#include "correction.hpp"

namespace sphonic {

std::vector<Offset> lattice_neighbours(const abi::Box& box, const KernelUse& use) {
    const double radius = use.radius();
    const int reach = int(std::floor(radius / box.dx));
    const int ry = box.dimension > 1 ? reach : 0, rz = box.dimension > 2 ? reach : 0;
    std::vector<Offset> found;
    std::vector<double> r;
    for (int k = -rz; k <= rz; ++k)
        for (int j = -ry; j <= ry; ++j)
            for (int i = -reach; i <= reach; ++i) {
                const double r2 = double(i * i + j * j + k * k) * box.dx * box.dx;
                if (r2 == 0 || r2 >= radius * radius) continue;
                found.push_back({.o = {i, j, k}, .r2 = r2});
                r.push_back(std::sqrt(r2));
            }
    std::vector<double> slope(r.size());
    use.kernel->evaluate(box.dimension, int(r.size()), r.data(), use.h, nullptr, slope.data());
    std::vector<Offset> kept;
    for (std::size_t n = 0; n < found.size(); ++n) {
        if (slope[n] == 0) continue;
        found[n].slope = slope[n];
        for (int a = 0; a < 3; ++a) found[n].gradient[a] = -slope[n] * found[n].o[a] * box.dx;    // r_ij = -o dx
        kept.push_back(found[n]);
    }
    return kept;
}

std::vector<Offset> half_neighbours(const std::vector<Offset>& all) {
    std::vector<Offset> half;
    for (const Offset& n : all) {
        const int leading = n.o[2] ? n.o[2] : n.o[1] ? n.o[1] : n.o[0];
        if (leading > 0) half.push_back(n);
    }
    return half;
}

RestCoefficients rest_coefficients(const abi::Form& form, abi::Derivative derivative, const abi::Medium& i, const abi::Medium& j) {
    RestCoefficients c{};
    const double inverse_i = 1 / i.rho0, inverse_j = 1 / j.rho0, Z_i = i.rho0 * i.c0, Z_j = j.rho0 * j.c0;
    form.coefficients(derivative, {1, &i.rho0, &j.rho0, &inverse_i, &inverse_j, &Z_i, &Z_j}, &c.own, &c.other);
    return c;
}

abi::Derivative derivative(const Term& term) {
    return term.op == Term::Operator::gradient ? abi::Derivative::gradient : abi::Derivative::divergence;
}

namespace {

/// Both of each pair o, -o, in the order of lattice_neighbours.
std::vector<Offset> fitted_neighbours(const Case& scene, const LatticeWeights& fitted) {
    std::vector<Offset> all;
    const auto add = [&](std::size_t n, int sign) {
        Offset offset;
        for (std::size_t a = 0; a < 3; ++a) {
            offset.o[a] = sign * fitted.offset[n][a];
            offset.r2 += std::pow(offset.o[a] * scene.box.dx, 2);
            offset.gradient[a] = fitted.weight[n] * offset.o[a] / scene.box.dx;
        }
        all.push_back(offset);
    };
    for (std::size_t n = fitted.offset.size(); n-- > 0;) add(n, -1);
    for (std::size_t n = 0; n < fitted.offset.size(); ++n) add(n, 1);
    return all;
}

}    // namespace

std::vector<Offset> weighted_neighbours(const Case& scene, const Term& term, std::vector<Offset> neighbours, int medium) {
    if (!term.fitted.empty()) return fitted_neighbours(scene, *term.fitted[std::size_t(medium)]);
    const double volume = lattice_volume(scene.box), dx = scene.box.dx;
    Moment moment(scene.box.dimension);
    for (const Offset& n : neighbours) {
        const double r[3] = {-n.o[0] * dx, -n.o[1] * dx, -n.o[2] * dx};
        moment.add(r, volume * n.slope);
    }
    const bool plain = term.form && term.form->correction() == abi::Correction::none;
    const auto L = plain ? std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1} : moment.inverse();
    if (!L)
        throw Error(Fault::input, scene.file + ": /kernel", "the " + std::to_string(neighbours.size()) +
                    " neighbours of a particle do not determine a gradient, which a corrected form needs", "Choose a larger h");
    for (Offset& n : neighbours) {
        const double plain[3] = {n.gradient[0], n.gradient[1], n.gradient[2]};
        for (std::size_t a = 0; a < 3; ++a) n.gradient[a] = volume * ((*L)[3 * a] * plain[0] + (*L)[3 * a + 1] * plain[1] + (*L)[3 * a + 2] * plain[2]);
    }
    return neighbours;
}

std::vector<double> rest_couplings(const abi::Dissipation& dissipation, const Case& scene, const KernelUse& kernel, const std::vector<Offset>& pairs) {
    std::vector<double> a, r2, slope;
    for (const Offset& n : pairs) {
        r2.push_back(n.r2);
        slope.push_back(n.slope);
    }
    a.resize(pairs.size());
    dissipation.couple({.n = int(pairs.size()), .r2 = r2.data(), .slope = slope.data(), .h = kernel.h, .c = scene.medium.c0,
                        .volume = lattice_volume(scene.box)}, a.data());
    return a;
}

double rest_slope(const abi::Viscosity& viscosity, const Case& scene, const KernelUse& kernel, double r2) {
    return viscosity.slope({.n = 1, .r2 = &r2, .h = kernel.h, .c = scene.medium.c0, .rho = scene.medium.rho0});
}

double lattice_volume(const abi::Box& box) { return std::pow(box.dx, box.dimension); }

}    // namespace sphonic
