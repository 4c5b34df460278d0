#pragma once
#include <algorithm>

#include "../staggered/media.hpp"
#include "spectrum.hpp"

namespace kspace {

using staggered::Media;

/// The gradient and the divergence of Tabei, Mast and Waag (2002), each mode i k_a times kappa, shifted by half a spacing. Of u the
/// modes W_a = i exp(-i k_a dx/2) FFT(u_a) are kept, in which both are real:
///   W_a += h/rho0 k_a kappa P  is  u_a -= h/rho0 dp/da,     P -= h K sum_a k_a kappa W_a  is  p -= h K div u.
class Operators {
public:
    Operators(const Grid& grid, int threads) : spectrum(grid, threads), grid_(grid), work_(spectrum.modes()), inverse_(1 / double(grid.points())) {
        for (int a = 0; a < 3; ++a)
            for (std::size_t i = 0; i < spectrum.k[a].size(); ++i) {
                const Complex back = std::conj(spectrum.turn[a][i]);
                back_[a].push_back(inverse_ * back);
                node_[a].push_back(inverse_ * Complex(0, -1));
                slope_[a].push_back(-inverse_ * spectrum.k[a][i] * back);
                push_[a].push_back(inverse_ * spectrum.k[a][i]);
            }
    }

    Spectrum spectrum;

    /// dp/da at the points of u_a.
    void slope(int a, const Modes& P, Field& out) {
        multiply<Corrected::yes, Sum::replace>(a, slope_[a], P, work_);
        spectrum.backward(work_, out);
    }
    /// div u at the points of p.
    void divergence(const Modes* W, Field& out) {
        multiply<Corrected::yes, Sum::replace>(0, push_[0], W[0], work_);
        for (int a = 1; a < grid_.dimension; ++a) multiply<Corrected::yes, Sum::add>(a, push_[a], W[a], work_);
        spectrum.backward(work_, out);
    }
    /// W_a of a field of u_a.
    void analyse(int a, Field& u, Modes& W) {
        spectrum.forward(u, W);
        turn(a, W);
    }
    void turn(int a, Modes& U) const { multiply<Corrected::no, Sum::replace>(a, spectrum.turn[a], U, U); }
    /// u_a from its modes: where it is kept, or at the points of p.
    void synthesise(int a, const Modes& W, bool at_pressure, Field& u) {
        multiply<Corrected::no, Sum::replace>(a, at_pressure ? node_[a] : back_[a], W, work_);
        spectrum.backward(work_, u);
    }
    void synthesise(const Modes& P, Field& p) {
        for (std::size_t m = 0; m < P.size(); ++m) work_[m] = inverse_ * P[m];
        spectrum.backward(work_, p);
    }
    /// What a source adds in a step, times cos b: with it, it radiates as in the medium (Cox et al. 2007). The field is lost.
    const Modes& supply(Field& added) {
        spectrum.forward(added, work_);
        for (std::size_t m = 0; m < work_.size(); ++m) work_[m] *= spectrum.cosine[m];
        return work_;
    }

    /// Both halves of a step in one medium, where the modes know nothing of each other.
    void both(Modes& P, Modes* W, double h, const abi::Medium& medium) const {
        const double light = h / medium.rho0, stiff = h * Media::modulus(medium);
        spectrum.for_rows([&](long row, long j, long l) {
            const double *__restrict kx = spectrum.k[0].data(), *__restrict kappa = spectrum.kappa.data() + row;
            const double ky = spectrum.k[1][std::size_t(j)], kz = spectrum.k[2][std::size_t(l)];
            double *__restrict p = parts(P, row), *__restrict x = parts(W[0], row), *__restrict y = grid_.dimension > 1 ? parts(W[1], row) : nullptr,
                   *__restrict z = grid_.dimension > 2 ? parts(W[2], row) : nullptr;
            const auto turn = [&](auto d) {
#pragma omp simd
                for (long i = 0; i < spectrum.half; ++i)
                    for (long c = 2 * i; c < 2 * i + 2; ++c) {
                        const double pull = light * kappa[i] * p[c];
                        double sum = kx[i] * (x[c] += kx[i] * pull);
                        if constexpr (d > 1) sum += ky * (y[c] += ky * pull);
                        if constexpr (d > 2) sum += kz * (z[c] += kz * pull);
                        p[c] -= stiff * kappa[i] * sum;
                    }
            };
            if (grid_.dimension == 1) turn(std::integral_constant<int, 1>());
            if (grid_.dimension == 2) turn(std::integral_constant<int, 2>());
            if (grid_.dimension == 3) turn(std::integral_constant<int, 3>());
        });
    }

private:
    const Grid& grid_;
    Modes work_;
    double inverse_;    ///< of the number of points
    std::vector<Complex> back_[3], node_[3], slope_[3], push_[3];    ///< by mode along an axis

    enum class Corrected { no, yes };
    enum class Sum { replace, add };

    static double* parts(Modes& F, long row) { return reinterpret_cast<double*>(F.data() + row); }
    static const double* parts(const Modes& F, long row) { return reinterpret_cast<const double*>(F.data() + row); }

    /// out = or += [kappa] factor in, the factors by mode along one axis.
    template <Corrected corrected, Sum sum>
    void multiply(int axis, const std::vector<Complex>& factors, const Modes& in, Modes& out) const {
        spectrum.for_rows([&](long row, long j, long l) {
            const double *f = parts(in, row), *__restrict kappa = corrected == Corrected::yes ? spectrum.kappa.data() + row : nullptr;
            double* o = parts(out, row);
            const auto one = [&](long i, Complex c) {
                const double weight = corrected == Corrected::yes ? kappa[i] : 1, re = f[2 * i], im = f[2 * i + 1];
                const double x = weight * (c.real() * re - c.imag() * im), y = weight * (c.real() * im + c.imag() * re);
                o[2 * i] = sum == Sum::add ? o[2 * i] + x : x;
                o[2 * i + 1] = sum == Sum::add ? o[2 * i + 1] + y : y;
            };
            if (axis == 0) {
                const Complex* c = factors.data();
#pragma omp simd
                for (long i = 0; i < spectrum.half; ++i) one(i, c[i]);
            } else {
                const Complex c = factors[std::size_t(axis == 1 ? j : l)];
#pragma omp simd
                for (long i = 0; i < spectrum.half; ++i) one(i, c);
            }
        });
    }
};

}    // namespace kspace
