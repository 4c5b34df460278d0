#include "virtual_particles.hpp"

#include <algorithm>

#include <sphonic/error.hpp>

#include "lanes.hpp"
#include "parallel.hpp"

namespace sphonic {
namespace {

/// The set's own particles and those behind the walls of obstacles, as they begin.
struct Beginning {
    Places all;
    const double* x[3] = {};

    Beginning(const Sites& sites, const ObstacleWalls& walls) {
        double* behind[3] = {};
        for (int a = 0; a < 3; ++a) {
            if (sites.own[a].empty()) continue;
            all[a] = sites.own[a];
            all[a].resize(all[a].size() + std::size_t(walls.count()));
            x[a] = all[a].data();
            behind[a] = all[a].data() + sites.own[a].size();
        }
        walls.place(behind);
    }
};

}    // namespace

VirtualParticles::VirtualParticles(const Case& scene, const Components& components, const Sites& sites, const double* const* x, double reach,
                                   bool frozen, int threads)
    : scene_(scene), n_(sites.count()), reach_(reach), threads_(threads), walls_(scene, components, sites, reach, threads),
      mirrors_(scene, components, Beginning(sites, walls_).x, n_ + walls_.count(), threads), fields_(std::size_t(components.count)) {
    mirrors_.choose(Beginning(sites, walls_).x, reach);
    room_ = walls_.count() + (frozen ? mirrors_.count() : std::max(mirrors_.count(), mirrors_.most(reach)));
    for (int a = 0; a < scene.box.dimension && needed(); ++a) position_[a] = Array(std::size_t(n_ + room_ + overrun));
    follow(x);
    walls_.fit(x_, mirrors_);
}

void VirtualParticles::follow(const double* const* x) {
    if (!needed()) return void(std::copy_n(x, scene_.box.dimension, x_));
    double *all[3] = {}, *behind[3] = {};
    for (int a = 0; a < scene_.box.dimension; ++a) {
        x_[a] = all[a] = position_[a].data();
        behind[a] = all[a] + n_;
        in_blocks(threads_, n_, [=](long begin, long end) { std::copy(x[a] + begin, x[a] + end, all[a] + begin); });
    }
    walls_.place(behind);
    mirrors_.place(all);
}

void VirtualParticles::renew() {
    if (!mirrors_.needed()) return;
    mirrors_.choose(x_, reach_);
    if (count() > room_)
        throw Error(Fault::diverged, scene_.file + ": /boundaries",
                    "the walls need " + std::to_string(count()) + " virtual particles; a set of twice the density would need " + std::to_string(room_),
                    "See why particles crowd at the walls, such as by a smaller step");
    double* all[3] = {position_[0].data(), position_[1].data(), position_[2].data()};
    mirrors_.place(all);
    for (std::size_t c = 0; c < fields_.size(); ++c)
        if (fields_[c]) fill(int(c), fields_[c]);
}

void VirtualParticles::fill(int component, double* field) {
    fields_[std::size_t(component)] = field;
    mirrors_.fill(component, field);
    if (walls_.count() == 0) return;
    for (int filled = walls_.fill(component, field); filled > 0; --filled) {
        const int c = component + 1 - filled;
        mirrors_.fill(c, fields_[std::size_t(c)]);
    }
}

double VirtualParticles::bytes() const {
    double total = walls_.bytes();
    for (const Array& x : position_) total += 8.0 * double(x.size());
    return total;
}

}    // namespace sphonic
