/// What makes a set blue noise: points that keep their distance, without order and without long waves in their density.
#include <sphonic/plugin/abi/arrangement.hpp>

#include <complex>
#include <numbers>

#include "subjects.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

constexpr double dx = 0.1;

abi::Box box_of(int dimension, int n, bool periodic) {
    abi::Box box{.dimension = dimension, .dx = dx};
    for (int a = 0; a < dimension; ++a) {
        box.lower[a] = -0.5 + a;
        box.upper[a] = box.lower[a] + n * dx;
        box.periodic[a] = periodic;
        box.count[a] = n + !periodic;
    }
    return box;
}

using Places = std::vector<double>[3];

void place(const abi::Box& box, std::int64_t seed, Places& x) {
    const auto noise = make<abi::Arrangement>("blue_noise");
    noise->seed(seed);
    noise->prepare(box);
    double* out[3] = {};
    for (int a = 0; a < box.dimension; ++a) {
        x[a].resize(std::size_t(noise->size(box)));
        out[a] = x[a].data();
    }
    noise->place(box, out);
}

double least_distance(const abi::Box& box, const Places& x) {
    double least = 1e9;
    for (std::size_t i = 0; i < x[0].size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            double sum = 0;
            for (int a = 0; a < box.dimension; ++a) {
                double r = x[a][i] - x[a][j];
                const double length = box.upper[a] - box.lower[a];
                if (box.periodic[a]) r -= length * std::round(r / length);
                sum += r * r;
            }
            least = std::min(least, std::sqrt(sum));
        }
    return least;
}

/// |sum exp(-i k . x)|^2 / n of a plane set, for the wave with p and q periods in the box: one, on average, for random points.
double power(const abi::Box& box, const Places& x, int p, int q) {
    std::complex<double> sum = 0;
    const double length = box.upper[0] - box.lower[0];
    for (std::size_t i = 0; i < x[0].size(); ++i)
        sum += std::polar(1.0, 2 * std::numbers::pi * (p * x[0][i] + q * x[1][i]) / length);
    return std::norm(sum) / double(x[0].size());
}

}    // namespace

TEST_CASE("blue noise has a lattice's number of particles, which keep 0.6 dx from each other", "[arrangement][blue_noise]") {
    for (const int d : {1, 2, 3})
        for (const bool periodic : {true, false})
            for (const std::int64_t seed : {1, 2, 3}) {
                const int n = d == 3 ? 8 : 20;
                const abi::Box box = box_of(d, n, periodic);
                Places x;
                place(box, seed, x);
                INFO(d << "-D, " << (periodic ? "periodic" : "bounded") << ", seed " << seed);
                CHECK(double(x[0].size()) == std::pow(n + !periodic, d));
                CHECK(least_distance(box, x) > 0.6 * dx);
            }
}

TEST_CASE("each face of a bounded box holds a layer of blue noise, and its corners a particle", "[arrangement][blue_noise]") {
    const int n = 9;
    const abi::Box box = box_of(3, n, false);
    Places x;
    place(box, 5, x);
    long on_face[3][2] = {}, corners = 0;
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        int faces = 0;
        for (int a = 0; a < 3; ++a) {
            CHECK(x[a][i] >= box.lower[a]);
            CHECK(x[a][i] <= box.upper[a]);
            on_face[a][0] += x[a][i] == box.lower[a];
            on_face[a][1] += x[a][i] == box.upper[a];
            faces += x[a][i] == box.lower[a] || x[a][i] == box.upper[a];
        }
        corners += faces == 3;
    }
    for (const auto& face : on_face)
        for (const long particles : face) CHECK(particles == (n + 1) * (n + 1));
    CHECK(corners == 8);
}

TEST_CASE("blue noise is the same for the same seed, and another for another", "[arrangement][blue_noise]") {
    const abi::Box box = box_of(2, 12, true);
    Places one, again, other;
    place(box, 7, one);
    place(box, 7, again);
    place(box, 8, other);
    for (int a = 0; a < 2; ++a) {
        CHECK(one[a] == again[a]);
        CHECK(gap(one[a], other[a]) > 0.1 * dx);
    }
}

TEST_CASE("the density of blue noise has no long waves, and its short ones no direction", "[arrangement][blue_noise]") {
    constexpr int n = 32, seeds = 4, sectors = 6;
    const abi::Box box = box_of(2, n, true);
    double long_waves = 0, peak[sectors] = {};
    long longs = 0, waves[sectors] = {};
    for (std::int64_t seed = 1; seed <= seeds; ++seed) {
        Places x;
        place(box, seed, x);
        for (int p = -40; p <= 40; p += 2)
            for (int q = 0; q <= 40; q += 2) {
                const double k = std::hypot(p, q) / n, angle = std::atan2(q, p) / std::numbers::pi;    // peak at k = 1 or so [1/dx]
                if (k > 0 && k < 0.5) long_waves += power(box, x, p, q), ++longs;
                if (k < 0.9 || k > 1.2 || angle >= 1) continue;
                peak[int(angle * sectors)] += power(box, x, p, q);
                ++waves[int(angle * sectors)];
            }
    }
    CHECK(long_waves / double(longs) < 0.02);
    double mean = 0;
    for (int s = 0; s < sectors; ++s) mean += peak[s] / double(waves[s]) / sectors;
    CHECK(mean > 1.5);
    for (int s = 0; s < sectors; ++s) CHECK(peak[s] / double(waves[s]) == Approx(mean).epsilon(0.25));
}
