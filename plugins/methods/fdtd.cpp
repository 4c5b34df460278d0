#include <sphonic/plugin/method.hpp>

#include "fdtd/staggered_grid.hpp"

/// Finite differences, staggered in time and space (Yee's scheme for sound):
///   u_a[i+1/2] -= dt/(rho0 dx) D p,   p[i] -= K dt/dx sum_a D u_a,   K = rho0 c0^2.
/// p lies on the case's lattice, u_a half a spacing beyond it along axis a and half a step behind it in time. D f = f[i+1/2] - f[i-1/2]
/// at order 2; 9/8 of that less 1/24 (f[i+3/2] - f[i-3/2]) at order 4 in space. In time the order is 2.
/// Stable to c0 dt/dx = 1/sqrt(d), where order 2 is exact along the diagonal; 6/7 of that at order 4.
///
/// Walls are mirrors, rigid or soft, on the last points of p or half a spacing beyond them, as for particles: both are exact on this
/// grid. A face without a boundary is a rigid wall half a spacing beyond. absorbing_mur and soft_fdtd act on one layer of p beyond the
/// last points, at order 2. Several media: staggered/media.hpp says how points near interfaces take them.
///
/// Bodies are staircases: a cell is solid if its point lies in one, so that a curved wall is right to the first order only, at order 4
/// too, which falls to 2 where its differences would reach into a body. fdtd/bodies.hpp says how. The stable step stays the same.
struct Fdtd final : abi::Method {
    int order = 2;

    static constexpr auto parameters() { return std::array{integer("order", &Fdtd::order, 2, 4, "in space: 2 or 4")}; }

    bool meshfree() const override { return false; }
    bool several_media() const override { return true; }
    bool bodies() const override { return true; }
    bool carry(const abi::Medium& medium, const abi::Box& box, double dt, const double* k, abi::CarriedWave& wave) const override {
        wave = fdtd::carried(medium, box.dimension, box.dx, order, dt, k);
        return true;
    }
    std::unique_ptr<abi::Solver> discretise(const abi::Scene& scene) const override {
        if (order == 3) throw std::invalid_argument("there is no order 3 in space: choose 2 or 4");
        for (int a = 0; a < scene.box.dimension; ++a)
            if (scene.box.count[a] < order) throw std::invalid_argument("order 4 needs four points along each axis: choose order 2, or a smaller dx");
        return scene.box.dimension == 1 ? in<1>(scene) : scene.box.dimension == 2 ? in<2>(scene) : in<3>(scene);
    }

private:
    template <int d>
    std::unique_ptr<abi::Solver> in(const abi::Scene& scene) const {
        const bool several = scene.media.count > 1;
        if (order == 2) return several ? make<d, 2, true>(scene) : make<d, 2, false>(scene);
        return several ? make<d, 4, true>(scene) : make<d, 4, false>(scene);
    }
    template <int d, int order, bool several>
    static std::unique_ptr<abi::Solver> make(const abi::Scene& scene) {
        return std::make_unique<fdtd::StaggeredGrid<d, order, several>>(scene);
    }
};

SPHONIC_METHOD("fdtd", Fdtd, "Staggered finite differences, of order 2 or 4 in space: the plain baseline on the same case")
