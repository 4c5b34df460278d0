#include <algorithm>
#include <cmath>
#include <limits>

#include <sphonic/error.hpp>
#include <sphonic/parameters.hpp>
#include <sphonic/plugin/abi/boundary.hpp>

#include "case_reader.hpp"
#include "machine.hpp"

namespace sphonic {
namespace {

/// Bytes per particle that a run is sure to need: fields, histories and lists of a small case.
constexpr double least_bytes_per_particle = 100;
constexpr double most_particles = std::numeric_limits<int>::max();

/// "x_min" ... "z_max", an axis, or "all", as a list of (axis, upper side).
std::vector<std::pair<int, bool>> faces(const std::string& name, int dimension, const Section& section) {
    std::vector<std::pair<int, bool>> list;
    const std::string axes = "xyz";
    for (int a = 0; a < dimension; ++a) {
        const std::string axis(1, axes[std::size_t(a)]);
        if (name == "all" || name == axis || name == axis + "_min") list.emplace_back(a, false);
        if (name == "all" || name == axis || name == axis + "_max") list.emplace_back(a, true);
    }
    if (list.empty())
        section.fail("face", "\"" + name + "\" is no face in dimension " + std::to_string(dimension),
                     "Give x_min, x_max, ... of an axis that exists, an axis such as \"x\", or \"all\"");
    return list;
}

void read_boundaries(Case& scene, Section& root, Registry& registry) {
    const Json* list = root.find("boundaries");
    if (!list) return;
    if (!list->is_array()) root.fail("boundaries", shown(*list) + " is not a list", "Write [ { \"type\": ..., \"face\": ... } ]");
    int given[3][2] = {}, periodic[3][2] = {};
    Json resolved = Json::array();
    for (std::size_t i = 0; i < list->size(); ++i) {
        Section section((*list)[i], root.file(), "/boundaries/" + std::to_string(i));
        scene.boundaries.push_back(read_plugin<abi::Boundary>(scene, section, registry));
        obey_key_rules(section, "boundary", scene);
        for (const auto& [axis, upper] : faces(section.text("face", ""), scene.box.dimension, section)) {
            if (given[axis][upper]++) section.fail("face", "this face has a boundary already", "Give each face one boundary");
            periodic[axis][upper] = scene.boundaries.back()->closure() == abi::Closure::periodic;
            scene.boundary_of[axis][upper] = int(i);
        }
        section.finish();
        resolved.push_back(section.resolved);
    }
    for (int a = 0; a < scene.box.dimension; ++a) {
        if (periodic[a][0] != periodic[a][1])
            root.fail("boundaries", "only one face of the axis " + std::string(1, "xyz"[a]) + " is periodic",
                      "Give the axis as face: \"" + std::string(1, "xyz"[a]) + "\"");
        scene.box.periodic[a] = periodic[a][0];
    }
    root.resolved["boundaries"] = resolved;
}

/// Sites per axis: periodic axes exclude the upper end and must hold a whole number of spacings.
double sites(const abi::Box& box, int axis, bool on_sites, const Section& section) {
    const double length = (box.upper[axis] - box.lower[axis]) / box.dx;
    if (!std::isfinite(length)) section.fail("dx", "the box is more spacings long than a number can count", "Choose a larger dx or a smaller box");
    if (!box.periodic[axis]) return std::floor(length + 1e-9) + 1;
    if (on_sites && std::abs(length - std::round(length)) > 1e-6)
        section.fail("dx", "the periodic axis " + std::string(1, "xyz"[axis]) + " is " + number_text(length) + " spacings long",
                     "Choose dx or upper so that (upper - lower)/dx is an integer");
    return std::round(length);
}

void count_sites(const Case& scene, abi::Box& box, const Section& section) {
    const bool on_sites = scene.arrangement->regular() || !scene.method->meshfree();
    double total = 1;
    for (int a = 0; a < box.dimension; ++a) {
        if (box.upper[a] <= box.lower[a])
            section.fail("upper", "upper is not above lower along axis " + std::string(1, "xyz"[a]), "Give upper > lower");
        const double n = sites(box, a, on_sites, section);
        if (on_sites && n < 2) section.fail("dx", "there are fewer than two particles along axis " + std::string(1, "xyz"[a]), "Choose a smaller dx");
        total *= n;
        box.count[a] = n < 9e18 ? long(n) : 0;
    }
    const double need = total * least_bytes_per_particle, free = available_memory();
    const std::string holds = "the box " + std::string(on_sites ? "holds " : "has room for ") + number_text(total) + " particles, ", remedy = "Choose a larger dx or a smaller box";
    if (need > free)
        section.fail("dx", holds + "which need at least " + number_text(std::round(need / 1e9)) + " GB; " +
                     number_text(std::round(free / 1e9)) + " GB are free", remedy);
    if (total > most_particles) section.fail("dx", holds + "more than the " + number_text(most_particles) + " that can be numbered", remedy);
}

}    // namespace

void read_space(Case& scene, Section& root, Registry& registry) {
    read_boundaries(scene, root, registry);
    Section section = root.child("particles", "Give { \"type\": \"lattice\", \"dx\": ..., \"lower\": [...], \"upper\": [...] }");
    abi::Box& box = scene.box;
    scene.arrangement = read_plugin<abi::Arrangement>(scene, section, registry);
    obey_key_rules(section, "arrangement", scene);
    box.dx = section.real(common_key("arrangement", "dx"));
    const auto lower = section.point("lower", box.dimension), upper = section.point("upper", box.dimension);
    std::copy(lower.begin(), lower.end(), box.lower);
    std::copy(upper.begin(), upper.end(), box.upper);
    scene.jitter = section.real(common_key("arrangement", "jitter"));
    scene.seed = section.read(common_key("arrangement", "seed")).integer;
    scene.arrangement->seed(scene.seed);
    const std::string motion = section.read(common_key("arrangement", "motion")).text;
    scene.motion = motion == "lagrangian" ? Motion::lagrangian : Motion::frozen;
    const std::string neighbours = section.read(common_key("arrangement", "neighbours")).text;
    if (neighbours == "lattice") scene.neighbours = Neighbours::lattice;
    if (neighbours == "frozen") scene.neighbours = Neighbours::frozen;
    if (neighbours == "moving") scene.neighbours = Neighbours::moving;
    if (neighbours == "lattice" && (scene.motion == Motion::lagrangian || !scene.regular()))
        section.fail("neighbours", "\"lattice\" needs a frozen, regular arrangement", "Use \"auto\"");
    if (neighbours == "frozen" && scene.motion == Motion::lagrangian)
        section.fail("neighbours", "\"frozen\" needs particles that do not move", "Use \"auto\"");
    scene.velocity_name = section.read(common_key("arrangement", "velocity")).text;
    section.finish();
    root.resolved["particles"] = section.resolved;
}

void lay_out(Case& scene, const Section& root) {
    const Section section(root.value()["particles"], root.file(), "/particles");
    abi::Box box = scene.box;
    if (scene.stretch) box.upper[0] = scene.stretch->site(box.upper[0]);
    count_sites(scene, box, section);
    prepared(section.place(), [&] { scene.arrangement->prepare(box); });
    scene.particles = scene.arrangement->size(box);
    if (scene.particles < 2) section.fail("", "there are fewer than two particles", "Choose a smaller dx or a larger box");
    std::copy(box.count, box.count + 3, scene.box.count);
}

}    // namespace sphonic
