#include "repeated_box.hpp"

#include <cmath>

namespace sphonic {
namespace {

enum class Face { periodic, mirror, open, other };

Face face_of(const Case& scene, int axis, bool upper) {
    const abi::Boundary* face = scene.face(axis, upper);
    if (!face || face->closure() == abi::Closure::free || face->damping(0, scene.medium) > 0) return Face::open;
    if (face->closure() == abi::Closure::layers || face->admittance() > 0) return Face::other;
    return face->closure() == abi::Closure::periodic ? Face::periodic : Face::mirror;
}

/// Spacings from which no sound comes back by the end of the run.
double room_of(const Case& scene) { return std::ceil(1.1 * scene.medium.c0 * scene.until / scene.box.dx) + 8; }

}    // namespace

bool repeats(const Case& scene) {
    constexpr double most_room = 1e6;    // spacings beyond an open face
    const bool leaves = room_of(scene) < most_room;
    if (!scene.regular() || scene.media->several()) return false;
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true})
            if (const Face face = face_of(scene, a, upper); face == Face::other || (face == Face::open && !leaves)) return false;
    return true;
}

RepeatedBox::RepeatedBox(const Case& scene) : scene_(scene) {
    for (int a = 0; a < 3; ++a) {
        if (a < scene.box.dimension)
            unfold(a);
        else
            images_[a].push_back({0, {1, 1, 1}});
        count_[std::size_t(a)] = long(images_[a].size());
    }
}

void RepeatedBox::unfold(int a) {
    const abi::Box& box = scene_.box;
    const Face ends[2] = {face_of(scene_, a, false), face_of(scene_, a, true)};
    const long n = box.count[a], room = long(std::min(room_of(scene_), 1e18));
    const auto at = [&](double s) { return box.lower[a] + s * box.dx; };
    opened_ = opened_ || ends[0] == Face::open || ends[1] == Face::open;
    if (ends[0] == Face::periodic || (ends[0] == Face::open && ends[1] == Face::open)) {
        first_[std::size_t(a)] = ends[0] == Face::periodic ? 0 : room / 2;
        const long all = n + (ends[0] == Face::periodic ? 0 : room);
        for (long i = 0; i < all; ++i) images_[a].push_back({at(double(i - first_[std::size_t(a)])), {1, 1, 1}});
        return;
    }
    double wall[2] = {0, double(n - 1)}, parity[2][3];    // in spacings; an open end is a rigid wall further away
    for (const bool upper : {false, true}) {
        const abi::Boundary* face = scene_.face(a, upper);
        const bool mirror = ends[upper] == Face::mirror;
        wall[upper] += (upper ? 1 : -1) * (mirror ? 0.5 * face->half_way() : double(room / 2));
        for (int part = 0; part < 3; ++part) parity[upper][part] = mirror ? face->parity(abi::Part(part)) : part == int(abi::Part::normal) ? -1 : 1;
    }
    const double length = wall[1] - wall[0];
    const long begin = long(std::ceil(wall[0])), all = std::lround((parity[0][0] == parity[1][0] ? 2 : 4) * length);
    first_[std::size_t(a)] = -begin;
    for (long i = 0; i < all; ++i) {
        Image image{0, {1, 1, 1}};
        double s = double(begin + i);
        while (s < wall[0] || s > wall[1]) {
            const bool upper = s > wall[1];
            s = 2 * wall[upper] - s;
            for (int part = 0; part < 3; ++part) image.sign[part] *= parity[upper][part];
        }
        for (const bool upper : {false, true})
            for (int part = 0; part < 3 && s == wall[upper]; ++part)
                if (parity[upper][part] < 0) image.sign[part] = 0;
        image.x = at(s);
        images_[a].push_back(image);
    }
}

std::array<double, 3> RepeatedBox::wave_vector(long component) const {
    std::array<double, 3> k{0, 0, 0};
    for (std::size_t a = 0; a < 3; ++a) {
        const long n = count_[a], m = component % n;
        k[a] = 2 * std::acos(-1.0) * double(2 * m > n ? m - n : m) / (double(n) * scene_.box.dx);
        component /= n;
    }
    return k;
}

long RepeatedBox::opposite(long component) const {
    long place = 0, stride = 1;
    for (const long n : count_) {
        place += stride * ((n - component % n) % n);
        component /= n;
        stride *= n;
    }
    return place;
}

bool RepeatedBox::initial(const std::string& variable, int axis, std::vector<double>& out) const {
    const std::size_t row = images_[0].size();
    std::vector<double> x[3] = {std::vector<double>(row), std::vector<double>(row), std::vector<double>(row)};
    for (std::size_t i = 0; i < row; ++i) x[0][i] = images_[0][i].x;
    out.resize(std::size_t(size()));
    std::size_t begin = 0;
    for (const Image& z : images_[2])
        for (const Image& y : images_[1]) {
            x[1].assign(row, y.x);
            x[2].assign(row, z.x);
            const abi::Points points{scene_.box.dimension, int(row), {x[0].data(), x[1].data(), x[2].data()}};
            if (!scene_.initial_values(variable, std::max(0, axis), points, out.data() + begin)) return false;
            const auto part = [&](int a) { return axis < 0 ? int(abi::Part::scalar) : int(a == axis ? abi::Part::normal : abi::Part::tangential); };
            for (std::size_t i = 0; i < row; ++i) out[begin + i] *= images_[0][i].sign[part(0)] * y.sign[part(1)] * z.sign[part(2)];
            begin += row;
        }
    return true;
}

std::vector<long> RepeatedBox::own() const {
    std::vector<long> places;
    const abi::Box& box = scene_.box;
    for (long k = 0; k < box.count[2]; ++k)
        for (long j = 0; j < box.count[1]; ++j)
            for (long i = 0; i < box.count[0]; ++i)
                places.push_back(i + first_[0] + count_[0] * (j + first_[1] + count_[1] * (k + first_[2])));
    return places;
}

}    // namespace sphonic
