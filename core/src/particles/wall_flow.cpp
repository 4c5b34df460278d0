#include "wall_flow.hpp"

#include <sphonic/error.hpp>

#include "../theory/wall_footprint.hpp"
#include "parallel.hpp"

namespace sphonic {

WallFlow::WallFlow(const Case& scene, const ParticleMedia& media, const Layout& layout, int threads, double dt) : threads_(threads) {
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true})
            if (const abi::Boundary* face = scene.face(a, upper); face && face->admittance() > 0) add_face(scene, media, layout, a, upper, dt);
}

void WallFlow::add_face(const Case& scene, const ParticleMedia& media, const Layout& layout, int axis, bool upper, double dt) {
    const std::string place = scene.file + ": /boundaries/" + std::to_string(scene.boundary_of[axis][upper]);
    if (!scene.regular() || scene.motion != Motion::frozen)
        throw Error(Fault::input, place, "it gives way on regular sets that keep their places, and this is another one",
                    "Use a frozen lattice without jitter, or a layer that damps before a wall");
    Face face;
    face.read = wall_footprint(scene, axis, dt);
    const long n = scene.box.count[axis], length = long(face.read.size());
    if (n < length)
        throw Error(Fault::input, place, "its footprint takes " + std::to_string(length) + " particles along the normal, and there are " + std::to_string(n),
                    "Lengthen the box or choose a smaller dx");
    face.put = face.read;
    face.put[0] *= 2;
    for (long i = 0; i < length; ++i) face.beta += face.read[std::size_t(i)] * face.put[std::size_t(i)];
    const auto index = field_indices(layout);
    long stride = 1;
    for (int a = 0; a < axis; ++a) stride *= scene.box.count[a];
    face.inward = (index[std::size_t(stride)] - index[0]) * (upper ? -1 : 1);
    for (long i = 0; i < long(index.size()); ++i) {
        if (i / stride % n != (upper ? n - 1 : 0)) continue;
        face.at.push_back(index[std::size_t(i)]);
        face.rate.push_back(bulk_modulus(media.of(i)) * scene.face(axis, upper)->admittance() * dt / scene.box.dx);
    }
    face.pressure.resize(face.at.size());
    faces_.push_back(std::move(face));
}

double WallFlow::Face::value(const double* line, double rest) const {
    double sum = 0;
    for (std::size_t m = 0; m < read.size(); ++m) sum += read[m] * (line[std::ptrdiff_t(m) * inward] - rest);
    return sum;
}

void WallFlow::begin(const double* field, double rest) {
    for (Face& f : faces_)
        for (std::size_t i = 0; i < f.at.size(); ++i) f.pressure[i] = f.value(field + f.at[i], rest);
}

std::vector<std::span<double>> WallFlow::remembered() {
    std::vector<std::span<double>> all;
    for (Face& f : faces_) all.emplace_back(f.pressure);
    return all;
}

void WallFlow::apply(double* field, double rest) {
    for (Face& f : faces_)
        in_blocks(threads_, long(f.at.size()), [&](long begin, long end) {
            for (auto i = std::size_t(begin); i < std::size_t(end); ++i) {
                double* line = field + f.at[i];
                const double mean = (f.pressure[i] + f.value(line, rest)) / (2 + f.rate[i] * f.beta);
                for (std::size_t m = 0; m < f.put.size(); ++m) line[std::ptrdiff_t(m) * f.inward] -= f.rate[i] * mean * f.put[m];
                f.pressure[i] = 2 * mean - f.pressure[i];
            }
        });
}

}    // namespace sphonic
