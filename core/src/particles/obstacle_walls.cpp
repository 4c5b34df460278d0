#include "obstacle_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parallel.hpp"
#include "wall_fit.hpp"
#include "wall_view.hpp"

namespace sphonic {

ObstacleWalls::ObstacleWalls(const Case& scene, const Components& components, const Sites& sites, double reach, int threads)
    : scene_(scene), components_(components), n_(sites.count()), reach_(reach), threads_(threads), start_{0}, fields_(std::size_t(components.count)) {
    choose(sites);
    find_on_walls(sites);
}

/// Each belongs to the wall that it is deepest behind.
void ObstacleWalls::choose(const Sites& sites) {
    const std::size_t n = sites.solid[0].size();
    std::vector<double> depth(n, 0.0);
    std::vector<std::int32_t> owner(n, -1);
    Places normal;
    for (std::size_t k = 0; k < scene_.obstacles.size(); ++k) {
        if (!scene_.obstacles[k].walled()) continue;
        const WallView view(scene_, scene_.obstacles[k], sites.solid);
        for (int a = 0; a < scene_.box.dimension; ++a) normal[a].resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            if (-view.distance[i] <= depth[i]) continue;
            depth[i] = -view.distance[i];
            owner[i] = std::int32_t(k);
            for (int a = 0; a < scene_.box.dimension; ++a) normal[a][i] = view.normal[a][i];
        }
    }
    for (std::size_t k = 0; k < scene_.obstacles.size(); ++k)
        for (std::size_t i = 0; i < n; ++i) {
            if (owner[i] != std::int32_t(k) || depth[i] >= reach_) continue;
            obstacle_.push_back(owner[i]);
            depth_.push_back(depth[i]);
            for (int a = 0; a < scene_.box.dimension; ++a) {
                x_[a].push_back(sites.solid[a][i]);
                normal_[a].push_back(normal[a][i]);
            }
        }
}

void ObstacleWalls::find_on_walls(const Sites& sites) {
    for (const Obstacle& obstacle : scene_.obstacles) {
        if (!obstacle.walled()) continue;
        const WallView view(scene_, obstacle, sites.own);
        for (long i = 0; i < n_; ++i) {
            if (!(view.distance[std::size_t(i)] < on_wall * scene_.box.dx)) continue;
            OnWall on{std::int32_t(i), obstacle.wall, {}};
            for (int a = 0; a < scene_.box.dimension; ++a) on.normal[a] = view.normal[a][std::size_t(i)];
            on_.push_back(on);
        }
    }
}

void ObstacleWalls::place(double* const* x) const {
    for (int a = 0; a < scene_.box.dimension; ++a) std::copy(x_[a].begin(), x_[a].end(), x[a]);
}

/// Own particles and mirror images of them that are near enough to an obstacle's wall.
ObstacleWalls::Sources ObstacleWalls::sources(const Obstacle& obstacle, const double* const* x, const MirrorParticles& mirrors) const {
    Sources all, near;
    const auto add = [&](Sources& to, long index, const auto& at, std::size_t j) {
        to.index.push_back(std::int32_t(index));
        for (int a = 0; a < scene_.box.dimension; ++a) to.x[a].push_back(at[a][j]);
    };
    for (long j = 0; j < n_; ++j) add(all, j, x, std::size_t(j));
    for (long j = n_ + count(); j < n_ + count() + mirrors.count(); ++j)
        if (mirrors.source(j) < n_) add(all, j, x, std::size_t(j));
    const WallView view(scene_, obstacle, all.x);
    for (std::size_t j = 0; j < all.index.size(); ++j) {
        if (!(view.distance[j] < reach_ + WallFit::radius * scene_.box.dx)) continue;
        add(near, all.index[j], all.x, j);
        near.height.push_back(view.distance[j]);
    }
    return near;
}

void ObstacleWalls::fit(const double* const* x, const MirrorParticles& mirrors) {
    for (std::size_t k = 0; k < scene_.obstacles.size(); ++k) {
        const auto [first, last] = std::equal_range(obstacle_.begin(), obstacle_.end(), std::int32_t(k));
        if (first != last)
            fit_wall(scene_.obstacles[k], std::size_t(first - obstacle_.begin()), std::size_t(last - obstacle_.begin()), sources(scene_.obstacles[k], x, mirrors));
    }
}

