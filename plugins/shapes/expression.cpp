#include <sphonic/plugin/shape.hpp>

#include <algorithm>
#include <stdexcept>

/// The body where f(x) < 0, with the surface f = 0. Any f will do that is smooth near the surface and has a slope there. The
/// nearest point of the surface is found by Newton's steps onto it and steps along it, with differences for grad f; farther than
/// 32 dx the distance is f / |grad f| only.
struct ExpressionShape final : abi::Shape {
    std::string surface;

    static constexpr auto parameters() {
        return std::array{text("surface", &ExpressionShape::surface, "",
                               "expression of x, y, z, r: zero on the surface, positive outside the body, such as \"x^2/4 + y^2 - 1\"")};
    }

    void prepare(const abi::ShapeScene& scene) override {
        if (surface.empty()) throw std::invalid_argument("surface is missing: give an expression that is zero on it and positive outside the body");
        f = scene.formula(scene.host, surface.c_str());
        d = scene.box.dimension;
        dx = scene.box.dx;
    }

    void measure(const abi::Points& points, double* distance, double* const normal[3]) const override {
        for (int i = 0; i < points.n; ++i) {
            Place x{};
            for (int a = 0; a < d; ++a) x[std::size_t(a)] = points.x[a][i];
            Place from = x;
            Slope here = slope(x);
            const double side = here.value < 0 ? -1 : 1;
            double length = roughly(here);
            if (side < 0 && length >= far * dx) {    // the slope may vanish in the very middle of a body: see beside it
                for (int a = 0; a < d; ++a) from[std::size_t(a)] += aside * dx;
                here = slope(from);
                length = roughly(here);
            }
            if (length < far * dx) length = approach(x, from, here);
            distance[i] = side * length;
            for (int a = 0; a < d; ++a) normal[a][i] = here.normal[std::size_t(a)];
        }
    }

private:
    using Place = std::array<double, 3>;
    struct Slope {
        double value = 0, steepness = 0;
        Place normal{1, 0, 0};
    };
    static constexpr double far = 32, aside = 0.25;    ///< [dx]
    std::unique_ptr<abi::Formula> f;
    int d = 1;
    double dx = 1;

    double value(const Place& x) const {
        abi::Points one{.dimension = d, .n = 1};
        for (int a = 0; a < d; ++a) one.x[a] = &x[std::size_t(a)];
        double result = 0;
        f->evaluate(one, &result);
        if (!std::isfinite(result)) throw std::invalid_argument("surface: \"" + surface + "\" is not finite in the whole box: choose an expression that is");
        return result;
    }
    Slope slope(const Place& x) const {
        const double step = 1e-4 * dx;
        Slope s{.value = value(x)};
        Place g{};
        for (std::size_t a = 0; a < std::size_t(d); ++a) {
            Place there = x;
            there[a] = x[a] + step;
            const double up = value(there);
            there[a] = x[a] - step;
            g[a] = (up - value(there)) / (2 * step);
            s.steepness += g[a] * g[a];
        }
        s.steepness = std::sqrt(s.steepness);
        for (std::size_t a = 0; s.steepness > 0 && a < 3; ++a) s.normal[a] = g[a] / s.steepness;
        return s;
    }
    static double roughly(const Slope& s) { return std::abs(s.value) / std::max(s.steepness, 1e-300); }
    static double length(const Place& r) { return std::hypot(r[0], r[1], r[2]); }

    /// Onto the surface along its slope.
    Place projected(Place p, Slope& s) const {
        for (int k = 0; k < 30; ++k) {
            s = slope(p);
            if (!(s.steepness > 0) || std::abs(s.value) <= 1e-10 * dx * s.steepness) break;
            const double step = std::clamp(s.value / s.steepness, -far * dx, far * dx);
            for (std::size_t a = 0; a < 3; ++a) p[a] -= step * s.normal[a];
        }
        return p;
    }

    /// What of x - p lies along the surface.
    static Place along(const Place& x, const Place& p, const Slope& s) {
        Place r{};
        double out = 0;
        for (std::size_t a = 0; a < 3; ++a) out += s.normal[a] * (x[a] - p[a]);
        for (std::size_t a = 0; a < 3; ++a) r[a] = x[a] - p[a] - out * s.normal[a];
        return r;
    }

    /// The distance of x, and in `s` the slope at the nearest point, looked for from nearby. What a step along the surface leaves to go says how long the
    /// next one should be.
    double approach(const Place& x, const Place& from, Slope& s) const {
        Place p = projected(from, s), way = along(x, p, s);
        double share = 1;
        for (int k = 0; k < 50 && length(way) > 1e-7 * dx; ++k) {
            Place q{};
            for (std::size_t a = 0; a < 3; ++a) q[a] = p[a] + share * way[a];
            Slope there;
            q = projected(q, there);
            const Place rest = along(x, q, there);
            if (length(rest) > 2 * length(way)) {
                share *= 0.25;
                continue;
            }
            const double left = (rest[0] * way[0] + rest[1] * way[1] + rest[2] * way[2]) / (length(way) * length(way));
            share = left < 0.75 ? share / (1 - left) : 4 * share;
            p = q;
            s = there;
            way = rest;
        }
        return length({x[0] - p[0], x[1] - p[1], x[2] - p[2]});
    }
};

SPHONIC_SHAPE("expression", ExpressionShape, "The body where an expression is negative")
