#include "wall_smoothing.hpp"

#include <algorithm>
#include <cmath>

#include "local_fit.hpp"
#include "parallel.hpp"
#include "wall_view.hpp"

namespace sphonic {
namespace {

/// Heights over the nearest wall [m]; nothing counts beyond `most`.
std::vector<double> heights(const Case& scene, const Sites& sites, double most) {
    std::vector<double> height(sites.own[0].size(), most);
    for (const Obstacle& obstacle : scene.obstacles) {
        if (!obstacle.walled()) continue;
        const WallView view(scene, obstacle, sites.own);
        for (std::size_t i = 0; i < height.size(); ++i) height[i] = std::min(height[i], view.distance[i]);
    }
    return height;
}

}    // namespace

WallSmoothing::WallSmoothing(const Case& scene, const Sites& sites, int threads) : speed_(scene.medium.c0 / scene.box.dx), threads_(threads) {
    find_rows(scene, sites);
    transpose();
    rough_.resize(rows_.number.size());
}

void WallSmoothing::find_rows(const Case& scene, const Sites& sites) {
    const double length = radius * scene.box.dx;
    const std::vector<double> height = heights(scene, sites, 2 * length);
    std::vector<std::int32_t> around;    // whoever can be in a row
    Places at, at_around;
    for (std::size_t i = 0; i < height.size(); ++i) {
        if (height[i] >= 2 * length) continue;
        around.push_back(std::int32_t(i));
        if (height[i] < length) rows_.number.push_back(std::int32_t(i));
        for (int a = 0; a < scene.box.dimension; ++a) {
            at_around[a].push_back(sites.own[a][i]);
            if (height[i] < length) at[a].push_back(sites.own[a][i]);
        }
    }
    const Near near(scene.box, at, at_around, length);
    for (std::size_t row = 0; row < rows_.number.size(); ++row) {
        LocalFit fit(scene.box.dimension + 1);
        rows_.start.push_back(std::int64_t(rows_.column.size()));
        for (std::int64_t k = near.start[row]; k < near.start[row + 1]; ++k) {
            const std::size_t j = std::size_t(near.index[std::size_t(k)]);
            LocalFit::Basis linear{1};
            for (int a = 0; a < scene.box.dimension; ++a) linear[std::size_t(a) + 1] = apart(scene.box, a, at_around[a][j] - at[a][row]) / length;
            fit.add(linear, LocalFit::closeness(std::hypot(linear[1], linear[2], linear[3])));
            rows_.column.push_back(around[j]);
        }
        for (const double w : fit.weights({1})) rows_.value.push_back((rows_.column[rows_.value.size()] == rows_.number[row]) - w);
    }
    rows_.start.push_back(std::int64_t(rows_.column.size()));
}

/// Rows of the transpose, by particle.
void WallSmoothing::transpose() {
    std::vector<std::array<std::int32_t, 2>> entries;    // particle, place in R
    std::vector<std::int32_t> row_of;
    for (std::size_t row = 0; row < rows_.number.size(); ++row)
        for (std::int64_t k = rows_.start[row]; k < rows_.start[row + 1]; ++k) {
            entries.push_back({rows_.column[std::size_t(k)], std::int32_t(k)});
            row_of.push_back(std::int32_t(row));
        }
    std::sort(entries.begin(), entries.end());
    for (const auto& [particle, place] : entries) {
        if (columns_.number.empty() || columns_.number.back() != particle) {
            columns_.number.push_back(particle);
            columns_.start.push_back(std::int64_t(columns_.column.size()));
        }
        columns_.column.push_back(row_of[std::size_t(place)]);
        columns_.value.push_back(rows_.value[std::size_t(place)]);
    }
    columns_.start.push_back(std::int64_t(columns_.column.size()));
}

void WallSmoothing::apply(double* field, double dt) {
    const auto product = [](const Matrix& m, long row, const double* x) {
        double sum = 0;
        for (std::int64_t k = m.start[std::size_t(row)]; k < m.start[std::size_t(row) + 1]; ++k) sum += m.value[std::size_t(k)] * x[m.column[std::size_t(k)]];
        return sum;
    };
    in_blocks(threads_, long(rough_.size()), [&](long begin, long end) {
        for (long row = begin; row < end; ++row) rough_[std::size_t(row)] = product(rows_, row, field);
    });
    const double share = 1 - std::exp(-rate * speed_ * dt);
    in_blocks(threads_, long(columns_.number.size()), [&](long begin, long end) {
        for (long row = begin; row < end; ++row) field[columns_.number[std::size_t(row)]] -= share * product(columns_, row, rough_.data());
    });
}

}    // namespace sphonic
