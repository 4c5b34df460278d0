#include <algorithm>
#include <cmath>

#include <sphonic/error.hpp>
#include <sphonic/parameters.hpp>
#include <sphonic/read_formula.hpp>

#include "case_reader.hpp"
#include "sites.hpp"
#include "wall_view.hpp"

namespace sphonic {
namespace {

/// The case's expressions, as shapes see them.
struct FormulaHost {
    const Case& scene;
    std::string place;
};

std::unique_ptr<abi::Formula> read_formula(const void* host, const char* text) {
    const FormulaHost& h = *static_cast<const FormulaHost*>(host);
    return std::make_unique<ReadFormula>(Expression(text, constants(h.scene), h.scene.box.dimension, h.place));
}

Obstacle read_obstacle(Case& scene, Section& section, Registry& registry) {
    Obstacle obstacle{.shape = read_plugin<abi::Shape>(scene, section, registry), .place = section.place()};
    obey_key_rules(section, "shape", scene);
    const std::string wall = section.read(common_key("shape", "wall")).text;
    obstacle.wall = wall == "rigid" ? Obstacle::Wall::rigid : wall == "soft" ? Obstacle::Wall::soft : Obstacle::Wall::free;
    obstacle.keeps_inside = std::string(section.read(common_key("shape", "keep")).text) == "inside";
    const FormulaHost host{scene, section.place()};
    prepared(section.place(), [&] { obstacle.shape->prepare({scene.box, read_formula, &host}); });
    section.finish();
    return obstacle;
}

/// What obstacles cannot be in.
void require_still_particles(const Case& scene, const Section& root) {
    const auto refuse = [&](const char* place, const char* problem, const char* remedy) { throw Error(Fault::input, root.file() + ": " + place, problem, remedy); };
    if (!scene.method->bodies())
        root.fail("obstacles", "method " + scene.method_name + " knows no obstacles", "Use method \"particles\", or \"fdtd\", which takes them as a staircase");
    if (scene.motion == Motion::lagrangian)
        refuse("/particles/motion", "\"lagrangian\" particles would run into the obstacles", "Use \"auto\", which keeps them where they are");
    if (scene.media->several()) root.fail("medium", "there are several media, and obstacles stand in one only", "Give one medium, or remove the obstacles");
    if (scene.equations.dissipate())
        root.fail("obstacles", "dissipation takes gradients behind walls, which those of obstacles do not have", "Remove the dissipation or the obstacles");
    if (scene.neighbours == Neighbours::lattice)
        refuse("/particles/neighbours", "\"lattice\" needs a full lattice, and obstacles cut particles out of it", "Use \"auto\"");
}

/// Whether a line into the solid from one of its walls comes out within `length`.
bool thinner_than(const Case& scene, const Obstacle& obstacle, const Places& solid, double length) {
    const WallView view(scene, obstacle, solid);
    const double step = 0.5 * scene.box.dx;
    Places at;
    std::vector<std::size_t> line;
    for (std::size_t i = 0; i < solid[0].size(); ++i)
        if (view.distance[i] < 0 && view.distance[i] > -0.5 * length) line.push_back(i);
    for (double depth = step; depth < length; depth += step) {
        std::vector<double> least(line.size(), length);
        for (int a = 0; a < scene.box.dimension; ++a) {
            at[a].clear();
            for (const std::size_t i : line) at[a].push_back(solid[a][i] - (view.distance[i] + depth) * view.normal[a][i]);
        }
        for (const Obstacle& other : scene.obstacles) {
            const WallView there(scene, other, at);
            std::transform(least.begin(), least.end(), there.distance.begin(), least.begin(), [](double a, double b) { return std::min(a, b); });
        }
        if (std::any_of(least.begin(), least.end(), [&](double d) { return d > 0.5 * step; })) return true;
    }
    return false;
}

/// Counts what is left, and says what may surprise.
void cut(Case& scene, const Section& root) {
    std::optional<Sites> sites;
    prepared(root.place("obstacles"), [&] { sites.emplace(scene); });
    scene.particles = sites->count();
    if (scene.particles < 2)
        root.fail("obstacles", "they leave " + std::to_string(scene.particles) + " of " + std::to_string(scene.arrangement->size(scene.box)) + " particles",
                  "Make the solid smaller, or keep the shape's other side");
    const double both_sides = 2 * scene.radius();
    for (std::size_t k = 0; k < sites->cut.size(); ++k) {
        const Obstacle& obstacle = scene.obstacles[k];
        const std::string place = "/obstacles/" + std::to_string(k);
        if (sites->cut[k] == 0)
            scene.warnings.push_back(place + ": no particle lies in the solid, and it acts through those that it cuts out: it changes nothing");
        else if (obstacle.walled() && thinner_than(scene, obstacle, sites->solid, both_sides))
            scene.warnings.push_back(place + ": it is thinner than twice the reach of the weights, " + number_text(both_sides) +
                                     " m: what is behind one side of it acts on the other too");
    }
}

}    // namespace

/// On periodic axes the body comes again with every period: of the nearest three images of each, the one whose surface counts.
void Obstacle::measure(const abi::Box& box, const abi::Points& points, double* distance, double* const normal[3]) const {
    int images = 1;
    for (int a = 0; a < box.dimension; ++a) images *= box.periodic[a] ? 3 : 1;
    const std::size_t n = std::size_t(points.n), d = std::size_t(box.dimension);
    std::vector<double> there[3], far(n), out[3];
    for (int image = 0; image < images; ++image) {
        abi::Points moved{.dimension = points.dimension, .n = points.n};
        double* to[3] = {};
        for (std::size_t a = 0, rest = std::size_t(image); a < d; ++a) {
            const double shift = box.periodic[a] ? double(rest % 3 == 2 ? -1 : int(rest % 3)) * (box.upper[a] - box.lower[a]) : 0;
            if (box.periodic[a]) rest /= 3;
            there[a].resize(n);
            out[a].resize(n);
            std::transform(points.x[a], points.x[a] + n, there[a].begin(), [shift](double x) { return x + shift; });
            moved.x[a] = there[a].data();
            to[a] = out[a].data();
        }
        shape->measure(moved, far.data(), to);
        for (std::size_t i = 0; i < n; ++i) {
            if (image > 0 && far[i] >= distance[i]) continue;
            distance[i] = far[i];
            for (std::size_t a = 0; a < d; ++a) normal[a][i] = out[a][i];
        }
    }
    if (!keeps_inside) return;
    for (std::size_t i = 0; i < n; ++i) {
        distance[i] = -distance[i];
        for (std::size_t a = 0; a < d; ++a) normal[a][i] = -normal[a][i];
    }
}

void read_obstacles(Case& scene, Section& root, Registry& registry) {
    const Json* list = root.find("obstacles");
    if (!list) return;
    if (!list->is_array()) root.fail("obstacles", shown(*list) + " is not a list", "Write [ { \"type\": ... } ]");
    Json resolved = Json::array();
    for (std::size_t i = 0; i < list->size(); ++i) {
        Section section((*list)[i], root.file(), "/obstacles/" + std::to_string(i));
        scene.obstacles.push_back(read_obstacle(scene, section, registry));
        resolved.push_back(section.resolved);
    }
    root.resolved["obstacles"] = resolved;
    if (scene.obstacles.empty()) return;
    require_still_particles(scene, root);
    cut(scene, root);
}

}    // namespace sphonic