void ObstacleWalls::fit_wall(const Obstacle& obstacle, std::size_t begin, std::size_t end, const Sources& sources) {
    Places feet, over;
    for (int a = 0; a < scene_.box.dimension; ++a)
        for (std::size_t v = begin; v < end; ++v) {
            feet[a].push_back(x_[a][v] + depth_[v] * normal_[a][v]);
            over[a].push_back(feet[a].back() + depth_[v] * normal_[a][v]);
        }
    const std::vector<double> spread = curvature(scene_, obstacle, feet);
    const Near near(scene_.box, over, sources.x, WallFit::radius * scene_.box.dx);
    for (std::size_t v = begin; v < end; ++v) {
        const double normal[3] = {normal_[0][v], scene_.box.dimension > 1 ? normal_[1][v] : 0, scene_.box.dimension > 2 ? normal_[2][v] : 0};
        WallFit fit(scene_, obstacle.wall, normal, depth_[v], spread[v - begin]);
        double least = std::numeric_limits<double>::infinity();
        nearest_.push_back(-1);
        for (std::int64_t k = near.start[v - begin]; k < near.start[v - begin + 1]; ++k) {
            const std::size_t j = std::size_t(near.index[std::size_t(k)]);
            double r[3] = {};
            for (int a = 0; a < scene_.box.dimension; ++a) r[a] = apart(scene_.box, a, sources.x[a][j] - over[a][v - begin]);
            fit.add(r, sources.height[j]);
            source_.push_back(sources.index[j]);
            if (const double length = std::hypot(r[0], r[1], r[2]); length < least) least = length, nearest_.back() = sources.index[j];
        }
        for (const double w : fit.along()) along_.push_back(w);
        for (const double w : fit.across()) across_.push_back(w);
        start_.push_back(std::int64_t(source_.size()));
    }
}

int ObstacleWalls::fill(int component, double* field) {
    fields_[std::size_t(component)] = field;
    const int d = scene_.box.dimension;
    const bool scalar = components_.part(component, 0) == abi::Part::scalar, last = components_.part(component, d - 1) == abi::Part::normal;
    if (scalar) fill_scalar(component, field);
    if (last) fill_vector(fields_.data() + component - (d - 1));
    return scalar ? 1 : last ? d : 0;
}

void ObstacleWalls::fill_scalar(int component, double* field) const {
    const double rest = components_.rest(component);
    for (const OnWall& on : on_)
        if (on.wall == Obstacle::Wall::soft) field[on.i] = rest;
    in_blocks(threads_, count(), [&](long begin, long end) {
        for (long v = begin; v < end; ++v) {
            double sum = 0;
            for (std::int64_t k = start_[std::size_t(v)]; k < start_[std::size_t(v) + 1]; ++k)
                sum += along_[std::size_t(k)] * (field[source_[std::size_t(k)]] - rest);
            field[n_ + v] = rest + sum;
        }
    });
}

void ObstacleWalls::fill_vector(double* const* u) const {
    const int d = scene_.box.dimension;
    for (const OnWall& on : on_) {
        double across = 0;
        for (int a = 0; a < d; ++a) across += on.normal[a] * u[a][on.i];
        for (int a = 0; a < d; ++a) u[a][on.i] = on.wall == Obstacle::Wall::rigid ? u[a][on.i] - across * on.normal[a] : across * on.normal[a];
    }
    in_blocks(threads_, count(), [&](long begin, long end) {
        for (long v = begin; v < end; ++v) {
            double sum[3] = {}, across = 0;
            for (std::int64_t k = start_[std::size_t(v)]; k < start_[std::size_t(v) + 1]; ++k) {
                const std::int32_t j = source_[std::size_t(k)];
                double normal = 0;
                for (int a = 0; a < d; ++a) {
                    normal += normal_[a][std::size_t(v)] * u[a][j];
                    sum[a] += along_[std::size_t(k)] * u[a][j];
                }
                across += (across_[std::size_t(k)] - along_[std::size_t(k)]) * normal;
            }
            for (int a = 0; a < d; ++a) u[a][n_ + v] = sum[a] + across * normal_[a][std::size_t(v)];
        }
    });
}

/// R L R with R = 1 - 2 n n.
void ObstacleWalls::reflect(double* const entry[6]) const {
    const std::size_t d = std::size_t(scene_.box.dimension);
    for (long v = 0; v < count(); ++v) {
        const std::int32_t source = nearest_[std::size_t(v)];
        if (source < 0) continue;
        const auto L = [&](std::size_t a, std::size_t b) { return entry[a < b ? b * (b + 1) / 2 + a : a * (a + 1) / 2 + b][source]; };
        const auto R = [&](std::size_t a, std::size_t b) { return (a == b) - 2 * normal_[a][std::size_t(v)] * normal_[b][std::size_t(v)]; };
        for (std::size_t b = 0; b < d; ++b)
            for (std::size_t a = 0; a <= b; ++a) {
                double sum = 0;
                for (std::size_t i = 0; i < d; ++i)
                    for (std::size_t j = 0; j < d; ++j) sum += R(a, i) * L(i, j) * R(j, b);
                entry[b * (b + 1) / 2 + a][n_ + v] = sum;
            }
    }
}

}    // namespace sphonic
