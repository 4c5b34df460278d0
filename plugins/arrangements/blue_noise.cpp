#include <sphonic/plugin/arrangement.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

/// Random points that keep their distance: those of a lattice, displaced by up to a spacing along each axis, then relaxed by descent of
///   E = sum_ij exp(-r_ij^2 / (2 s^2)),   s = dx/2,   x_i += 1/2 sum_j r_ij exp(-r_ij^2 / (2 s^2)),
/// which takes all power from waves longer than the points' distance, in every direction alike (Ahmed, Ren and Wonka 2022).
/// Along axes that are not periodic the first and last points lie on the faces and stay there, and the set repels its own
/// mirror images, so that it is as dense at the faces as elsewhere. After 20 steps the least distance is some 0.75 dx.
struct BlueNoise final : abi::Arrangement {
    int relaxations = 20;

    static constexpr auto parameters() {
        return std::array{integer("relaxations", &BlueNoise::relaxations, 1, 200, "steps of mutual repulsion; more of them make the distances more equal")};
    }

    void seed(std::int64_t value) override { chance = value; }
    bool regular() const override { return false; }
    long size(const abi::Box& box) const override { return cells(box, 0) * cells(box, 1) * cells(box, 2); }
    double volume(const abi::Box& box) const override {
        double v = 1;
        for (int a = 0; a < box.dimension; ++a) v *= spacing(box, a);
        return v;
    }
    void place(const abi::Box& box, double* const out[3]) const override {
        Set set = scattered(box);
        for (int k = 0; k < relaxations; ++k) relax(box, set);
        for (int a = 0; a < box.dimension; ++a)
            for (std::size_t i = 0; i < set.x.size(); ++i) out[a][i] = set.x[i][std::size_t(a)];
    }

private:
    using Place = std::array<double, 3>;
    struct Set {
        std::vector<Place> x;                  ///< [m]
        std::vector<std::uint8_t> on_faces;    ///< a bit for each axis along which the point stays
    };
    std::int64_t chance = 1;

    static constexpr double width = 0.5, reach = 2;    ///< of the repulsion [dx]

    /// Cells, or points, of a lattice that fits the box.
    static long cells(const abi::Box& box, int axis) {
        if (axis >= box.dimension) return 1;
        const long n = std::max(1L, std::lround((box.upper[axis] - box.lower[axis]) / box.dx));
        return box.periodic[axis] ? n : n + 1;
    }
    static double spacing(const abi::Box& box, int axis) {
        return (box.upper[axis] - box.lower[axis]) / double(cells(box, axis) - !box.periodic[axis]);
    }

    Set scattered(const abi::Box& box) const {
        std::mt19937_64 bits{std::uint64_t(chance)};
        Set set;
        for (long i = 0; i < size(box); ++i) {
            Place x{};
            std::uint8_t fixed = 0;
            long rest = i;
            for (int a = 0; a < box.dimension; rest /= cells(box, a++)) {
                const long site = rest % cells(box, a);
                const double random = 2 * double(bits() >> 11) * 0x1p-53 - 1;
                const bool on_face = !box.periodic[a] && (site == 0 || site == cells(box, a) - 1);
                fixed = std::uint8_t(fixed | on_face << a);
                x[std::size_t(a)] = inside(box, a, box.lower[a] + (double(site) + (on_face ? 0 : random)) * spacing(box, a));
            }
            set.x.push_back(x);
            set.on_faces.push_back(fixed);
        }
        return set;
    }

    /// On the periodic axis, or between the faces, which reflect.
    static double inside(const abi::Box& box, int a, double x) {
        if (!box.periodic[a]) return std::clamp(x < box.lower[a] ? 2 * box.lower[a] - x : x > box.upper[a] ? 2 * box.upper[a] - x : x, box.lower[a], box.upper[a]);
        const double length = box.upper[a] - box.lower[a];
        x -= length * std::floor((x - box.lower[a]) / length);
        return x < box.upper[a] ? x : box.lower[a];
    }

