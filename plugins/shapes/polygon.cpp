#include <sphonic/plugin/shape.hpp>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

/// The corners of a polygon in order around it, either way: "0 0, 2 0, 2 1, 0 1". No edges may cross.
struct Polygon final : abi::Shape {
    std::string corners;

    static constexpr auto parameters() {
        return std::array{text("corners", &Polygon::corners, "", "x and y [m] of each in order around it, such as \"0 0, 2 0, 2 1\"")};
    }

    void prepare(const abi::ShapeScene& scene) override {
        if (scene.box.dimension != 2) throw std::invalid_argument("a polygon needs two dimensions: use another shape");
        read();
        if (at.size() < 3) throw std::invalid_argument("corners holds " + std::to_string(at.size()) + " of them: give three or more, such as \"0 0, 2 0, 2 1\"");
        check_edges();
        double twice_area = 0;
        for (std::size_t i = 0; i < at.size(); ++i) twice_area += cross(at[i], next(i));
        anticlockwise = twice_area > 0;
    }

    void measure(const abi::Points& points, double* distance, double* const normal[3]) const override {
        for (int i = 0; i < points.n; ++i) {
            const Place x{points.x[0][i], points.x[1][i]};
            std::size_t nearest = 0;
            Place off{};
            double least = infinite;
            for (std::size_t k = 0; k < at.size(); ++k) {
                const Place r = x - foot(k, x);
                if (dot(r, r) >= least) continue;
                least = dot(r, r);
                nearest = k;
                off = r;
            }
            const double length = std::sqrt(least), side = contains(x) ? -1 : 1;
            const Place n = length > 1e-12 * size(nearest) ? off * (side / length) : outward(nearest);
            distance[i] = side * length;
            normal[0][i] = n.x;
            normal[1][i] = n.y;
        }
    }

private:
    struct Place {
        double x, y;
        Place operator-(const Place& o) const { return {x - o.x, y - o.y}; }
        Place operator+(const Place& o) const { return {x + o.x, y + o.y}; }
        Place operator*(double s) const { return {s * x, s * y}; }
    };
    std::vector<Place> at;    ///< [m]
    bool anticlockwise = true;

    static double dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }
    static double cross(const Place& a, const Place& b) { return a.x * b.y - a.y * b.x; }
    const Place& next(std::size_t i) const { return at[(i + 1) % at.size()]; }
    Place edge(std::size_t i) const { return next(i) - at[i]; }
    double size(std::size_t i) const { return std::sqrt(dot(edge(i), edge(i))); }
    Place outward(std::size_t i) const {
        const Place e = edge(i) * ((anticlockwise ? 1 : -1) / size(i));
        return {e.y, -e.x};
    }
    /// The point of edge i that is nearest to x.
    Place foot(std::size_t i, const Place& x) const {
        const Place e = edge(i);
        const double s = dot(x - at[i], e) / dot(e, e);
        return s <= 0 ? at[i] : s >= 1 ? next(i) : at[i] + e * s;
    }
    /// By the number of edges that a ray along +x crosses.
    bool contains(const Place& x) const {
        bool inside = false;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const Place &a = at[i], &b = next(i);
            if ((a.y > x.y) != (b.y > x.y) && x.x < a.x + (x.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
        }
        return inside;
    }

    void read() {
        std::string_view rest = corners;
        while (!rest.empty()) {
            const auto comma = rest.find(',');
            const std::string_view corner = rest.substr(0, comma);
            rest = comma == rest.npos ? std::string_view() : rest.substr(comma + 1);
            std::istringstream in{std::string(corner)};
            std::string x, y, more;
            if (!(in >> x >> y) || in >> more) throw std::invalid_argument("corners: \"" + std::string(corner) + "\" is no corner: give x and y, and commas between corners");
            at.push_back({number(x), number(y)});
        }
    }
    static double number(const std::string& text) {
        double x = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), x);
        if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(x))
            throw std::invalid_argument("corners: \"" + text + "\" is not a finite number: give coordinates in metres");
        return x;
    }

    void check_edges() const {
        const auto corner = [](std::size_t i) { return "corner " + std::to_string(i + 1); };
        for (std::size_t i = 0; i < at.size(); ++i)
            if (!(size(i) > 0)) throw std::invalid_argument("corners: " + corner(i) + " is followed by itself: leave one of them out");
        for (std::size_t i = 0; i < at.size(); ++i)
            for (std::size_t j = i + 2; j < at.size(); ++j) {
                if ((j + 1) % at.size() == i) continue;
                const auto apart = [&](std::size_t k, const Place& a, const Place& b) { return cross(edge(k), a - at[k]) * cross(edge(k), b - at[k]) > 0; };
                if (!apart(i, at[j], next(j)) && !apart(j, at[i], next(i)) && meet(i, j))
                    throw std::invalid_argument("corners: the edges from " + corner(i) + " and from " + corner(j) + " cross: give the corners in order around the polygon");
            }
    }
    /// Of edges that lie on both sides of each other's lines, or along one line: whether they have a point in common.
    bool meet(std::size_t i, std::size_t j) const {
        if (cross(edge(i), edge(j)) != 0) return true;
        const double s = dot(at[j] - at[i], edge(i)) / dot(edge(i), edge(i)), t = dot(next(j) - at[i], edge(i)) / dot(edge(i), edge(i));
        return cross(at[j] - at[i], edge(i)) == 0 && std::max(s, t) >= 0 && std::min(s, t) <= 1;
    }
};

SPHONIC_SHAPE("polygon", Polygon, "A polygon by its corners, in two dimensions")
