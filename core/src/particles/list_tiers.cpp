#include <algorithm>
#include <utility>

#include <sphonic/error.hpp>

#include "frozen_weights.hpp"
#include "pair_set.hpp"
#include "parallel.hpp"
#include "plain_pairs.hpp"
#include "virtual_particles.hpp"

namespace sphonic {
namespace {

/// A list begins with the least skin, whose few superfluous pairs are not worth sorting out. Where it is outdated after fewer changes of
/// positions than `worth_a_build`, the next one has twice the skin.
constexpr double least_skin_over_dx = 0.25 / 8, most_skin_over_dx = 0.25, skin_worth_narrowing_over_dx = 0.1;
constexpr long worth_a_build = 20;

/// Every neighbour must be the nearest image of its source.
void check_length(const Case& scene, int axis, double length, double least, const std::string& what) {
    if (length >= least) return;
    throw Error(Fault::input, scene.file + ": /particles/upper",
                what + " " + std::string(1, "xyz"[axis]) + " is " + std::to_string(length) + " m long, shorter than the " + std::to_string(least) +
                    " m that interaction radii take",
                "Lengthen the box or choose a smaller h");
}

/// `reach` of the neighbour list [m].
void check_faces(const Case& scene, double reach) {
    for (int a = 0; a < scene.box.dimension; ++a) {
        const double length = scene.box.upper[a] - scene.box.lower[a];
        if (scene.box.periodic[a]) check_length(scene, a, length, 2 * reach, "the periodic axis");
        bool walls = true;
        for (const bool upper : {false, true}) {
            const abi::Closure closure = scene.closure(a, upper);
            walls = walls && closure == abi::Closure::mirror;
            if (closure == abi::Closure::layers)
                throw Error(Fault::input, scene.file + ": /boundaries/" + std::to_string(scene.boundary_of[a][upper]),
                            "it continues a frozen lattice by layers of virtual particles, and this set is another one",
                            "Use a frozen lattice; to absorb on other sets, let a layer of the set before a wall damp the sound");
        }
        if (walls) check_length(scene, a, end_of_set(scene, a, true) - end_of_set(scene, a, false), reach, "between walls, the axis");
    }
}

/// Particles that find each other by a neighbour list. A frozen set keeps its pairs' geometry; a moving one computes it
/// at every evaluation.
class ListTier final : public Tier {
public:
    ListTier(const Case& scene, const Components& components, const ParticleMedia& media, const Sites& sites, const double* const* x, bool frozen)
        : reach_(scene.radius() + (frozen ? 0 : most_skin_over_dx * scene.box.dx)),
          virtuals_(scene, components, sites, x, reach_, frozen, threads_for(scene)),
          set_{.scene = scene,
               .components = components,
               .media = media,
               .layout = Layout::flat(sites.count(), virtuals_.room()),
               .list = NeighbourList(scene.box, sites.count(), scene.radius(), frozen ? 0 : least_skin_over_dx * scene.box.dx, threads_for(scene)),
               .near = NearPairs(set_.list),
               .walls = virtuals_.walls(),
               .mirrors = virtuals_.mirrors(),
               .threads = threads_for(scene)} {
        set_.volume = scene.particle_volume();
        set_.mass = scene.medium.rho0 * set_.volume;
        check_faces(scene, reach_);
        moved(x);
        neighbours_mean_ = set_.list.mean_within_radius(set_.x);
        if (!frozen) return;
        geometry_ = keep_geometry(set_);
        set_.kept = &geometry_;
    }

    const char* name() const override { return set_.kept ? "frozen" : "moving"; }
    const Layout& layout() const override { return set_.layout; }
    std::unique_ptr<Program> compile(const std::vector<int>& variables) override {
        if (set_.kept) return make_frozen_program(set_, weights_, variables);
        const std::vector<Share> shares = whole_shares(set_.scene.equations, variables);
        if (const auto plain = PlainRates::of(set_, shares)) return make_plain_program(set_, *plain);
        return make_pair_program(set_, shares);
    }
    void fill_ghosts(int component, double* field, const double*, double) override { virtuals_.fill(component, field); }
    void moved(const double* const* x) override {
        virtuals_.follow(x);
        for (int a = 0; a < set_.scene.box.dimension; ++a) set_.x[a] = virtuals_.x(a);
        const double dx = set_.scene.box.dx;
        ++moves_;
        if (set_.list.outdated(set_.x)) {
            virtuals_.renew();
            if (std::exchange(moves_, 0) < worth_a_build) set_.list.widen(reach_ - set_.scene.radius());
            set_.list.build(set_.x, virtuals_.count());
            set_.near.cut(pairs_per_tile);
            set_.near.take_all();
        }
        if (set_.list.skin() > skin_worth_narrowing_over_dx * dx) set_.near.narrow(set_.x, set_.layout.particles() + virtuals_.count(), set_.threads);
    }
    double neighbours_mean() const override { return neighbours_mean_; }
    double damping() const override { return weights_.cloud().damping(); }
    double bytes() const override {
        double total = set_.list.bytes() + weights_.bytes() + virtuals_.bytes() + 8.0 * double(geometry_.r2.size());
        for (const Array& r : geometry_.r) total += 8.0 * double(r.size());
        for (const Array& slope : geometry_.slope) total += 8.0 * double(slope.size());
        return total;
    }

private:
    double reach_;    ///< of the widest list [m]
    long moves_ = worth_a_build;    ///< since the list was built
    VirtualParticles virtuals_;
    PairSet set_;
    PairGeometry geometry_;
    FrozenWeightStore weights_{set_};
    double neighbours_mean_ = 0;
};

}    // namespace

std::unique_ptr<Tier> make_list_tier(const Case& scene, const Components& components, const ParticleMedia& media, const Sites& sites, const double* const* x,
                                     bool frozen) {
    return std::make_unique<ListTier>(scene, components, media, sites, x, frozen);
}

}    // namespace sphonic
