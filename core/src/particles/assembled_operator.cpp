#include <algorithm>
#include <cmath>

#include <sphonic/stability.hpp>

#include "particle_system.hpp"

/// The equations of a set as a linear operator, and runs that begin with a linear state.
namespace sphonic {

double ParticleSystem::unit_of(int component) const {
    const double c0 = scene_.medium.c0, rho0 = scene_.medium.rho0;
    if (component == components_.first[std::size_t(of_pressure_.variable)]) return rho0 * c0 * c0 / of_pressure_.slope;
    return components_.rest(component) != 0 ? components_.rest(component) : c0;
}

long ParticleSystem::values() { return long(part(abi::fields).components.size()) * particles(); }

double ParticleSystem::unit(long value) { return unit_of(part(abi::fields).components[std::size_t(value / particles())]); }

void ParticleSystem::set_linear(const double* x, double size, bool add) {
    for (const int c : part(abi::fields).components) {
        const double scale = size * unit_of(c), rest = components_.rest(c);
        double* field = store_.array(abi::state, c);
        layout().for_rows([&](long row, long first) {
            for (long i = 0; i < layout().count[0]; ++i) field[row + i] = (add ? field[row + i] : rest) + scale * x[first + i];
        });
        x += particles();
    }
}

void ParticleSystem::linear_rate(const double* x, double* y, double dissipation) {
    constexpr double size = 1e-7;    // what is quadratic vanishes beside it
    Part& all = part(abi::fields);
    const abi::Slot rates = store_.history("core: rate");
    const double* p = field(components_.first[std::size_t(pressure_)]);
    std::fill_n(y, values(), 0.0);
    for (const double sign : {1.0, -1.0}) {
        set_linear(x, sign * size, false);
        tier_->restart();    // walls with memory have none here
        refresh_algebraic(all, 0);
        for (const int c : all.components) tier_->fill_ghosts(c, store_.array(abi::state, c), p, 0);
        evaluate_terms(all, rates, 1, true, Terms::without_dissipation);
        if (dissipation != 0 && scene_.equations.dissipate()) evaluate_terms(all, rates, dissipation, false, Terms::dissipation_only);
        double* to = y;
        for (const int c : all.components) {
            const double* rate = field(c, rates);
            const double scale = sign / (2 * size * unit_of(c));
            layout().for_rows([&](long row, long first) {
                for (long i = 0; i < layout().count[0]; ++i) to[first + i] += scale * rate[row + i];
            });
            to += particles();
        }
    }
}

void ParticleSystem::begin_with(const double* x, double size, double dt) {
    store_.clear();
    initialise(dt);
    set_linear(x, size, true);
    forget_walls();
}

std::vector<std::span<double>> ParticleSystem::everything() {
    std::vector<std::span<double>> all = tier_->memory();
    for (const auto& pressure : flow_.remembered()) all.push_back(pressure);
    for (int slot = 0; slot < store_.slots(); ++slot)
        for (int c = 0; c < components_.count; ++c) all.emplace_back(store_.array(slot, c), std::size_t(layout().size));
    return all;
}

double ParticleSystem::squares() {
    double sum = 0;
    for (const int c : part(abi::fields).components) {
        const double scale = 1 / unit_of(c), rest = components_.rest(c);
        const double* field = this->field(c);
        layout().for_rows([&](long row, long) {
            double squares = 0;
#pragma omp simd reduction(+ : squares)
            for (long i = 0; i < layout().count[0]; ++i) squares += (field[row + i] - rest) * (field[row + i] - rest);
            sum += scale * scale * squares;
        });
    }
    return sum;
}

Symbol assembled(const Case& scene, double dissipation) {
    ParticleSystem system(scene);
    const std::size_t n = std::size_t(system.values());
    Symbol A{.n = int(n), .a = std::vector<double>(n * n)};
    std::vector<double> x(n, 0.0), y(n);
    for (std::size_t column = 0; column < n; ++column) {
        x[column] = 1;
        system.linear_rate(x.data(), y.data(), dissipation);
        x[column] = 0;
        for (std::size_t row = 0; row < n; ++row) A.a[row * n + column] = y[row] * system.unit(long(row)) / system.unit(long(column));
    }
    return A;
}

}    // namespace sphonic
