#pragma once
#include <cmath>
#include <vector>

#include <sphonic/case.hpp>

#include "neighbour_list.hpp"
#include "pair_tile.hpp"
#include "tier.hpp"

namespace sphonic {

inline constexpr long pairs_per_tile = 288;    ///< some twenty arrays of this length stay in the first-level cache

/// What the programs of one moving set share.
struct MovingSet {
    const Case& scene;
    const Components& components;
    Layout layout;
    NeighbourList list;
    const double* x[3] = {};    ///< by axis
    double mass = 0;        ///< [kg], the same for all
    double volume = 0;      ///< [m^d], where the equations have no density
};

/// Cuts the particles into tiles of about `pairs_per_tile` pairs; the cut depends on the scene only.
template <class Visit>
void for_tiles(const MovingSet& set, Visit visit) {
    const auto& start = set.list.start();
    PairTile tile;
    const long n = set.layout.particles();
    for (tile.begin = 0; tile.begin < n; tile.begin = tile.end) {
        tile.first.assign(1, 0);
        const std::int64_t base = start[std::size_t(tile.begin)];
        tile.end = tile.begin;
        while (tile.end < n && (tile.end == tile.begin || start[std::size_t(tile.end) + 1] - base <= pairs_per_tile))
            tile.first.push_back(int(start[std::size_t(++tile.end)] - base));
        tile.n = tile.first.back();
        tile.first_run = set.list.first_run().data() + tile.begin;
        tile.runs = set.list.runs().data();
        visit(tile);
    }
}

/// Per-pair values of a tile: separations, kernel slopes, and both sides' values of the components in use.
class PairValues {
public:
    /// `components` are those that the program reads.
    PairValues(const MovingSet& set, const std::vector<int>& components) : set_(set), components_(components) {
        slope_.resize(set.scene.kernels.size());
        weight_.resize(set.scene.kernels.size());
        own_.resize(std::size_t(set.components.count) + 1);
        other_.resize(own_.size());
        if (set.scene.equations.density >= 0) inverse_rho_ = Array(std::size_t(set.layout.size + overrun));
    }

    /// Once per evaluation, before any tile.
    void begin(const double* const* state) {
        state_ = state;
        if (!inverse_rho_.data()) return;
        const double* __restrict rho = state[density()];
        double* __restrict inverse = inverse_rho_.data();
        for (long i = 0; i < set_.layout.size; ++i) inverse[i] = 1 / rho[i];
    }

    void start(const PairTile& tile) {
        tile_ = &tile;
        pack_tile();
        const int d = set_.scene.box.dimension, n = tile.n;
        double *__restrict r2 = room(r2_), *__restrict distance = room(distance_);
        for (int a = 0; a < d; ++a) {
            double* __restrict ra = r_[a].data();
            if (const double period = set_.list.period(a); period > 0)
                for (int k = 0; k < n; ++k) ra[k] -= period * std::nearbyint(ra[k] / period);
            for (int k = 0; k < n; ++k) r2[k] = a == 0 ? ra[k] * ra[k] : r2[k] + ra[k] * ra[k];
        }
        for (int k = 0; k < n; ++k) distance[k] = std::sqrt(r2[k]);
        for (std::size_t i = 0; i < set_.scene.kernels.size(); ++i) {
            const KernelUse& use = set_.scene.kernels[i];
            use.kernel->evaluate(d, n, distance, use.h, nullptr, room(slope_[i]));
            weigh(room(weight_[i]), slope_[i].data());
        }
    }

    int n() const { return tile_->n; }
    const double* r(int axis) const { return r_[axis].data(); }
    const double* r2() const { return r2_.data(); }
    /// (dW/dr)/r, and the same times V_j.
    const double* slope(int kernel) const { return slope_[std::size_t(kernel)].data(); }
    const double* weight(int kernel) const { return weight_[std::size_t(kernel)].data(); }
    const double* own(int component) const { return own_[std::size_t(component)].data(); }
    const double* other(int component) const { return other_[std::size_t(component)].data(); }
    const double* own_inverse_rho() const { return own_.back().data(); }
    const double* other_inverse_rho() const { return other_.back().data(); }
    /// A scratch array of the tile's length.
    double* room(Array& array) const {
        const long need = tile_->n + overrun;
        if (long(array.size()) < need) array = Array(std::size_t(std::max(need, pairs_per_tile + overrun)));
        return array.data();
    }

private:
    const MovingSet& set_;
    std::vector<int> components_;
    const double* const* state_ = nullptr;
    const PairTile* tile_ = nullptr;
    Array r_[3], r2_, distance_, inverse_rho_;
    std::vector<Array> slope_, weight_, own_, other_;
    std::vector<Packing> packings_;

    int density() const { return set_.components.first[std::size_t(set_.scene.equations.density)]; }

    void pack_tile() {
        packings_.clear();
        for (int a = 0; a < set_.scene.box.dimension; ++a) packings_.push_back({set_.x[a], nullptr, room(r_[a])});
        for (const int c : components_)
            packings_.push_back({state_[c], room(own_[std::size_t(c)]), room(other_[std::size_t(c)])});
        if (inverse_rho_.data()) packings_.push_back({inverse_rho_.data(), room(own_.back()), room(other_.back())});
        pack(*tile_, packings_);
    }

    void weigh(double* __restrict weight, const double* __restrict slope) const {
        if (!inverse_rho_.data()) {
            for (int k = 0; k < n(); ++k) weight[k] = set_.volume * slope[k];
            return;
        }
        const double* __restrict inverse = other_inverse_rho();
        const double mass = set_.mass;
        for (int k = 0; k < n(); ++k) weight[k] = mass * inverse[k] * slope[k];
    }
};

/// In moving_program.cpp.
std::unique_ptr<Program> make_moving_program(MovingSet& set, const std::vector<int>& variables);

}    // namespace sphonic
