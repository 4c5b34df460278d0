#include <cmath>
#include <random>

#include "linear_algebra.hpp"
#include "parallel.hpp"
#include "particle_system.hpp"

namespace sphonic {

/// Vectors of all evolved values of a set at rest, with the energy's inner product, and an operator B whose largest eigenvalue is
/// the square of what bounds the step. Undamped, B = -A^2 for the linearised operator A. With dissipation, A = W + D, B = S^2 for
/// S = J W - D, where J changes the sign of scalars: for a wave of frequency omega that decays at the rate delta, S has the eigenvalues
/// delta +- omega, and omega + delta is what leapfrog feels.
class ParticleSystem::Spectrum {
public:
    explicit Spectrum(ParticleSystem& system)
        : system_(system), all_(system.part(abi::fields)), rates_(system.store_.history("core: rate")) {
        const auto [evolved, slope] = system.scene_.behind(system.pressure_);
        const double rho = system.scene_.medium.rho0;
        for (const int c : all_.components) {
            const bool pressure = c == system.components_.first[std::size_t(evolved)];
            weights_.emplace_back();
            for (const abi::Medium& m : system.media_.list())
                weights_.back().push_back(pressure ? slope / std::sqrt(rho * bulk_modulus(m)) : std::sqrt(m.rho0 / rho));
        }
    }

    abi::Slot vector(const char* name) { return system_.store_.history(name); }

    void randomise(abi::Slot v) {
        for_rows([&](int c, auto weight, long row) {
            double* x = system_.store_.array(v, c) + row;
            for (long i = 0; i < system_.layout().count[0]; ++i) x[i] = (double(bits_() >> 11) * 0x1p-53 - 0.5) / weight(i);
        });
    }
    double dot(abi::Slot a, abi::Slot b) {
        double sum = 0;
        for_rows([&](int c, auto weight, long row) {
            const double *x = system_.store_.array(a, c) + row, *y = system_.store_.array(b, c) + row;
            for (long i = 0; i < system_.layout().count[0]; ++i) sum += weight(i) * weight(i) * x[i] * y[i];
        });
        return sum;
    }
    /// y = s y + t x
    void combine(abi::Slot x, double t, abi::Slot y, double s) {
        for (const int c : all_.components) {
            const double* from = system_.store_.array(x, c);
            double* to = system_.store_.array(y, c);
            in_blocks(system_.threads_, system_.layout().size, [=](long begin, long end) {
                for (long i = begin; i < end; ++i) to[i] = s * to[i] + t * from[i];
            });
        }
    }
    /// out = B in, of vectors that are not zero.
    void apply(abi::Slot in, abi::Slot out) {
        const double first = disturb(in), second = disturb(rates_);
        combine(rates_, (dissipates_ ? 1 : -1) / (first * second), out, 0);
    }
    void clear() { combine(abi::state, 0, abi::state, 0); }

private:
    ParticleSystem& system_;
    Part& all_;
    abi::Slot rates_;
    std::vector<std::vector<double>> weights_;    ///< by component and medium: the energy is 1/2 sum V (w z)^2 rho0
    std::mt19937_64 bits_{1};
    bool dissipates_ = system_.scene_.equations.dissipate();

    /// Calls visit(component, weights of the row's particles, the row's place in the field) for all rows of all components.
    template <class Visit>
    void for_rows(Visit visit) {
        for (std::size_t k = 0; k < weights_.size(); ++k)
            system_.layout().for_rows([&](long row, long first) {
                visit(all_.components[k], [&](long i) { return weights_[k][std::size_t(system_.media_.number(first + i))]; }, row);
            });
    }
    /// Rates of a state of rest that is disturbed by so small a multiple of x that they are linear in it; returns the multiple.
    double disturb(abi::Slot x) {
        constexpr double mach_number = 1e-9;
        const double speed = std::sqrt(dot(x, x)), multiple = speed > 0 ? mach_number * system_.scene_.medium.c0 / speed : 1;
        combine(x, multiple, abi::state, 0);
        for (const int c : all_.components) {
            const double rest = system_.components_.rest(c);
            double* value = system_.store_.array(abi::state, c);
            for (long i = 0; rest != 0 && i < system_.layout().size; ++i) value[i] += rest;
        }
        rate();
        return multiple;
    }
    void rate() {
        system_.tier_->restart();    // walls with memory have none here
        system_.refresh_algebraic(all_, 0);
        const double* p = system_.field(system_.components_.first[std::size_t(system_.pressure_)]);
        for (const int c : all_.components) system_.tier_->fill_ghosts(c, system_.store_.array(abi::state, c), p, 0);
        if (!dissipates_) return system_.evaluate_terms(all_, rates_, 1, true);
        system_.evaluate_terms(all_, rates_, 1, true, Terms::without_dissipation);
        for (const int v : all_.variables)
            if (!system_.scene_.equations.variables[std::size_t(v)].is_vector) negate(system_.store_.array(rates_, system_.components_.first[std::size_t(v)]));
        system_.evaluate_terms(all_, rates_, -1, false, Terms::dissipation_only);
    }
    void negate(double* x) {
        for (long i = 0; i < system_.particles(); ++i) x[i] = -x[i];
    }
};

namespace {

constexpr int lanczos_steps = 40, power_steps = 150;

}    // namespace

/// Where B is symmetric, as for adjoint pairs of forms, by Lanczos's method, which needs a quarter of the evaluations.
double ParticleSystem::largest_frequency() {
    Spectrum s(*this);
    const abi::Slot v = s.vector("core: v"), w = s.vector("core: w"), before = s.vector("core: before");
    s.randomise(v);
    s.randomise(before);
    s.apply(before, w);
    const double forth = s.dot(w, v), size = std::sqrt(s.dot(w, w) * s.dot(v, v));
    s.apply(v, w);
    const double largest = std::abs(s.dot(w, before) - forth) < 1e-7 * size ? lanczos(s, v, w, before) : power(s, v, w);
    s.clear();
    return std::sqrt(largest);
}

double ParticleSystem::lanczos(Spectrum& s, abi::Slot v, abi::Slot w, abi::Slot before) {
    std::vector<double> alpha, beta;
    s.combine(v, 0, before, 0);
    s.combine(v, 0, v, 1 / std::sqrt(s.dot(v, v)));
    while (int(alpha.size()) < lanczos_steps) {
        s.apply(v, w);
        alpha.push_back(s.dot(w, v));
        s.combine(v, -alpha.back(), w, 1);
        if (!beta.empty()) s.combine(before, -beta.back(), w, 1);
        const double rest = std::sqrt(s.dot(w, w));
        if (!(rest > 1e-12 * alpha.front())) break;    // the set has no more independent motions
        beta.push_back(rest);
        s.combine(v, 1, before, 0);
        s.combine(w, 1 / rest, v, 0);
    }
    const std::size_t n = alpha.size();
    std::vector<double> T(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        T[i * n + i] = alpha[i];
        if (i + 1 < n) T[i * n + i + 1] = T[(i + 1) * n + i] = beta[i];
    }
    double largest = 0;
    for (const auto& value : eigenvalues(int(n), T.data())) largest = std::max(largest, value.real());
    return largest;
}

double ParticleSystem::power(Spectrum& s, abi::Slot v, abi::Slot w) {
    double largest = 0;
    for (int k = 0; k < power_steps; ++k) {
        s.combine(v, 0, v, 1 / std::sqrt(s.dot(v, v)));
        s.apply(v, w);
        largest = std::sqrt(s.dot(w, w));
        s.combine(w, 1, v, 0);
    }
    return largest;
}

}    // namespace sphonic
