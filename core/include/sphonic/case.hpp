#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sphonic/equations.hpp>
#include <sphonic/expression.hpp>
#include <sphonic/json_fwd.hpp>
#include <sphonic/media_map.hpp>
#include <sphonic/plugin/abi/arrangement.hpp>
#include <sphonic/plugin/abi/boundary.hpp>
#include <sphonic/plugin/abi/integrator.hpp>
#include <sphonic/plugin/abi/method.hpp>
#include <sphonic/plugin/abi/reference.hpp>
#include <sphonic/plugin/abi/shape.hpp>
#include <sphonic/plugin/abi/source.hpp>
#include <sphonic/registry.hpp>
#include <sphonic/stretch.hpp>

namespace sphonic {

enum class Motion { frozen, lagrangian };
enum class Neighbours { automatic, lattice, frozen, moving };
/// Which particles are stepped: those that matter to what is asked for, or all.
enum class Active { automatic, all };
/// Of the fields of a lattice.
enum class Precision { usual, single };

struct SourceUse {
    std::unique_ptr<abi::Source> source;
    std::optional<Region> region;
    std::string place;    ///< for messages

    /// Writes 1 for each point in the region that the source reaches, else 0.
    void inside(const abi::Points& points, unsigned char* out) const;
    [[noreturn]] void reaches_nothing() const;
};

/// A body without particles. With `keep` "inside" the shape is what is left, and all around it is solid.
struct Obstacle {
    /// What its surface does to sound: u.n = 0, p = 0, or nothing.
    enum class Wall { rigid, soft, free };

    std::unique_ptr<abi::Shape> shape;
    Wall wall = Wall::rigid;
    bool keeps_inside = false;
    std::string place{};    ///< for messages

    bool walled() const { return wall != Wall::free; }
    /// Distance [m] of points from the wall, positive where there is fluid, and the unit vector of the nearest wall point into it.
    void measure(const abi::Box& box, const abi::Points& points, double* distance, double* const normal[3]) const;
};

/// A variable's values at t = 0, one expression per component.
struct InitialField {
    std::string variable;
    std::vector<Expression> components;
};

/// The asked-for step: exactly one of the three.
struct StepChoice {
    std::optional<double> dt;         ///< [s]
    std::optional<double> courant;    ///< c0 dt / courant_length
    double courant_length = 0;        ///< [m]
    double safety = 0.9;              ///< fraction of the computed limit, when neither is given
    bool allow_unstable = false;
};

struct ReferenceUse {
    std::unique_ptr<abi::Reference> reference;
    std::optional<Region> region{};
    std::optional<double> scale{};    ///< P [Pa]; by default the largest |p_exact| in the region
};

struct Output {
    double every = 0;    ///< interval of probe samples [s]; 0: every step
    bool fields = true;  ///< of the whole set at the end; without them only probes and the reference's region are asked for
    std::vector<std::vector<double>> probes;
};

/// A whole case, checked. What its objects need of the JSON text is kept alive in `source_text`.
struct Case {
    std::string file, title;
    int threads = 0;    ///< of a run, whose results do not depend on it; 0: as many as the set is worth
    abi::Medium medium;                        ///< number 0 of `media`
    std::shared_ptr<const MediaMap> media;
    /// Of media with spacings of their own, null otherwise: box, media, faces and what sources and expressions are asked are in its
    /// coordinate; probes, the reference and all results in x.
    std::shared_ptr<const Stretch> stretch;
    abi::Box box;
    std::unique_ptr<abi::Arrangement> arrangement;
    double jitter = 0;    ///< in units of dx
    std::int64_t seed = 1;
    std::vector<Obstacle> obstacles;
    long particles = 0;    ///< of the arrangement, without those in obstacles
    Motion motion = Motion::frozen;
    std::string velocity_name = "u";    ///< the variable that moves the particles
    Neighbours neighbours = Neighbours::automatic;
    std::vector<KernelUse> kernels;
    Equations equations;
    std::vector<std::unique_ptr<abi::Boundary>> boundaries;
    int boundary_of[3][2] = {{-1, -1}, {-1, -1}, {-1, -1}};    ///< [axis][upper], index into `boundaries`
    std::unique_ptr<abi::Boundary> stretched_faces[2];         ///< [upper], of the axis that is stretched
    std::vector<SourceUse> sources;
    std::vector<InitialField> initial;
    std::unique_ptr<abi::Integrator> integrator;
    std::string integrator_name;
    StepChoice step;
    double until = 0;    ///< [s]
    Active active = Active::automatic;
    Precision precision = Precision::usual;
    std::optional<ReferenceUse> reference;
    Output output;
    std::unique_ptr<abi::Method> method;
    std::string method_name;
    std::vector<std::string> warnings;

    Registry* registry = nullptr;        ///< that the plugins came from; outlives the case
    std::shared_ptr<Json> resolved;      ///< the case with every default; runs again to the same bits
    std::shared_ptr<Json> provenance;    ///< plugins in use with their paths, ABI, version and commit
    std::shared_ptr<const Json> source_text;
    std::vector<std::shared_ptr<const Json>> presets;

    /// Initial values of a variable's component at points; false, and nothing written, if the case gives none.
    bool initial_values(const std::string& variable, int component, const abi::Points& points, double* out) const;
    /// True where particles sit exactly on all sites of a lattice.
    bool regular() const { return arrangement->regular() && jitter == 0 && obstacles.empty(); }
    /// True where neighbours are known by their offsets on a lattice.
    bool on_lattice() const {
        const bool automatic = neighbours == Neighbours::automatic && motion == Motion::frozen && regular();
        return neighbours == Neighbours::lattice || (automatic && !equations.dissipate());
    }
    /// The boundary of a face, or null.
    const abi::Boundary* face(int axis, bool upper) const {
        if (axis == 0 && stretched_faces[upper]) return stretched_faces[upper].get();
        const int i = boundary_of[axis][upper];
        return i < 0 ? nullptr : boundaries[std::size_t(i)].get();
    }
    abi::Closure closure(int axis, bool upper) const {
        const abi::Boundary* boundary = face(axis, upper);
        return boundary ? boundary->closure() : abi::Closure::free;
    }
    /// The step nearest below `dt` of which a whole number ends the run [s].
    double whole_step(double dt) const { return until / steps_of(dt); }
    double steps_of(double dt) const;
    /// Largest interaction radius of kernels and forms [m].
    double radius() const;
    /// The evolved variable that `variable` is computed from (itself, if it is evolved), and its derivative by that at rest.
    struct Behind {
        int variable;
        double slope;
    };
    Behind behind(int variable) const;
    /// x of a point of the set, of which `s` is the first coordinate [m].
    double place(double s) const { return stretch ? stretch->place(s) : s; }
    /// The coordinate along an axis of the set of a point of which `x` is the coordinate along that of the scene [m].
    double site(int axis, double x) const { return axis == 0 && stretch ? stretch->site(x) : x; }
    /// Volume that a particle stands for [m^d].
    double particle_volume() const { return arrangement->volume(box); }
};

/// Reads and checks a case. `overrides` are "/pointer=value". Errors carry file, JSON pointer, value and remedy.
Case load_case(const std::filesystem::path& file, const std::vector<std::string>& overrides, Registry& registry);
/// The same from a parsed document; `file` names it in messages and anchors relative paths.
Case load_case(Json root, const std::filesystem::path& file, Registry& registry);

}    // namespace sphonic
