#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <sphonic/plugin/form.hpp>

#include "minimax.hpp"

namespace sphonic::band {

/// A wave vector [1/dx] and the symbol's derivative by each weight there: F(k) = sum_c w_c basis_c(k).
struct Sample {
    std::array<double, 3> k{};
    std::vector<std::array<double, 3>> basis;
};

inline double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }
inline double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Neighbours that a lattice's symmetries make alike share a weight.
class Classes {
public:
    explicit Classes(const abi::LatticeFit& lattice) : lattice_(lattice) {
        std::map<std::array<int, 3>, int> known;
        for (int n = 0; n < lattice.n; ++n) {
            std::array<int, 3> key{};
            for (std::size_t a = 0; a < std::size_t(lattice.dimension); ++a) key[a] = std::abs(lattice.offset[a][n]);
            std::sort(key.begin(), key.end());
            of_.push_back(known.emplace(key, int(known.size())).first->second);
        }
        count_ = int(known.size());
    }
    int count() const { return count_; }
    int of(int neighbour) const { return of_[std::size_t(neighbour)]; }

    Sample sample(const std::array<double, 3>& k) const {
        Sample s{k, std::vector<std::array<double, 3>>(std::size_t(count_))};
        for (int n = 0; n < lattice_.n; ++n) {
            double phase = 0;
            for (int a = 0; a < lattice_.dimension; ++a) phase += k[std::size_t(a)] * lattice_.offset[a][n];
            for (int a = 0; a < lattice_.dimension; ++a)
                s.basis[std::size_t(of(n))][std::size_t(a)] += 2 * lattice_.offset[a][n] * std::sin(phase);
        }
        return s;
    }

private:
    const abi::LatticeFit& lattice_;
    std::vector<int> of_;
    int count_ = 0;
};

inline std::array<double, 3> symbol(const Sample& s, const std::vector<double>& w) {
    std::array<double, 3> F{};
    for (std::size_t c = 0; c < w.size(); ++c)
        for (std::size_t a = 0; a < 3; ++a) F[a] += w[c] * s.basis[c][a];
    return F;
}

/// Unit vectors of the part of space that symmetry leaves: 0 to 45 degrees in the plane, a 48th of the sphere in space.
inline std::vector<std::array<double, 3>> directions(int dimension) {
    if (dimension == 1) return {{1, 0, 0}};
    std::vector<std::array<double, 3>> all;
    constexpr int fine = 24, coarse = 10;
    if (dimension == 2)
        for (int i = 0; i <= fine; ++i) all.push_back({std::cos(pi / 4 * i / fine), std::sin(pi / 4 * i / fine), 0});
    for (int i = 0; dimension == 3 && i <= coarse; ++i)
        for (int j = 0; j <= i; ++j) {
            std::array<double, 3> v{double(coarse), double(i), double(j)};
            const double size = length(v);
            for (double& x : v) x /= size;
            all.push_back(v);
        }
    return all;
}

/// The weights of a lattice for waves of no fewer than this many points per wavelength.
struct LatticeBand {
    double points_per_wavelength;

    void fit(const abi::LatticeFit& lattice, double* weight) const {
        const Classes classes(lattice);
        Minimax problem(classes.count());
        auto band = band_conditions(classes, lattice);
        for (auto& ray : band)
            for (const std::size_t m : {ray.size() / 3, 2 * ray.size() / 3, ray.size() - 1}) problem.approach(ray[m]);
        std::vector<double> w = problem.solve();
        constexpr int rounds = 100;
        for (int round = 0; round < rounds; ++round) {    // bitwise or: both look
            if (!(approach_worst(problem, band, w) | cut(problem, classes, lattice, w))) break;
            w = problem.solve();
        }
        for (int n = 0; n < lattice.n; ++n) weight[n] = w[std::size_t(classes.of(n))];
    }

private:
    /// F along a direction over its target, as a linear function of the weights.
    using Condition = std::vector<double>;

    /// By direction and magnitude, dense at the band's end.
    std::vector<std::vector<Condition>> band_conditions(const Classes& classes, const abi::LatticeFit& lattice) const {
        constexpr int magnitudes = 32;
        std::vector<std::vector<Condition>> band;
        for (const auto& direction : directions(lattice.dimension)) {
            band.emplace_back();
            for (int m = 1; m <= magnitudes; ++m) {
                const double k = 2 * pi / points_per_wavelength * std::sin(0.5 * pi * m / magnitudes), C = lattice.courant;
                const double target = C > 0 ? 2 / C * std::sin(0.5 * C * k) : k;
                const Sample s = classes.sample({k * direction[0], k * direction[1], k * direction[2]});
                band.back().emplace_back();
                for (const auto& basis : s.basis) band.back().back().push_back(dot(basis, direction) / target);
            }
        }
        return band;
    }

    /// Takes up the worst condition of every direction that is worse than all those taken up so far; false if there is none.
    static bool approach_worst(Minimax& problem, const std::vector<std::vector<Condition>>& band, const std::vector<double>& w) {
        bool found = false;
        for (const auto& ray : band) {
            double worst = (1 + 1e-3) * problem.error();
            const Condition* at = nullptr;
            for (const Condition& condition : ray) {
                double error = -1;
                for (std::size_t c = 0; c < w.size(); ++c) error += condition[c] * w[c];
                if (std::abs(error) > worst) worst = std::abs(error), at = &condition;
            }
            if (at) problem.approach(*at);
            found = found || at;
        }
        return found;
    }

    /// Adds bounds where |F| goes beyond what is allowed; false if it does nowhere.
    static bool cut(Minimax& problem, const Classes& classes, const abi::LatticeFit& lattice, const std::vector<double>& w) {
        constexpr int samples[4] = {0, 400, 48, 20};
        constexpr double slack = 1e-4;
        const int d = lattice.dimension, n = samples[d];
        bool found = false;
        std::array<int, 3> i{};
        for (i[0] = 0; i[0] <= n; ++i[0])
            for (i[1] = 0; i[1] <= (d > 1 ? i[0] : 0); ++i[1])
                for (i[2] = 0; i[2] <= (d > 2 ? i[1] : 0); ++i[2]) {
                    const Sample s = classes.sample({pi * i[0] / n, pi * i[1] / n, pi * i[2] / n});
                    const auto F = symbol(s, w);
                    const double size = length(F);
                    if (size <= lattice.most * (1 + slack)) continue;
                    std::vector<double> a;
                    for (const auto& basis : s.basis) a.push_back(dot(basis, F) / size);
                    problem.bound(a, lattice.most);
                    found = true;
                }
        return found;
    }
};

}    // namespace sphonic::band
