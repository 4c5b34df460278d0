#include <algorithm>
#include <cmath>
#include <type_traits>

#include "pair_set.hpp"
#include "parallel.hpp"

namespace sphonic {

void take_tile(const PairSet& set, long i, PairTile& tile) {
    const long begin = set.near.begin(i);
    tile.rows = set.near.begin(i + 1) - begin;
    tile.base = set.near.base(i);
    tile.particle = set.list.order().data() + begin;
    tile.first = set.near.first(i);
    tile.j = set.near.neighbours(i);
    tile.n = tile.first[tile.rows];
}

void invert(int threads, long n, const double* rho, double* inverse) {
    in_blocks(threads, n, [=](long begin, long end) {
        const double* __restrict from = rho;
        double* __restrict to = inverse;
        for (long i = begin; i < end; ++i) to[i] = 1 / from[i];
    });
}

void PairFields::fill(const double* const* state, const double* inverse_rho) {
    inverse_rho_ = inverse_rho;
    sources_.clear();
    for (int a = 0; a < set_.scene.box.dimension && !set_.kept; ++a) sources_.push_back(set_.x[a]);
    for (const int c : components_) sources_.push_back(state[c]);
    if (inverse_rho) sources_.push_back(inverse_rho);
    const long n = set_.layout.particles() + set_.walls.count() + set_.mirrors.count();
    parts_.resize((sources_.size() + 3) / 4);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const int count = int(std::min<std::size_t>(4, sources_.size() - 4 * k));
        parts_[k].resize(count, n);
        in_blocks(set_.threads, n, [&](long begin, long end) { parts_[k].fill(sources_.data() + 4 * k, count, begin, end); });
    }
}

PairValues::PairValues(const PairSet& set, const PairFields& fields) : set_(set), fields_(fields) {
    computed_.slope.resize(set.scene.kernels.size());
    slope_.resize(set.scene.kernels.size());
    weight_.resize(set.scene.kernels.size());
    int last = set.components.count;
    for (const int c : fields.components()) last = std::max(last, c + 1);
    own_.resize(std::size_t(last) + 1);
    other_.resize(own_.size());
}

double* PairValues::room(Array& array) const {
    const long need = tile_->n + overrun;
    if (long(array.size()) < need) array = Array(std::size_t(std::max(need, pairs_per_tile + overrun)));
    return array.data();
}

void PairValues::start(const PairTile& tile) {
    tile_ = &tile;
    make_room();
    pack();
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

void PairValues::make_room() {
    own_of_.clear();
    other_of_.clear();
    const auto add = [&](double* own, double* other) {
        own_of_.push_back(own);
        other_of_.push_back(other);
    };
    for (int a = 0; a < set_.scene.box.dimension && !set_.kept; ++a) add(nullptr, room(computed_.r[a]));
    for (const int c : fields_.components()) add(room(own_[std::size_t(c)]), room(other_[std::size_t(c)]));
    if (fields_.has_inverse_rho()) add(room(own_.back()), room(other_.back()));
    while (other_of_.size() % 4 == 3) add(room(unused_), room(unused_));    // a part of four has three fields
}

/// The first part may begin with positions.
void PairValues::pack() {
    for (std::size_t k = 0; k < fields_.parts().size(); ++k) {
        const int width = fields_.parts()[k].width, positions = k == 0 && !set_.kept ? set_.scene.box.dimension : 0;
        const auto pack_as = [&]<int W>(std::integral_constant<int, W>) {
            switch (positions) {
                case 0: return pack_part<W, 0>(k);
                case 1: return pack_part<W, std::min(W, 1)>(k);
                case 2: return pack_part<W, std::min(W, 2)>(k);
                default: return pack_part<W, std::min(W, 3)>(k);
            }
        };
        if (width == 1)
            pack_as(std::integral_constant<int, 1>{});
        else if (width == 2)
            pack_as(std::integral_constant<int, 2>{});
        else
            pack_as(std::integral_constant<int, 4>{});
    }
}

/// W fields, the first `positions` of them as separations. Row by row in whole vectors: what one writes beyond its row the next overwrites.
template <int W, int positions>
void PairValues::pack_part(std::size_t part) const {
    const double* values = fields_.parts()[part].values.data();
    double *own[W], *other[W];
    for (int c = 0; c < W; ++c) {
        own[c] = own_of_[4 * part + std::size_t(c)];
        other[c] = other_of_[4 * part + std::size_t(c)];
    }
    const std::int32_t* j = tile_->j;
    tile_->for_rows([&](long i, int first, int last) {
        Lane mine[W];
        for (int c = 0; c < W; ++c) mine[c] = values[W * i + c] - Lane{};
        for (int k = first; k < last; k += lanes) {
            Lane f[W];
            take<W>(values, j + k, f);
#pragma GCC unroll 4
            for (int c = 0; c < W; ++c) {
                if (c >= positions) store(own[c] + k, mine[c]);
                store(other[c] + k, c < positions ? mine[c] - f[c] : f[c]);
            }
        }
    });
}

void PairValues::compute_geometry() {
    const int d = set_.scene.box.dimension, n = tile_->n;
    double *__restrict r2 = room(computed_.r2), *__restrict distance = room(distance_);
    for (int a = 0; a < d; ++a) {
        double* __restrict ra = computed_.r[a].data();
        const Period period = set_.list.period(a);
        for (int k = 0; k < n; ++k) ra[k] = period.nearest(ra[k]);
        for (int k = 0; k < n; ++k) r2[k] = a == 0 ? ra[k] * ra[k] : r2[k] + ra[k] * ra[k];
    }
    for (int k = 0; k < n; ++k) distance[k] = std::sqrt(r2[k]);
    for (std::size_t i = 0; i < computed_.slope.size(); ++i) {
        const KernelUse& use = set_.scene.kernels[i];
        use.kernel->evaluate(d, n, distance, use.h, nullptr, room(computed_.slope[i]));
    }
}

void PairValues::weigh(double* __restrict weight, const double* __restrict slope) const {
    if (!fields_.has_inverse_rho()) {
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
    PairFields positions(set, {});
    positions.fill(nullptr, nullptr);
    PairValues values(set, positions);
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
