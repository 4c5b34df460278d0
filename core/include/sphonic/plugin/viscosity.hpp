#pragma once
/// A viscosity plugin is a struct with two stages: prepare(r2, h, c, rho), which may cost, and
/// operator()(prepared, u_dot_r), which runs for every pair at every step and must be branch-free
/// (std::min(u_dot_r, 0.0), never an early return: that is 5-10 times slower).

#include <algorithm>
#include <cstring>

#include <sphonic/plugin/abi/viscosity.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

namespace sphonic::detail {

template <class V>
class ViscosityAdapter final : public abi::Viscosity {
public:
    V model;
    using Prepared = decltype(std::declval<const V&>().prepare(1.0, 1.0, 1.0, 1.0));
    static_assert(std::is_trivially_copyable_v<Prepared> && sizeof(Prepared) % sizeof(double) == 0,
                  "what prepare() returns must be a plain struct of doubles");
    static constexpr int size = int(sizeof(Prepared) / sizeof(double));

    void pairs(const abi::PairBlock& b, double* Pi) const override {
        if (b.h_each || b.c_each || b.rho_each)
            mixed_pairs(b, Pi);
        else
            uniform_pairs(b, Pi);
    }
    int prepared_size() const override { return size; }
    void prepare(const abi::PairBlock& b, double* prepared) const override {
        for (int k = 0; k < b.n; ++k) {
            const Prepared p =
                model.prepare(b.r2[k], at(b.h_each, b.h, k), at(b.c_each, b.c, k), at(b.rho_each, b.rho, k));
            std::memcpy(prepared + std::ptrdiff_t(k) * size, &p, sizeof p);
        }
    }
    void row(const abi::RowPairs& pairs, const double* prepared, double* Pi) const override {
        Prepared p;
        std::memcpy(&p, prepared, sizeof p);
        if (pairs.dimension == 1) return row_in<1>(pairs, p, Pi);
        if (pairs.dimension == 2) return row_in<2>(pairs, p, Pi);
        row_in<3>(pairs, p, Pi);
    }
    double slope(const abi::PairBlock& b) const override {
        const double c = at(b.c_each, b.c, 0), tiny = 1e-9 * c * std::sqrt(b.r2[0]);
        return -model(model.prepare(b.r2[0], at(b.h_each, b.h, 0), c, at(b.rho_each, b.rho, 0)), -tiny) / tiny;
    }

private:
    template <int D>
    void row_in(const abi::RowPairs& pairs, const Prepared p, double* __restrict Pi) const {
        const V local = model;
        const double *__restrict u0 = pairs.u[0], *__restrict u1 = pairs.u[D > 1 ? 1 : 0], *__restrict u2 = pairs.u[D > 2 ? 2 : 0];
        const double r0 = pairs.r[0], r1 = pairs.r[1], r2 = pairs.r[2];
        const std::ptrdiff_t at = pairs.at;
        for (int i = 0; i < pairs.n; ++i) {
            double u_dot_r = (u0[i] - u0[i + at]) * r0;
            if constexpr (D > 1) u_dot_r += (u1[i] - u1[i + at]) * r1;
            if constexpr (D > 2) u_dot_r += (u2[i] - u2[i + at]) * r2;
            Pi[i] = local(p, u_dot_r);
        }
    }
    static double at(const double* each, double uniform, int k) { return each ? each[k] : uniform; }

    // No simd pragma here: with one, GCC 12 keeps the prepared struct in memory and does not vectorise.
    void uniform_pairs(const abi::PairBlock& b, double* __restrict Pi) const {
        const double* __restrict r2 = b.r2, * __restrict u_dot_r = b.u_dot_r;
        const double h = b.h, c = b.c, rho = b.rho;
        for (int k = 0; k < b.n; ++k) Pi[k] = model(model.prepare(r2[k], h, c, rho), u_dot_r[k]);
    }
    void mixed_pairs(const abi::PairBlock& b, double* __restrict Pi) const {
        const double* __restrict r2 = b.r2, * __restrict u_dot_r = b.u_dot_r;
        const double *each_h = b.h_each ? b.h_each : &b.h, *each_c = b.c_each ? b.c_each : &b.c,
                     *each_rho = b.rho_each ? b.rho_each : &b.rho;
        const std::ptrdiff_t sh = b.h_each ? 1 : 0, sc = b.c_each ? 1 : 0, sr = b.rho_each ? 1 : 0;
        if (sr && !sh && !sc) {    // the common mix: one medium, current densities
            const double h = b.h, c = b.c;
            for (int k = 0; k < b.n; ++k) Pi[k] = model(model.prepare(r2[k], h, c, each_rho[k]), u_dot_r[k]);
            return;
        }
        for (int k = 0; k < b.n; ++k)
            Pi[k] = model(model.prepare(r2[k], each_h[k * sh], each_c[k * sc], each_rho[k * sr]), u_dot_r[k]);
    }
};

}    // namespace sphonic::detail

#define SPHONIC_VISCOSITY(name, Struct, doc)                                                                           \
    SPHONIC_ENTRY(sphonic::abi::Viscosity, Struct, sphonic::detail::ViscosityAdapter<Struct>, name, doc)
