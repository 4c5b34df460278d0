#pragma once
#include <fftw3.h>

#include <cmath>
#include <complex>
#include <memory>
#include <mutex>
#include <vector>

#include "../staggered/grid.hpp"

namespace kspace {

using staggered::Field;
using staggered::Grid;
using Complex = std::complex<double>;
using Modes = std::vector<Complex, staggered::Aligned<Complex>>;

/// The Fourier transforms of real fields on a grid without ghosts: the modes k_x >= 0, the others being their conjugates.
class Spectrum {
public:
    long half;                   ///< modes along x
    std::vector<double> k[3];    ///< wave numbers by axis [rad/m]
    std::vector<Complex> turn[3];    ///< i exp(-i k dx/2): takes u_a to the points of p, times i
    Field kappa, cosine;             ///< sin(b)/b and cos(b), b = c |k| dt/2

    Spectrum(const Grid& grid, int threads) : half(grid.n[0] / 2 + 1), grid_(grid) {
        const double pi = std::acos(-1.0);
        for (int a = 0; a < 3; ++a)
            for (long i = 0; i < (a == 0 ? half : grid.n[a]); ++i) {
                const long signed_i = 2 * i > grid.n[a] ? i - grid.n[a] : i;
                k[a].push_back(a < grid.dimension ? 2 * pi * double(signed_i) / (double(grid.n[a]) * grid.dx) : 0);
                turn[a].push_back(std::polar(1.0, pi / 2 - 0.5 * k[a].back() * grid.dx));
            }
        plan(threads);
    }

    std::size_t modes() const { return std::size_t(half * grid_.n[1] * grid_.n[2]); }

    /// For steps of dt at the sound speed c.
    void time(double c, double dt) {
        kappa.resize(modes());
        cosine.resize(modes());
        for_rows([&](long row, long j, long l) {
            for (long i = 0; i < half; ++i) {
                const double b = 0.5 * c * dt * std::hypot(k[0][std::size_t(i)], k[1][std::size_t(j)], k[2][std::size_t(l)]);
                kappa[std::size_t(row + i)] = b > 0 ? std::sin(b) / b : 1;
                cosine[std::size_t(row + i)] = std::cos(b);
            }
        });
    }

    void forward(Field& f, Modes& F) const { fftw_execute_dft_r2c(forward_.get(), f.data(), raw(F)); }
    /// Times the number of points; F is lost.
    void backward(Modes& F, Field& f) const { fftw_execute_dft_c2r(backward_.get(), raw(F), f.data()); }

    /// Calls row(first mode, number along y, along z).
    template <class Row>
    void for_rows(Row row) const {
        for (long l = 0; l < grid_.n[2]; ++l)
            for (long j = 0; j < grid_.n[1]; ++j) row((l * grid_.n[1] + j) * half, j, l);
    }
    /// Calls use(mode, number along the axis).
    template <class Use>
    void for_modes(int axis, Use use) const {
        for_rows([&](long row, long j, long l) {
            for (long i = 0; i < half; ++i) use(std::size_t(row + i), std::size_t(axis == 0 ? i : axis == 1 ? j : l));
        });
    }

private:
    struct Destroy {
        void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
    };
    using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, Destroy>;
    const Grid& grid_;
    Plan forward_, backward_;

    static fftw_complex* raw(Modes& F) { return reinterpret_cast<fftw_complex*>(F.data()); }

    /// By estimate: measured plans differ from run to run, and so do their last digits.
    void plan(int threads) {
        static std::mutex planner;    // FFTW has one
        const std::lock_guard lock(planner);
        int n[3];
        for (int a = 0; a < grid_.dimension; ++a) n[a] = int(grid_.n[grid_.dimension - 1 - a]);
        Field f(std::size_t(grid_.size));
        Modes F(modes());
        if (threads > 1) fftw_init_threads();
        if (threads > 1) fftw_plan_with_nthreads(threads);
        forward_.reset(fftw_plan_dft_r2c(grid_.dimension, n, f.data(), raw(F), FFTW_ESTIMATE));
        backward_.reset(fftw_plan_dft_c2r(grid_.dimension, n, raw(F), f.data(), FFTW_ESTIMATE));
        if (threads > 1) fftw_plan_with_nthreads(1);
    }
};

}    // namespace kspace
