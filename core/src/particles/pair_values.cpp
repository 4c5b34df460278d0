#include <algorithm>
#include <cmath>

#include "pair_set.hpp"

namespace sphonic {

PairValues::PairValues(const PairSet& set, const std::vector<int>& components) : set_(set), components_(components) {
    computed_.slope.resize(set.scene.kernels.size());
    slope_.resize(set.scene.kernels.size());
    weight_.resize(set.scene.kernels.size());
    own_.resize(std::size_t(set.components.count) + 1);
    other_.resize(own_.size());
    if (set.density() >= 0) inverse_rho_ = Array(std::size_t(set.layout.size + overrun));
}

double* PairValues::room(Array& array) const {
    const long need = tile_->n + overrun;
    if (long(array.size()) < need) array = Array(std::size_t(std::max(need, pairs_per_tile + overrun)));
    return array.data();
}

void PairValues::begin(const double* const* state) {
    state_ = state;
    if (!inverse_rho_.data()) return;
    const double* __restrict rho = state[set_.components.first[std::size_t(set_.density())]];
    double* __restrict inverse = inverse_rho_.data();
    for (long i = 0; i < set_.layout.size; ++i) inverse[i] = 1 / rho[i];
}

void PairValues::start(const PairTile& tile) {
    tile_ = &tile;
    pack_tile();
    if (set_.kept) {
        point_to(*set_.kept, tile.base);
    } else {
        compute_geometry();
        point_to(computed_, 0);
    }
    for (std::size_t i = 0; i < slope_.size(); ++i) weigh(room(weight_[i]), slope_[i]);
}

void PairValues::point_to(const PairGeometry& geometry, std::int64_t offset) {
    for (int a = 0; a < set_.scene.box.dimension; ++a) r_[a] = geometry.r[a].data() + offset;
    r2_ = geometry.r2.data() + offset;
    for (std::size_t i = 0; i < slope_.size(); ++i) slope_[i] = geometry.slope[i].data() + offset;
}

void PairValues::pack_tile() {
    packings_.clear();
    for (int a = 0; a < set_.scene.box.dimension && !set_.kept; ++a)
        packings_.push_back({set_.x[a], nullptr, room(computed_.r[a])});
    for (const int c : components_)
        packings_.push_back({state_[c], room(own_[std::size_t(c)]), room(other_[std::size_t(c)])});
    if (inverse_rho_.data()) packings_.push_back({inverse_rho_.data(), room(own_.back()), room(other_.back())});
    pack(*tile_, packings_);
}

void PairValues::compute_geometry() {
    const int d = set_.scene.box.dimension, n = tile_->n;
    double *__restrict r2 = room(computed_.r2), *__restrict distance = room(distance_);
    for (int a = 0; a < d; ++a) {
        double* __restrict ra = computed_.r[a].data();
        if (const double period = set_.list.period(a); period > 0)
            for (int k = 0; k < n; ++k) ra[k] -= period * std::nearbyint(ra[k] / period);
        for (int k = 0; k < n; ++k) r2[k] = a == 0 ? ra[k] * ra[k] : r2[k] + ra[k] * ra[k];
    }
    for (int k = 0; k < n; ++k) distance[k] = std::sqrt(r2[k]);
    for (std::size_t i = 0; i < computed_.slope.size(); ++i) {
        const KernelUse& use = set_.scene.kernels[i];
        use.kernel->evaluate(d, n, distance, use.h, nullptr, room(computed_.slope[i]));
    }
}

void PairValues::weigh(double* __restrict weight, const double* __restrict slope) const {
    if (!inverse_rho_.data()) {
        for (int k = 0; k < n(); ++k) weight[k] = set_.volume * slope[k];
        return;
    }
    const double* __restrict inverse = other_inverse_rho();
    const double mass = set_.mass;
    for (int k = 0; k < n(); ++k) weight[k] = mass * inverse[k] * slope[k];
}

PairGeometry keep_geometry(const PairSet& set) {
    PairGeometry all;
    const std::size_t pairs = set.list.neighbour().size() + overrun;
    const int d = set.scene.box.dimension;
    for (int a = 0; a < d; ++a) all.r[a] = Array(pairs);
    all.r2 = Array(pairs);
    for (std::size_t i = 0; i < set.scene.kernels.size(); ++i) all.slope.emplace_back(pairs);
    PairValues values(set, {});
    for_tiles(set, [&](const PairTile& tile) {
        values.start(tile);
        for (int a = 0; a < d; ++a) std::copy_n(values.r(a), tile.n, all.r[a].data() + tile.base);
        std::copy_n(values.r2(), tile.n, all.r2.data() + tile.base);
        for (std::size_t i = 0; i < all.slope.size(); ++i) std::copy_n(values.slope(int(i)), tile.n, all.slope[i].data() + tile.base);
    });
    return all;
}

}    // namespace sphonic
