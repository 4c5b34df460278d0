#pragma once
#include <cmath>
#include <vector>

#include "media.hpp"

namespace staggered {

/// Layers along faces that damp p and u alike, by half of the exact decay over a step before each update and half after it.
class Layers {
public:
    Layers(const abi::Scene& scene, const Grid& grid, const Media& media) {
        for (int component = -1; component < grid.dimension; ++component) {
            const PointSet all = grid.all(component);
            for (std::size_t i = 0; i < all.at.size(); ++i) {
                double rate = 0;
                for (int a = 0; a < grid.dimension; ++a)
                    for (const bool upper : {false, true})
                        if (scene.face[a][upper]) {
                            const double end = grid.lower[a] + (upper ? double(grid.n[a] - 1) * grid.dx : 0);
                            rate += scene.face[a][upper]->damping(std::abs(end - all.x[a][i]), media.of(all.at[i]));
                        }
                if (rate > 0) damped(component).enlist(all.at[i], rate);
            }
        }
    }

    bool any() const { return !of_[0].stretches.empty(); }
    void start(double dt) {
        for (Damped& d : of_)
            for (double& f : d.factor) f = std::exp(-f * dt / 2);
    }
    /// Half of a step on p (-1) or a component of u.
    void apply(int component, Field& field) const {
        const Damped& d = of_[component + 1];
        const double* factor = d.factor.data();
        for (const Stretch& s : d.stretches) {
            double* f = field.data() + s.first;
#pragma omp simd
            for (std::size_t i = 0; i < s.n; ++i) f[i] *= factor[i];
            factor += s.n;
        }
    }
    double bytes() const {
        double sum = 0;
        for (const Damped& d : of_) sum += 8.0 * double(d.factor.size());
        return sum;
    }

private:
    struct Stretch {
        std::size_t first, n;
    };
    /// A field's points in layers; the factors are rates [1/s] until `start`.
    struct Damped {
        std::vector<Stretch> stretches;
        std::vector<double> factor;

        void enlist(std::size_t at, double rate) {
            if (stretches.empty() || stretches.back().first + stretches.back().n != at) stretches.push_back({at, 0});
            ++stretches.back().n;
            factor.push_back(rate);
        }
    };
    Damped of_[4];

    Damped& damped(int component) { return of_[component + 1]; }
};

/// True for a face before which a layer damps.
inline bool absorbs(const abi::Scene& scene, int axis, bool upper) {
    const abi::Boundary* face = scene.face[axis][upper];
    return face && face->damping(0, scene.medium) > 0;
}

}    // namespace staggered
