#include <algorithm>

#include <sphonic/error.hpp>

#include "frozen_weights.hpp"
#include "pair_set.hpp"
#include "parallel.hpp"

namespace sphonic {
namespace {

constexpr double skin_over_dx = 0.25;

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
    ListTier(const Case& scene, const Components& components, const ParticleMedia& media, const double* const* x, bool frozen)
        : reach_(scene.radius() + (frozen ? 0 : skin_over_dx * scene.box.dx)),
          mirrors_(scene, components, x, threads_for(scene)),
          set_{.scene = scene,
               .components = components,
               .media = media,
               .layout = Layout::flat(scene.arrangement->size(scene.box), room(x, frozen)),
               .list = NeighbourList(scene.box, scene.arrangement->size(scene.box), scene.radius(), reach_ - scene.radius()),
               .mirrors = mirrors_,
               .threads = threads_for(scene)},
          fields_(std::size_t(components.count)) {
        set_.volume = scene.particle_volume();
        set_.mass = scene.medium.rho0 * set_.volume;
        check_faces(scene, reach_);
        for (int a = 0; a < scene.box.dimension && mirrors_.needed(); ++a) position_[a] = Array(std::size_t(set_.layout.size));
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
        return make_pair_program(set_, whole_shares(set_.scene.equations, variables));
    }
    void fill_ghosts(int component, double* field, const double*, double) override {
        fields_[std::size_t(component)] = field;
        mirrors_.fill(component, field);
    }
    void moved(const double* const* x) override {
        follow(x);
        if (!set_.list.outdated(set_.x)) return;
        if (mirrors_.needed()) renew_images();
        set_.list.build(set_.x, mirrors_.count());
        cut_tiles(set_);
    }
    double neighbours_mean() const override { return neighbours_mean_; }
    double bytes() const override {
        double total = set_.list.bytes() + weights_.bytes() + 8.0 * double(geometry_.r2.size());
        for (const Array& r : geometry_.r) total += 8.0 * double(r.size());
        for (const Array& slope : geometry_.slope) total += 8.0 * double(slope.size());
        for (const Array& x : position_) total += 8.0 * double(x.size());
        return total;
    }

private:
    double reach_;    ///< of the list [m]
    MirrorParticles mirrors_;
    PairSet set_;
    PairGeometry geometry_;
    FrozenWeightStore weights_{set_};
    Array position_[3];              ///< of own and virtual particles, where there are walls
    std::vector<double*> fields_;    ///< by component, where the state lies
    double neighbours_mean_ = 0;

    /// For virtual particles, of which a set that moves may come to need more.
    long room(const double* const* x, bool frozen) {
        mirrors_.choose(x, reach_);
        return frozen ? mirrors_.count() : std::max(mirrors_.count(), mirrors_.most(reach_));
    }

    void follow(const double* const* x) {
        const long n = set_.layout.particles();
        double* own[3] = {position_[0].data(), position_[1].data(), position_[2].data()};
        for (int a = 0; a < set_.scene.box.dimension; ++a) {
            set_.x[a] = mirrors_.needed() ? own[a] : x[a];
            if (mirrors_.needed())
                in_blocks(set_.threads, n, [=](long begin, long end) { std::copy(x[a] + begin, x[a] + end, own[a] + begin); });
        }
        if (mirrors_.needed()) mirrors_.place(own);
    }

    /// Other virtual particles for the present positions, with the values of their sources.
    void renew_images() {
        mirrors_.choose(set_.x, reach_);
        const long room = set_.layout.size - overrun - set_.layout.particles();
        if (mirrors_.count() > room)
            throw Error(Fault::diverged, set_.scene.file + ": /boundaries",
                        "the walls need " + std::to_string(mirrors_.count()) + " virtual particles; a set of twice the density would need " + std::to_string(room),
                        "See why particles crowd at the walls, such as by a smaller step");
        double* own[3] = {position_[0].data(), position_[1].data(), position_[2].data()};
        mirrors_.place(own);
        for (std::size_t c = 0; c < fields_.size(); ++c)
            if (fields_[c]) mirrors_.fill(int(c), fields_[c]);
    }
};

}    // namespace

std::unique_ptr<Tier> make_list_tier(const Case& scene, const Components& components, const ParticleMedia& media, const double* const* x, bool frozen) {
    return std::make_unique<ListTier>(scene, components, media, x, frozen);
}

}    // namespace sphonic
