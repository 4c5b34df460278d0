#include <sphonic/plugin/arrangement.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>

/// Each particle dx from its nearest neighbours: six in 2-D (a triangular lattice), twelve in 3-D (hexagonal close
/// packing, layers ABAB). Site i of row j of layer k, rows along x:
///   x = lower + (i + ((j + k) mod 2)/2) dx,   y = lower + (j + (k mod 2)/3) sqrt(3)/2 dx,   z = lower + k sqrt(2/3) dx.
/// One particle stands for sqrt(3)/2 dx^2, or dx^3/sqrt(2).
struct Hexagonal final : abi::Arrangement {
    void prepare(const abi::Box& box) override {
        if (box.dimension == 1)
            throw std::invalid_argument("a hexagonal set needs two or three dimensions: in one, use \"lattice\"");
        for (int a = 0; a < box.dimension; ++a)
            if (box.periodic[a]) check_periods(box, a);
        particles = 0;
        for_rows(box, [&](const Row& row) { particles += row.sites; });
    }

    bool regular() const override { return false; }
    long size(const abi::Box&) const override { return particles; }
    double volume(const abi::Box& box) const override {
        const double dx = box.dx;
        return box.dimension == 2 ? dx * dx * std::numbers::sqrt3 / 2 : dx * dx * dx / std::numbers::sqrt2;
    }

    void place(const abi::Box& box, double* const x[3]) const override {
        long n = 0;
        for_rows(box, [&](const Row& row) {
            for (long i = 0; i < row.sites; ++i, ++n) {
                x[0][n] = box.lower[0] + (double(i) + row.shift) * box.dx;
                x[1][n] = row.y;
                if (box.dimension == 3) x[2][n] = row.z;
            }
        });
    }

private:
    struct Row {
        double shift;    ///< of its first site [dx]
        double y, z;     ///< [m]
        long sites;
    };
    long particles = 0;

    /// Distance of sites, of rows and of layers [m].
    static double spacing(const abi::Box& box, int axis) {
        return box.dx * (axis == 0 ? 1 : axis == 1 ? std::numbers::sqrt3 / 2 : std::sqrt(2. / 3));
    }

    /// Sites, rows or layers at lower + (i + shift) spacing within the box.
    static long count(const abi::Box& box, int axis, double shift) {
        const double length = (box.upper[axis] - box.lower[axis]) / spacing(box, axis);
        return box.periodic[axis] ? std::lround(length) : long(std::floor(length - shift + 1e-9)) + 1;
    }

    /// All rows in the order of their particles.
    template <class Visit>
    static void for_rows(const abi::Box& box, Visit visit) {
        const long layers = box.dimension == 3 ? count(box, 2, 0) : 1;
        for (long k = 0; k < layers; ++k) {
            const double up = k % 2 ? 1. / 3 : 0, z = box.lower[2] + double(k) * spacing(box, 2);
            const long rows = count(box, 1, up);
            for (long j = 0; j < rows; ++j) {
                const double shift = (j + k) % 2 ? 0.5 : 0;
                visit(Row{shift, box.lower[1] + (double(j) + up) * spacing(box, 1), z, count(box, 0, shift)});
            }
        }
    }

    static void check_periods(const abi::Box& box, int axis) {
        constexpr const char* length_of_one[] = {"dx", "sqrt(3) dx, two rows", "2 sqrt(2/3) dx, two layers"};
        const double period = (axis == 0 ? 1 : 2) * spacing(box, axis);
        const double length = (box.upper[axis] - box.lower[axis]) / period, fewer = std::floor(length);
        if (std::round(length) >= 1 && std::abs(length - std::round(length)) <= 1e-6) return;
        std::ostringstream text;
        text.precision(12);
        text << "the periodic axis " << "xyz"[axis] << " is " << length << " periods (" << length_of_one[axis]
             << ") long: make upper - lower ";
        if (fewer >= 1) text << fewer * period << " or ";
        text << (fewer + 1) * period << " m";
        throw std::invalid_argument(text.str());
    }
};

SPHONIC_ARRANGEMENT("hexagonal", Hexagonal, "Triangular lattice in 2-D, hexagonal close packing in 3-D; dx is the distance of neighbours")
