#include "plain_values.hpp"

#include <algorithm>
#include <cmath>

namespace sphonic {
namespace {

/// The fields of pairs, up to four to a record, in registers: own values first, then those of `lanes` others.
template <int fields>
class Records {
public:
    explicit Records(const std::vector<Interleaved>& parts) {
        for (std::size_t p = 0; p < count; ++p) part_[p] = parts[p].values.data();
    }
    void own(long i, double* f) const {
        for (std::size_t c = 0; c < fields; ++c) f[c] = part_[c / 4][width(c / 4) * i + long(c % 4)];
    }
    void others(const std::int32_t* j, Lane* f) const {
        sphonic::take<width(0)>(part_[0], j, f);
        if constexpr (count > 1) sphonic::take<width(1)>(part_[1], j, f + 4);
        if constexpr (count > 2) sphonic::take<width(2)>(part_[2], j, f + 8);
    }
    static constexpr int room = 12;

private:
    static constexpr std::size_t count = (fields + 3) / 4;
    static constexpr int width(std::size_t part) {
        const int left = fields - 4 * int(part);
        return left > 2 ? 4 : left;
    }
    const double* part_[3] = {};
};

/// To `array`, unless nobody asks for it.
void put(double* array, int k, Lane value) {
    if (array) store(array + k, value);
}

}    // namespace

template <int D>
void PlainValues::take(const PairTile& tile) {
    tile_ = &tile;
    make_room();
    const bool dense = rates_.density >= 0;
    if (rates_.vector() < 0) return dense ? take_fields<D, false, true, true>() : take_fields<D, false, true, false>();
    if (rates_.gradient) return dense ? take_fields<D, true, true, true>() : take_fields<D, true, true, false>();
    return dense ? take_fields<D, true, false, true>() : take_fields<D, true, false, false>();
}
template void PlainValues::take<1>(const PairTile&);
template void PlainValues::take<2>(const PairTile&);
template void PlainValues::take<3>(const PairTile&);

void PlainValues::make_room() {
    const std::size_t need = std::size_t(std::max<long>(tile_->n, pairs_per_tile) + overrun);
    if (r2_.size() >= need) return;
    const auto provide = [&](bool wanted, std::initializer_list<Array*> arrays) {
        for (Array* array : arrays)
            if (wanted) *array = Array(need);
    };
    const bool apart = by_pair();
    provide(true, {&r_[0], &r_[1], &r_[2], &r2_, &distance_, &slope_, &pressure_, &flow_});
    provide(rates_.gradient && rates_.gradient->by_pair, {&pressure_j_});
    provide(rates_.divergence && rates_.divergence->by_pair, {&flow_j_});
    provide(rates_.viscosity, {&u_dot_r_, &Pi_});
    provide(rates_.density >= 0, {&weight_, &inverse_rho_j_});
    provide(rates_.density >= 0 && rates_.viscosity, {&mean_rho_});
    provide(apart, {&rho_i_, &rho_j_, &inverse_rho_i_, &impedance_i_, &impedance_j_, &own_, &other_});
}

/// Fields in their order: positions, velocity, pressure, rho, 1/rho. Row by row in whole vectors: what one writes beyond its row the
/// next overwrites.
template <int D, bool velocity, bool pressure, bool density>
void PlainValues::take_fields() {
    constexpr int u_at = D, p_at = D + (velocity ? D : 0), rho_at = p_at + pressure, fields = rho_at + (density ? 2 : 0);
    using Taken = Records<fields>;
    const Taken records(fields_.parts());
    const PlainRates::Derivative p = rates_.gradient.value_or(PlainRates::Derivative{}), u = rates_.divergence.value_or(PlainRates::Derivative{});
    const std::array<Period, 3> period{set_.list.period(0), set_.list.period(1), set_.list.period(2)};
    double *r_to[3] = {r_[0].data(), r_[1].data(), r_[2].data()}, *r2_to = r2_.data();
    double *pressure_to = pressure_.data(), *pressure_j_to = pressure_j_.data(), *u_dot_r_to = u_dot_r_.data();
    double *flow_to = rates_.divergence ? flow_.data() : nullptr, *flow_j_to = flow_j_.data();
    double *rho_i_to = rho_i_.data(), *rho_j_to = rho_j_.data(), *inverse_i_to = inverse_rho_i_.data(), *inverse_j_to = inverse_rho_j_.data(), *mean_to = mean_rho_.data();
    const std::int32_t* j = tile_->j;
    tile_->for_rows([&](long i, int first, int last) {
        double mine[Taken::room];
        records.own(i, mine);
        for (int k = first; k < last; k += lanes) {
            Lane f[Taken::room], r2 = {}, u_dot_r = {}, flow = {}, flow_j = {};
            records.others(j + k, f);
#pragma GCC unroll 3
            for (int a = 0; a < D; ++a) {
                const Lane r = period[std::size_t(a)].nearest(mine[a] - f[a]);
                r2 += r * r;
                if constexpr (pressure) store(r_to[a] + k, r);
                if constexpr (velocity) {
                    u_dot_r += (mine[u_at + a] - f[u_at + a]) * r;
                    flow += (u.own * mine[u_at + a] + u.other * f[u_at + a]) * r;
                    if constexpr (density) flow_j += f[u_at + a] * r;
                }
            }
            store(r2_to + k, r2);
            if constexpr (velocity) {
                put(flow_to, k, flow);
                put(u_dot_r_to, k, u_dot_r);
                if constexpr (density) put(flow_j_to, k, flow_j);
            }
            if constexpr (pressure) {
                store(pressure_to + k, p.own * mine[p_at] + p.other * f[p_at]);
                if constexpr (density) put(pressure_j_to, k, f[p_at]);
            }
            if constexpr (density) {
                store(inverse_j_to + k, f[rho_at + 1]);
                put(mean_to, k, 0.5 * (mine[rho_at] + f[rho_at]));
                put(rho_i_to, k, mine[rho_at] - Lane{});
                put(rho_j_to, k, f[rho_at]);
                put(inverse_i_to, k, mine[rho_at + 1] - Lane{});
            }
        }
    });
}

void PlainValues::weigh(int dimension) {
    const int n = tile_->n;
    double *__restrict distance = distance_.data(), *__restrict r2 = r2_.data();
    for (int k = 0; k < n; ++k) distance[k] = std::sqrt(r2[k]);
    const KernelUse& use = set_.scene.kernels[std::size_t(rates_.kernel)];
    use.kernel->evaluate(dimension, n, distance, use.h, nullptr, slope_.data());
    if (rates_.density >= 0) {
        double* __restrict weight = weight_.data();
        const double *__restrict slope = slope_.data(), *__restrict inverse = inverse_rho_j_.data();
        for (int k = 0; k < n; ++k) weight[k] = slope[k] * inverse[k];
    }
    if (by_pair()) {
        double *__restrict Z_i = impedance_i_.data(), *__restrict Z_j = impedance_j_.data();
        const double *__restrict rho_i = rho_i_.data(), *__restrict rho_j = rho_j_.data(), c0 = set_.scene.medium.c0;
        for (int k = 0; k < n; ++k) Z_i[k] = c0 * rho_i[k], Z_j[k] = c0 * rho_j[k];
    }
    if (rates_.gradient && rates_.gradient->by_pair) combine(*rates_.gradient, abi::Derivative::gradient, pressure_.data(), pressure_j_.data());
    if (rates_.divergence && rates_.divergence->by_pair) combine(*rates_.divergence, abi::Derivative::divergence, flow_.data(), flow_j_.data());
    if (!rates_.viscosity) return;
    const abi::Medium& medium = set_.scene.medium;
    rates_.viscosity->viscosity->pairs(
        {.n = n, .u_dot_r = u_dot_r_.data(), .r2 = r2, .h = use.h, .c = medium.c0, .rho = medium.rho0, .rho_each = mean_rho_.data()}, Pi_.data());
}

/// own f_i + other f_j in the place of f_i.
void PlainValues::combine(const PlainRates::Derivative& derivative, abi::Derivative kind, double* __restrict value_i, const double* __restrict value_j) {
    derivative.by_pair->coefficients(kind, {tile_->n, rho_i_.data(), rho_j_.data(), inverse_rho_i_.data(), inverse_rho_j_.data(), impedance_i_.data(), impedance_j_.data()},
                                     own_.data(), other_.data());
    const double *__restrict own = own_.data(), *__restrict other = other_.data();
    for (int k = 0; k < tile_->n; ++k) value_i[k] = own[k] * value_i[k] + other[k] * value_j[k];
}

}    // namespace sphonic