    static void relax(const abi::Box& box, Set& set) {
        const Cells around(box, with_images(box, set));
        std::vector<Place> moved = set.x;
        for (std::size_t i = 0; i < set.x.size(); ++i) {
            Place push{};
            around.for_near(set.x[i], [&](const Place& other) {
                Place r{};
                double r2 = 0;
                for (std::size_t a = 0; a < std::size_t(box.dimension); ++a) {
                    r[a] = set.x[i][a] - other[a];
                    r2 += r[a] * r[a];
                }
                const double q2 = r2 / (box.dx * box.dx);
                if (q2 < reach * reach)
                    for (std::size_t a = 0; a < 3; ++a) push[a] += r[a] * std::exp(-q2 / (2 * width * width));
            });
            for (int a = 0; a < box.dimension; ++a)
                if (!(set.on_faces[i] >> a & 1)) moved[i][std::size_t(a)] = inside(box, a, set.x[i][std::size_t(a)] + 0.5 * push[std::size_t(a)]);
        }
        set.x = std::move(moved);
    }

    /// The points and what lies within reach beyond the ends of each axis: periodic copies, or mirror images.
    static std::vector<Place> with_images(const abi::Box& box, const Set& set) {
        std::vector<Place> all = set.x;
        for (int axis = 0; axis < box.dimension; ++axis) {
            const std::size_t a = std::size_t(axis), n = all.size();
            const double length = box.upper[axis] - box.lower[axis], near = reach * box.dx;
            for (std::size_t i = 0; i < n; ++i)
                for (const bool upper : {false, true}) {
                    const double depth = upper ? box.upper[axis] - all[i][a] : all[i][a] - box.lower[axis];
                    if (depth >= near || (depth == 0 && !box.periodic[axis])) continue;    // one on the face is its own image
                    Place image = all[i];
                    image[a] += (upper ? 1 : -1) * (box.periodic[axis] ? -length : 2 * depth);
                    all.push_back(image);
                }
        }
        return all;
    }

    /// Points sorted into cells as wide as the reach.
    class Cells {
    public:
        Cells(const abi::Box& box, const std::vector<Place>& x) : width_(reach * box.dx) {
            for (int a = 0; a < box.dimension; ++a) {
                lower_[std::size_t(a)] = box.lower[a] - width_;
                count_[std::size_t(a)] = long((box.upper[a] - box.lower[a]) / width_) + 3;
            }
            first_.assign(std::size_t(count_[0] * count_[1] * count_[2]) + 1, 0);
            for (const Place& p : x) ++first_[index(cell(p)) + 1];
            for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
            std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
            sorted_.resize(x.size());
            for (const Place& p : x) sorted_[next[index(cell(p))]++] = p;
        }

        /// Calls visit(point) for all points in the cells around p, p included.
        template <class Visit>
        void for_near(const Place& p, Visit visit) const {
            const auto c = cell(p);
            std::array<long, 3> low{}, high{};
            for (std::size_t a = 0; a < 3; ++a) low[a] = std::max(0L, c[a] - 1), high[a] = std::min(count_[a] - 1, c[a] + 1);
            for (long k = low[2]; k <= high[2]; ++k)
                for (long j = low[1]; j <= high[1]; ++j)
                    for (std::size_t m = first_[index({low[0], j, k})]; m < first_[index({high[0], j, k}) + 1]; ++m) visit(sorted_[m]);
        }

    private:
        double width_;
        Place lower_{};
        std::array<long, 3> count_{1, 1, 1};
        std::vector<std::size_t> first_;
        std::vector<Place> sorted_;

        std::array<long, 3> cell(const Place& p) const {
            std::array<long, 3> c{};
            for (std::size_t a = 0; a < 3; ++a) c[a] = std::clamp(long((p[a] - lower_[a]) / width_), 0L, count_[a] - 1);
            return c;
        }
        std::size_t index(const std::array<long, 3>& c) const { return std::size_t(c[0] + count_[0] * (c[1] + count_[1] * c[2])); }
    };
};

SPHONIC_ARRANGEMENT("blue_noise", BlueNoise, "Random points that keep their distance, by the case's seed: no order, and no long waves in their density")
