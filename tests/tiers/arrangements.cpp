/// Whole runs on sets that are no lattice.
#include "../support/scene.hpp"

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <numbers>

#include <unistd.h>

#include <sphonic/plugin/abi/kernel.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

namespace fs = std::filesystem;

constexpr double row = std::numbers::sqrt3 / 2;    // distance of rows [dx]

/// A periodic box of `sites` sites per row and an even number of rows of a hexagonal set.
Json hexagonal_box(double dx, int sites, int rows) {
    Json document = parse_json(periodic_box(2, 1), "test.json");
    document["particles"] = {{"type", "hexagonal"}, {"dx", dx}, {"lower", {0, 0}}, {"upper", {sites * dx, rows * row * dx}}};
    document["kernel"] = {{"type", "cubic_spline"}, {"h", 1.3 * dx}};
    return document;
}

Case loaded(const Json& document, const std::vector<std::string>& set = {}, const fs::path& file = "test.json") {
    Json changed = document;
    for (const auto& assignment : set) set_at(changed, assignment);
    return load_case(std::move(changed), file, registry());
}

Profile final_state(const Case& c) {
    Simulation simulation(c);
    CHECK(simulation.summary().tier == "frozen");
    simulation.run();
    return simulation.profile();
}

/// A folder that is there as long as this object.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("sphonic-arrangements-" + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
};

void write(const fs::path& file, const Profile& now) {
    std::ofstream out(file);
    out << std::setprecision(17) << "x,y\n";
    for (std::size_t i = 0; i < now.p.size(); ++i) out << now.x[0][i] << ',' << now.x[1][i] << '\n';
}

/// The dx whose square is `area` to the last bit; 0 if there is none.
double side_of(double area) {
    const double root = std::sqrt(area);
    for (const double dx : {root, std::nextafter(root, 0), std::nextafter(root, 2 * root)})
        if (dx * dx == area) return dx;
    return 0;
}

const std::vector<std::string> sound{"/initial/p=exp(sin(2*pi*x))*cos(2*pi*y)", R"-(/initial/u=["0.1*sin(2*pi*x)","0.05*cos(4*pi*x*y)"])-"};

/// Speed over c0 of a plane wave of wave number k along `axis` of a hexagonal set, each neighbour a line of the sum:
///   c/c0 = F(k)/k,  F(k) = -V sum_j W'(r_j) (x_j/r_j) sin(k x_j),  in the difference form as in the sum.
double speed_in_theory(const Case& c, int axis, double k) {
    const KernelUse& use = c.kernels[0];
    const double dx = c.box.dx;
    double sum = 0;
    for (int j = -4; j <= 4; ++j)
        for (int i = -4; i <= 4; ++i) {
            const double x[2] = {(i + 0.5 * (j & 1)) * dx, j * row * dx}, r = std::hypot(x[0], x[1]);
            double slope = 0;    // W'/r
            if (r > 0) use.kernel->evaluate(2, 1, &r, use.h, nullptr, &slope);
            sum -= slope * x[axis] * std::sin(k * x[axis]);
        }
    return dx * dx * row * sum / k;
}

/// Phase speed over c0 of p = sin(kx) after ten periods.
double measured_speed(const Case& c, int axis, double k) {
    const Profile now = final_state(c);
    double sine = 0, cosine = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        sine += now.p[i] * std::sin(k * now.x[axis][i]);
        cosine += now.p[i] * std::cos(k * now.x[axis][i]);
    }
    return 1 + std::atan2(-cosine, sine) / (2 * testing::pi * 10);
}

}    // namespace

TEST_CASE("the adjoint pair conserves its energy on a hexagonal set", "[energy]") {
    std::vector<std::string> set = sound;
    set.push_back("/until=0.5");
    const Summary s = run(loaded(hexagonal_box(0.05, 20, 22), set));
    CHECK(s.tier == "frozen");
    CHECK(s.particles == 440);
    CHECK(s.energy_initial > 0);
    CHECK(s.energy_final == Approx(s.energy_initial).epsilon(1e-12));
}

TEST_CASE("a long wave on a hexagonal set runs at the speed of the sum over its neighbours, along rows and across", "[symbol]") {
    for (const int axis : {0, 1})
        for (const double ratio : {1.0, 1.3}) {
            Json document = axis == 0 ? hexagonal_box(1. / 32, 32, 8) : hexagonal_box(1. / 32, 8, 32);
            document["kernel"]["h"] = ratio / 32;
            const double length = document["particles"]["upper"][std::size_t(axis)], k = 2 * testing::pi / length;
            const std::string wave = "sin(" + Json(k).dump() + (axis == 0 ? "*x)" : "*y)");
            Json u = {"0", "0"};
            u[std::size_t(axis)] = wave + "/rho0/c0";
            document["initial"] = {{"p", wave}, {"u", u}};
            document["until"] = 10 * length / 2;
            document["integrator"]["courant"] = 0.05;
            const Case c = loaded(document);
            INFO("h/dx = " << ratio << ", along " << "xy"[axis]);
            const double theory = speed_in_theory(c, axis, k);
            CHECK(std::abs(theory - 1) > 1e-3);
            CHECK(measured_speed(c, axis, k) == Approx(theory).margin(1e-4));
        }
}

TEST_CASE("the particles of a hexagonal set read from a file give the same bits", "[arrangement]") {
    double dx = 0.05;
    while (side_of(dx * dx * std::numbers::sqrt3 / 2) == 0) dx = std::nextafter(dx, 1);
    std::vector<std::string> set = sound;
    set.push_back(R"(/integrator={"type":"velocity_verlet","dt":0.004})");
    Json document = hexagonal_box(dx, 20, 22);
    const Profile first = final_state(loaded(document, set));

    const Folder folder;
    write(folder.path / "points.csv", first);
    document["particles"]["type"] = "points";
    document["particles"]["file"] = "points.csv";
    document["particles"]["dx"] = side_of(dx * dx * std::numbers::sqrt3 / 2);
    const Case from_file = loaded(document, set, folder.path / "case.json");
    const Profile second = final_state(from_file);
    CHECK(second.x[0] == first.x[0]);
    CHECK(second.x[1] == first.x[1]);
    CHECK(second.p == first.p);

    CHECK((*from_file.resolved)["particles"]["file"] == (folder.path / "points.csv").string());
    CHECK(final_state(loaded(*from_file.resolved, {}, folder.path / "elsewhere" / "case.json")).p == first.p);
}
