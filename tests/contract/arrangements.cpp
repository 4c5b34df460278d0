/// Laws of every arrangement found, in every box that it takes.
#include <sphonic/plugin/abi/arrangement.hpp>

#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

#include <unistd.h>

#include "subjects.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

constexpr double dx = 0.1;

/// `n` spacings, rows and layers long: of a lattice, or of close-packed layers.
abi::Box box_of(int dimension, bool packed, int n, int periodic_axes) {
    abi::Box box{.dimension = dimension, .dx = dx};
    const double spacing[3] = {1, packed ? std::numbers::sqrt3 / 2 : 1, packed ? std::sqrt(2. / 3) : 1};
    for (int a = 0; a < dimension; ++a) {
        box.lower[a] = -0.3 + a;
        box.upper[a] = box.lower[a] + (n + 2 * a) * spacing[a] * dx;
        box.periodic[a] = a < periodic_axes;
        const double sites = (box.upper[a] - box.lower[a]) / dx;
        box.count[a] = box.periodic[a] ? std::lround(sites) : long(std::floor(sites + 1e-9)) + 1;
    }
    return box;
}

/// The runtime keeps regular sets from periodic axes that their sites do not divide.
bool divides(const abi::Box& box) {
    for (int a = 0; a < box.dimension; ++a) {
        const double sites = (box.upper[a] - box.lower[a]) / dx;
        if (box.periodic[a] && std::abs(sites - std::round(sites)) > 1e-6) return false;
    }
    return true;
}

bool wholly_periodic(const abi::Box& box) { return std::all_of(box.periodic, box.periodic + box.dimension, [](bool p) { return p; }); }

double volume_of(const abi::Box& box) {
    double volume = 1;
    for (int a = 0; a < box.dimension; ++a) volume *= box.upper[a] - box.lower[a];
    return volume;
}

using Places = std::vector<double>[3];

/// Fills `x` and checks that as many places were written as the arrangement has particles.
void place(const abi::Arrangement& arrangement, const abi::Box& box, Places& x) {
    const auto n = std::size_t(arrangement.size(box));
    constexpr std::size_t beyond = 8;
    double* out[3] = {};
    for (int a = 0; a < box.dimension; ++a) {
        x[a].assign(n + beyond, untouched);
        out[a] = x[a].data();
    }
    arrangement.place(box, out);
    for (int a = 0; a < box.dimension; ++a) {
        CHECK(std::count(x[a].begin(), x[a].end() - beyond, untouched) == 0);
        CHECK(std::count(x[a].end() - beyond, x[a].end(), untouched) == long(beyond));
        x[a].resize(n);
    }
}

/// To the nearest image.
double distance(const abi::Box& box, const Places& x, std::size_t i, std::size_t j) {
    double sum = 0;
    for (int a = 0; a < box.dimension; ++a) {
        const double length = box.upper[a] - box.lower[a];
        double d = x[a][i] - x[a][j];
        if (box.periodic[a]) d -= length * std::round(d / length);
        sum += d * d;
    }
    return std::sqrt(sum);
}

double least_distance(const abi::Box& box, const Places& x) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < x[0].size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, distance(box, x, i, j));
    return least;
}

/// The laws, for an arrangement that has taken the box.
void obeys_the_laws(const abi::Arrangement& arrangement, const abi::Box& box) {
    Places x;
    place(arrangement, box, x);
    CHECK(x[0].size() > 1);
    for (int a = 0; a < box.dimension; ++a) {
        const auto [least, most] = std::minmax_element(x[a].begin(), x[a].end());
        CHECK(*least >= box.lower[a] - 1e-9 * dx);
        CHECK((box.periodic[a] ? *most < box.upper[a] : *most <= box.upper[a] + 1e-9 * dx));    // with the distance below: no two at one place
    }
    CHECK(least_distance(box, x) > 1e-3 * dx);
    CHECK(arrangement.volume(box) > 0);
    if (wholly_periodic(box)) CHECK(double(x[0].size()) * arrangement.volume(box) == Approx(volume_of(box)).epsilon(0.01));
    if (!arrangement.regular()) return;
    REQUIRE(long(x[0].size()) == box.count[0] * box.count[1] * box.count[2]);
    long stride = 1;
    for (int a = 0; a < box.dimension; stride *= box.count[a++])
        for (long i = 0; i < long(x[a].size()); ++i)
            if (x[a][std::size_t(i)] != box.lower[a] + double(i / stride % box.count[a]) * dx) FAIL_CHECK("particle " << i << " is off its site");
}

/// Runs over boxes of each dimension, free, periodic and mixed.
template <class Visit>
void for_each_box(Visit visit) {
    for (int d = 1; d <= 3; ++d)
        for (const bool packed : {false, true})
            for (int periodic = 0; periodic <= d; ++periodic) {
                INFO(d << "-D" << (packed ? ", close-packed" : "") << ", " << periodic << " periodic axes");
                visit(box_of(d, packed, 6, periodic));
            }
}

