#include "mirror_particles.hpp"

#include <algorithm>
#include <cmath>

#include "parallel.hpp"

namespace sphonic {

double end_of_set(const Case& scene, int axis, bool upper) {
    const abi::Box& box = scene.box;
    if (!upper) return box.lower[axis];
    return scene.arrangement->regular() ? box.lower[axis] + double(box.count[axis] - 1) * box.dx : box.upper[axis];
}

bool on_end(const Case& scene, int axis, bool upper, double x) {
    return std::abs(x - end_of_set(scene, axis, upper)) < 1e-6 * scene.box.dx;
}

MirrorParticles::MirrorParticles(const Case& scene, const Components& components, const double* const* x, long n, int threads)
    : scene_(scene), components_(components), n_(n), threads_(threads) {
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true}) {
            if (scene.closure(a, upper) != abi::Closure::mirror) continue;
            Wall wall{a, upper, end_of_set(scene, a, upper), scene.face(a, upper), {}};
            on_.resize(std::size_t(n_));
            if (wall.boundary->half_way()) {
                wall.plane += (upper ? 0.5 : -0.5) * scene.box.dx;
            } else {
                for (long i = 0; i < n_; ++i) {
                    if (!on_end(scene, a, upper, x[a][i])) continue;
                    wall.on.push_back(std::int32_t(i));
                    on_[std::size_t(i)] |= wall.bit();
                }
            }
            walls_.push_back(std::move(wall));
        }
    find_signs(components.positions < 0 ? components.count : components.positions);
}

long MirrorParticles::most(double reach) const {
    double own = 1, all = 1, copies = 1;
    for (int a = 0; a < scene_.box.dimension; ++a) {
        int walls = 0;
        for (const Wall& wall : walls_) walls += wall.axis == a;
        const double length = scene_.box.upper[a] - scene_.box.lower[a] + scene_.box.dx;
        own *= length;
        all *= length + walls * reach;
        copies *= 1 + walls;
    }
    const double everyone = double(n_) * (copies - 1);
    return long(std::ceil(std::min(everyone, 2 * (all - own) / scene_.particle_volume())));
}

void MirrorParticles::choose(const double* const* x, double reach) {
    source_.clear();
    faces_.clear();
    long before = 0;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        if (w == 0 || walls_[w - 1].axis != walls_[w].axis) before = count();
        reflect(walls_[w], x[walls_[w].axis], reach, before);
    }
}

/// Images of the n particles and of the first `images_before` virtual ones: reflection in other axes has not changed their
/// coordinate along this one.
void MirrorParticles::reflect(const Wall& wall, const double* x, double reach, long images_before) {
    for (long j = 0; j < n_ + images_before; ++j) {
        const long i = source(j);
        if (on_[std::size_t(i)] & wall.bit() || !(std::abs(wall.depth(x[i])) < reach)) continue;
        const std::uint8_t faces = j < n_ ? 0 : faces_[std::size_t(j - n_)];
        source_.push_back(std::int32_t(i));
        faces_.push_back(faces | wall.bit());
    }
}

void MirrorParticles::place(double* const* x) const {
    for (int a = 0; a < scene_.box.dimension; ++a) {
        double shift[4] = {};    // by the axis' bits
        for (const Wall& wall : walls_)
            if (wall.axis == a) shift[1 + wall.upper] = 2 * wall.plane;
        in_blocks(threads_, count(), [&](long begin, long end) {
            for (long v = begin; v < end; ++v) {
                const double own = x[a][source_[std::size_t(v)]];
                const int bits = faces_[std::size_t(v)] >> 2 * a & 3;
                x[a][n_ + v] = bits ? shift[bits] - own : own;
            }
        });
    }
}

void MirrorParticles::find_signs(int components) {
    signs_.assign(std::size_t(components), {});
    for (int c = 0; c < components; ++c) {
        auto& sign = signs_[std::size_t(c)];
        sign.fill(1);
        for (const Wall& wall : walls_)
            for (std::size_t faces = 0; faces < sign.size(); ++faces)
                if (faces & wall.bit()) sign[faces] *= parity(wall, c);
    }
}

void MirrorParticles::fill(int component, double* field) const {
    const double rest = components_.rest(component);
    for (const Wall& wall : walls_)
        if (parity(wall, component) < 0)
            for (const std::int32_t i : wall.on) field[i] = rest;
    const auto& sign = signs_[std::size_t(component)];
    in_blocks(threads_, count(), [&](long begin, long end) {
        for (long v = begin; v < end; ++v)
            field[n_ + v] = rest + sign[faces_[std::size_t(v)]] * (field[source_[std::size_t(v)]] - rest);
    });
}

void MirrorParticles::fill_derivative(int component, int axis, double* field) const {
    const auto& parity = signs_[std::size_t(component)];
    in_blocks(threads_, count(), [&](long begin, long end) {
        for (long v = begin; v < end; ++v)
            field[n_ + v] = parity[faces_[std::size_t(v)]] * sign(n_ + v, axis) * field[source_[std::size_t(v)]];
    });
}

}    // namespace sphonic
