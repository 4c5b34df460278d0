#include <algorithm>
#include <cmath>

#include "pair_set.hpp"

namespace sphonic {

void cut_tiles(PairSet& set) {
    const auto& start = set.list.start();
    const long n = set.layout.particles();
    set.cuts.assign(1, 0);
    for (long i = 1; i <= n; ++i)
        if (i == n || start[std::size_t(i) + 1] - start[std::size_t(set.cuts.back())] > pairs_per_tile) set.cuts.push_back(i);
}

void take_tile(const PairSet& set, long i, PairTile& tile) {
    const auto& start = set.list.start();
    tile.begin = set.cuts[std::size_t(i)];
    tile.end = set.cuts[std::size_t(i) + 1];
    tile.base = start[std::size_t(tile.begin)];
    tile.first.clear();
    for (long k = tile.begin; k <= tile.end; ++k) tile.first.push_back(int(start[std::size_t(k)] - tile.base));
    tile.n = tile.first.back();
    tile.first_run = set.list.first_run().data() + tile.begin;
    tile.runs = set.list.runs().data();
}

PairValues::PairValues(const PairSet& set, const std::vector<int>& components) : set_(set), components_(components) {
    computed_.slope.resize(set.scene.kernels.size());
    slope_.resize(set.scene.kernels.size());
    weight_.resize(set.scene.kernels.size());
    int last = set.components.count;
    for (const int c : components) last = std::max(last, c + 1);
    own_.resize(std::size_t(last) + 1);
    other_.resize(own_.size());
}

double* PairValues::room(Array& array) const {
    const long need = tile_->n + overrun;
    if (long(array.size()) < need) array = Array(std::size_t(std::max(need, pairs_per_tile + overrun)));
    return array.data();
}

void PairValues::begin(const double* const* state, const double* inverse_rho) {
    state_ = state;
    inverse_rho_ = inverse_rho;
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
    if (inverse_rho_) packings_.push_back({inverse_rho_, room(own_.back()), room(other_.back())});
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
    if (!inverse_rho_) {
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
    PairTile tile;
    for (long k = 0; k < tiles(set); ++k) {
        take_tile(set, k, tile);
        values.start(tile);
        for (int a = 0; a < d; ++a) std::copy_n(values.r(a), tile.n, all.r[a].data() + tile.base);
        std::copy_n(values.r2(), tile.n, all.r2.data() + tile.base);
        for (std::size_t i = 0; i < all.slope.size(); ++i) std::copy_n(values.slope(int(i)), tile.n, all.slope[i].data() + tile.base);
    }
    return all;
}

}    // namespace sphonic