bool takes(abi::Arrangement& arrangement, const abi::Box& box) {
    if (arrangement.regular() && !divides(box)) return false;
    try {
        arrangement.prepare(box);
        return true;
    } catch (const std::invalid_argument& e) {
        CHECK(std::string(e.what()).size() > 20);    // says why, and what to do
        return false;
    }
}

bool reads_a_file(const std::string& name) {
    const Plugin& plugin = registry().find("arrangement", name, "contract");
    return std::any_of(plugin.parameters.begin(), plugin.parameters.end(),
                       [](const auto& row) { return row.unit == std::string(abi::file_unit); });
}

std::string refusal(abi::Arrangement& arrangement, const abi::Box& box) {
    try {
        arrangement.prepare(box);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "nothing was refused";
}

/// A file that is there as long as this object.
struct File {
    std::string path = (std::filesystem::temp_directory_path() / ("sphonic-points-" + std::to_string(getpid()) + ".csv")).string();
    explicit File(const std::string& text) { std::ofstream(path) << text; }
    ~File() { std::filesystem::remove(path); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
};

std::unique_ptr<abi::Arrangement> points_of(const std::string& path) {
    return registry().create<abi::Arrangement>(registry().find("arrangement", "points", "contract"),
                                               {{.type = abi::ParameterType::text, .text = path.c_str()}});
}

}    // namespace

TEST_CASE("an arrangement fills each box that it takes with as many particles as it says, apart from each other", "[arrangement]") {
    std::map<std::string, int> taken;
    for_each_box([&](const abi::Box& box) {
        for (const auto& subject : subjects<abi::Arrangement>()) {    // anew for each box: it is prepared once
            INFO(subject.label);
            if (reads_a_file(subject.label.substr(0, subject.label.find(' ')))) continue;
            const bool takes_it = takes(*subject.object, box);
            taken[subject.label] += takes_it;
            if (takes_it) obeys_the_laws(*subject.object, box);
        }
    });
    CHECK(taken.size() > 1);
    for (const auto& [label, boxes] : taken) {
        INFO(label);
        CHECK(boxes > 0);
    }
}

TEST_CASE("each particle of a periodic hexagonal set has its nearest neighbours at dx, six in 2-D and twelve in 3-D", "[arrangement]") {
    for (const int d : {2, 3}) {
        const auto hexagonal = make<abi::Arrangement>("hexagonal");
        const abi::Box box = box_of(d, true, 6, d);
        REQUIRE(takes(*hexagonal, box));
        Places x;
        place(*hexagonal, box, x);
        CHECK(double(x[0].size()) * hexagonal->volume(box) == Approx(volume_of(box)).epsilon(1e-12));
        CHECK(least_distance(box, x) == Approx(dx).epsilon(1e-12));
        long astray = 0;
        for (std::size_t i = 0; i < x[0].size(); ++i) {
            int at_dx = 0;
            for (std::size_t j = 0; j < x[0].size(); ++j) at_dx += std::abs(distance(box, x, i, j) - dx) < 1e-12 * dx;
            astray += at_dx != (d == 2 ? 6 : 12);
        }
        INFO(d << "-D");
        CHECK(astray == 0);
    }
}

TEST_CASE("a bounded hexagonal set ends each row with the last site inside the box", "[arrangement]") {
    const auto x_in = [](double width) {
        const auto hexagonal = make<abi::Arrangement>("hexagonal");
        const abi::Box box{.dimension = 2, .dx = 1, .upper = {width, std::numbers::sqrt3}};
        REQUIRE(takes(*hexagonal, box));
        Places x;
        place(*hexagonal, box, x);
        return x[0];
    };
    CHECK(x_in(2) == std::vector<double>{0, 1, 2, 0.5, 1.5, 0, 1, 2});
    CHECK(x_in(2.49).size() == 8);
    CHECK(x_in(2.5) == std::vector<double>{0, 1, 2, 0.5, 1.5, 2.5, 0, 1, 2});
}

TEST_CASE("a hexagonal set refuses a line and periodic axes of broken periods, and says which lengths fit", "[arrangement]") {
    const auto refused_in = [](const abi::Box& box) { return refusal(*make<abi::Arrangement>("hexagonal"), box); };
    CHECK(refused_in(box_of(1, false, 6, 0)) == "a hexagonal set needs two or three dimensions: in one, use \"lattice\"");
    const auto refused = [&](int axis, double upper) {
        abi::Box box = box_of(3, true, 6, 3);
        box.lower[axis] = 0;
        box.upper[axis] = upper;
        return refused_in(box);
    };
    CHECK(refused(0, 0.65) == "the periodic axis x is 6.5 periods (dx) long: make upper - lower 0.6 or 0.7 m");
    CHECK(refused(1, 1) == "the periodic axis y is 5.7735026919 periods (sqrt(3) dx, two rows) long: "
                            "make upper - lower 0.866025403784 or 1.03923048454 m");
    CHECK(refused(2, 0.1) == "the periodic axis z is 0.612372435696 periods (2 sqrt(2/3) dx, two layers) long: "
                              "make upper - lower 0.163299316186 m");
    CHECK(refused(1, 1.03923048) == "nothing was refused");    // six periods to nine digits
    CHECK(refused(1, 1.03922) != "nothing was refused");
}

TEST_CASE("particles from a file obey the laws of arrangements and stand in its order", "[arrangement]") {
    const File file("\xEF\xBB\xBF# made by hand\r\n\"x [m]\", y\r\n\r\n 0.05 ,+0.05\r\n0.15\t,5e-2\n  # between\n-0.,0.15\n0.1,0.15");
    for (const int periodic : {0, 1, 2}) {
        abi::Box box{.dimension = 2, .dx = dx, .upper = {0.2, 0.2}};
        std::fill_n(box.periodic, periodic, true);
        const auto points = points_of(file.path);
        REQUIRE(takes(*points, box));
        CHECK_FALSE(points->regular());
        obeys_the_laws(*points, box);
        Places x;
        place(*points, box, x);
        CHECK(x[0] == std::vector<double>{0.05, 0.15, 0, 0.1});
        CHECK(x[1] == std::vector<double>{0.05, 0.05, 0.15, 0.15});
    }
}

TEST_CASE("a file of particles that cannot be is refused with its line and what to do", "[arrangement]") {
    const abi::Box bounded{.dimension = 2, .dx = dx, .upper = {1, 1}};
    abi::Box periodic = bounded;
    periodic.periodic[0] = true;
    const auto refused = [](const std::string& text, const abi::Box& box) {
        const File file(text);
        const std::string message = refusal(*points_of(file.path), box);
        CHECK(message.substr(0, file.path.size()) == file.path);
        return message.substr(std::min(message.size(), file.path.size()));
    };
    CHECK(refused("x,y\n0,0\n1,2,3\n", bounded) == R"(:3: "1,2,3" has 3 columns. Give 2, separated by commas)");
    CHECK(refused("0 0\n", bounded) == R"(:1: "0 0" has 1 column. Give 2, separated by commas)");
    CHECK(refused("0,0\nx,y\n", bounded) == R"(:2: "x" is not a finite number. Give a coordinate in metres)");
    CHECK(refused("0,0.1x\n", bounded) == R"(:1: "0.1x" is not a finite number. Give a coordinate in metres)");
    CHECK(refused("\x1B\xF0,0\n", bounded) == R"(:1: "??" is not a finite number. Give a coordinate in metres)");
    CHECK(refused("0,\n", bounded) == R"(:1: "" is not a finite number. Give a coordinate in metres)");
    CHECK(refused("0,0\n0,nan\n", bounded) == R"(:2: "nan" is not a finite number. Give a coordinate in metres)");
    CHECK(refused("0,0\n1,1.001\n", bounded) == ":2: y = 1.001 is outside the box, [0, 1]. Move the particle or the box");
    CHECK(refused("0,0\n1,1\n", periodic) == ":2: x = 1 is outside the periodic box, [0, 1). Move the particle or the box");
    CHECK(refused("0,0.5\n1,1\n0,0.5\n", bounded) == ":3: the particle is at the place of that of line 1. Remove one of them");
    CHECK(refused("0,0.5\n0.999999999,0.5\n", periodic) == ":2: the particle is at the place of that of line 1. Remove one of them");
    CHECK(refused("# nothing\n", bounded) == ": it holds 0 particles. Give two or more, one per line");
    CHECK(refused("0,0\n", bounded) == ": it holds 1 particle. Give two or more, one per line");
    periodic.periodic[1] = true;
    CHECK(refused("0,0\n0.5,0\n0,0.5\n0.5,0.5\n", periodic) ==
          ": its 4 particles of volume dx^d fill 0.04 of the periodic box's 1 m^d. Set dx to 0.5");
}

TEST_CASE("a file of particles that is not there or is no file is refused by its name", "[arrangement]") {
    const abi::Box box = box_of(2, false, 6, 0);
    const std::string folder = std::filesystem::temp_directory_path().string();
    CHECK(refusal(*points_of(""), box) == "file is missing: name a CSV file, one particle per line");
    CHECK(refusal(*points_of(folder + "/no-such-file"), box) ==
          folder + "/no-such-file: cannot be opened. Check that the file exists and may be read");
    CHECK(refusal(*points_of(folder), box) == folder + ": cannot be read. Give a CSV file");
}
