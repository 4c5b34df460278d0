#include <algorithm>

#include <sphonic/error.hpp>

#include "moving_set.hpp"
#include "stencil.hpp"

namespace sphonic {
namespace {

constexpr double skin_over_dx = 0.25;

class MovingTier final : public Tier {
public:
    MovingTier(const Case& scene, const Components& components, const double* const* x)
        : set_{.scene = scene,
               .components = components,
               .layout = Layout::flat(scene.arrangement->size(scene.box)),
               .list = NeighbourList(scene.box, scene.arrangement->size(scene.box), scene.radius(), skin_over_dx * scene.box.dx)} {
        set_.volume = lattice_volume(scene.box);
        set_.mass = scene.medium.rho0 * set_.volume;
        check_box();
        std::copy_n(x, scene.box.dimension, set_.x);
        set_.list.update(x);
        neighbours_mean_ = set_.list.mean_within_radius(x);
    }

    const char* name() const override { return "moving"; }
    const Layout& layout() const override { return set_.layout; }
    std::unique_ptr<Program> compile(const std::vector<int>& variables) override {
        return make_moving_program(set_, variables);
    }
    void fill_ghosts(double*) const override {}
    void moved(const double* const* x) override {
        std::copy_n(x, set_.scene.box.dimension, set_.x);
        set_.list.update(x);
    }
    double neighbours_mean() const override { return neighbours_mean_; }
    double bytes() const override { return set_.list.bytes(); }

private:
    MovingSet set_;
    double neighbours_mean_ = 0;

    void check_box() const {
        const abi::Box& box = set_.scene.box;
        const double radius = set_.scene.radius() + skin_over_dx * box.dx;
        for (int a = 0; a < box.dimension; ++a)
            if (box.periodic[a] && box.upper[a] - box.lower[a] < 2 * radius)
                throw Error(Fault::input, set_.scene.file + ": /particles/upper",
                            "the periodic axis " + std::string(1, "xyz"[a]) + " is shorter than two interaction radii of " +
                                std::to_string(radius) + " m",
                            "Lengthen the box or choose a smaller h");
    }
};

}    // namespace

std::unique_ptr<Tier> make_moving_tier(const Case& scene, const Components& components, const double* const* x) {
    return std::make_unique<MovingTier>(scene, components, x);
}

}    // namespace sphonic
