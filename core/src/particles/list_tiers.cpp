#include <algorithm>

#include <sphonic/error.hpp>

#include "frozen_weights.hpp"
#include "pair_set.hpp"
#include "parallel.hpp"
#include "stencil.hpp"

namespace sphonic {
namespace {

constexpr double skin_over_dx = 0.25;

/// Particles that find each other by a neighbour list. A frozen set keeps its pairs' geometry; a moving one computes it
/// at every evaluation.
class ListTier final : public Tier {
public:
    ListTier(const Case& scene, const Components& components, const double* const* x, bool frozen)
        : skin_(frozen ? 0 : skin_over_dx * scene.box.dx),
          set_{.scene = scene,
               .components = components,
               .layout = Layout::flat(scene.arrangement->size(scene.box)),
               .list = NeighbourList(scene.box, scene.arrangement->size(scene.box), scene.radius(), skin_),
               .threads = threads_for(scene)} {
        set_.volume = scene.particle_volume();
        set_.mass = scene.medium.rho0 * set_.volume;
        check_box();
        check_faces();
        if (!frozen) check_forms();
        moved(x);
        neighbours_mean_ = set_.list.mean_within_radius(x);
        if (!frozen) return;
        geometry_ = keep_geometry(set_);
        set_.kept = &geometry_;
    }

    const char* name() const override { return set_.kept ? "frozen" : "moving"; }
    const Layout& layout() const override { return set_.layout; }
    std::unique_ptr<Program> compile(const std::vector<int>& variables) override {
        if (set_.kept) return make_frozen_program(set_, weights_, variables);
        return make_pair_program(set_, whole_shares(set_.scene.equations, variables));
    }
    void fill_ghosts(int, double*, const double*, double) override {}
    void moved(const double* const* x) override {
        std::copy_n(x, set_.scene.box.dimension, set_.x);
        if (set_.list.update(x)) cut_tiles(set_);
    }
    double neighbours_mean() const override { return neighbours_mean_; }
    double bytes() const override {
        double total = set_.list.bytes() + weights_.bytes() + 8.0 * double(geometry_.r2.size());
        for (const Array& r : geometry_.r) total += 8.0 * double(r.size());
        for (const Array& slope : geometry_.slope) total += 8.0 * double(slope.size());
        return total;
    }

private:
    double skin_;
    PairSet set_;
    PairGeometry geometry_;
    FrozenWeightStore weights_{set_};
    double neighbours_mean_ = 0;

    void check_forms() const {
        for (const Variable& v : set_.scene.equations.variables)
            for (const Term& term : v.terms)
                if (term.form && term.form->correction() != abi::Correction::none)
                    throw Error(Fault::input, set_.scene.file + ": /equations/" + v.name, "corrected forms are not made for particles that move",
                                "Use \"motion\": \"frozen\", or an uncorrected form");
    }

    void check_faces() const {
        for (int a = 0; a < set_.scene.box.dimension; ++a)
            for (const bool upper : {false, true})
                if (set_.scene.closure(a, upper) == abi::Closure::mirror || set_.scene.closure(a, upper) == abi::Closure::layers)
                    throw Error(Fault::input, set_.scene.file + ": /boundaries", "walls are made for lattices that do not move",
                                "Use a frozen lattice, or periodic or free faces");
    }

    void check_box() const {
        const abi::Box& box = set_.scene.box;
        const double radius = set_.scene.radius() + skin_;
        for (int a = 0; a < box.dimension; ++a)
            if (box.periodic[a] && box.upper[a] - box.lower[a] < 2 * radius)
                throw Error(Fault::input, set_.scene.file + ": /particles/upper",
                            "the periodic axis " + std::string(1, "xyz"[a]) + " is shorter than two interaction radii of " +
                                std::to_string(radius) + " m",
                            "Lengthen the box or choose a smaller h");
    }
};

}    // namespace

std::unique_ptr<Tier> make_list_tier(const Case& scene, const Components& components, const double* const* x, bool frozen) {
    return std::make_unique<ListTier>(scene, components, x, frozen);
}

}    // namespace sphonic
