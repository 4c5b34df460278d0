#pragma once
#include <limits>
#include <memory>
#include <sphonic/plugin/abi/arrangement.hpp>
#include <sphonic/plugin/abi/boundary.hpp>
#include <sphonic/plugin/abi/source.hpp>

namespace sphonic::abi {

/// What a running simulation shows of itself; valid until the next step.
struct Snapshot {
    Points points;                                       ///< where p is known
    const double* p = nullptr;                           ///< [Pa]
    const double* u[3] = {nullptr, nullptr, nullptr};    ///< [m/s] at the points
};

/// How much of a set was stepped, and what that leaves out.
struct Activity {
    double particle_steps = -1;    ///< so far; negative: all
    double ideal_steps = -1;       ///< in the whole run, if only sound at the speed c0 that matters in the end were stepped; negative: all
    double error_bound = 0;        ///< what the rest can have changed so far, over the largest amplitude
    const char* all_because = "";  ///< why all is stepped where less was wanted
};

/// A discretised scene in time.
class Solver {
public:
    virtual ~Solver() = default;

    /// Largest stable step [s]; infinity where none is known.
    virtual double dt_limit() const = 0;
    /// True if every step grows and dt_limit only bounds by how much.
    virtual bool weakly_unstable() const { return false; }
    /// Fix the step and set the initial state; called once, before `step`.
    virtual void start(double dt) = 0;
    virtual void step() = 0;
    virtual double time() const = 0;
    virtual Snapshot snapshot() = 0;
    /// Pressure [Pa] at one of the snapshot's points.
    virtual double pressure(long point) { return snapshot().p[point]; }
    virtual Activity activity() const { return {}; }
    /// The scheme's own discrete energy [J/m^(3-d)].
    virtual double energy() = 0;
    /// The initial energy and the most that sources can have put in so far: a stable run stays below. Infinity if not known.
    virtual double energy_bound() const { return std::numeric_limits<double>::infinity(); }
    virtual const char* tier() const = 0;
    /// Mean number of neighbours without the particle itself.
    virtual double neighbours_mean() const = 0;
    /// Bytes held by fields, weights and lists.
    virtual double memory_bytes() const = 0;
};

/// A source with the region it acts on.
struct PlacedSource {
    Source* source = nullptr;
    /// Writes 1 for each point that lies in the case's region and that the source reaches, else 0.
    void (*inside)(const void* host, const Points& points, unsigned char* out) = nullptr;
    /// Throws the error of a source without points, at its place in the case.
    void (*reaches_nothing)(const void* host) = nullptr;
    const void* host = nullptr;
};

/// What a point lies in: no body, or one whose wall lets no velocity through, has p = 0, or does nothing but end the sound's medium.
enum class Body : unsigned char { none, rigid, soft, free };

/// The scene as a method sees it.
struct Scene {
    Box box;
    Medium medium;    ///< number 0 of `media`
    Media media;
    const Boundary* face[3][2] = {};    ///< [axis][upper]; null: the box simply ends
    double until = 0;    ///< [s]
    int threads = 1;     ///< that a method may use
    const PlacedSource* sources = nullptr;
    int source_count = 0;
    /// Initial values of a field ("p", or component `axis` of "u") at points; false, and nothing written, if the case gives none.
    bool (*initial)(const void* host, const char* field, int axis, const Points& points, double* out) = nullptr;
    /// Writes the body that each point lies in, those on a wall in none. Null without bodies.
    void (*bodies)(const void* host, const Points& points, Body* out) = nullptr;
    /// The runtime's particle solver for this scene.
    std::unique_ptr<Solver> (*particles)(const void* host) = nullptr;
    const void* host = nullptr;
};

/// How an infinite grid of one medium carries the waves p, u ~ exp(i k . x):
///   p(t) = p(0) cos(omega t) - i rho0 c0 (along . u(0)) sin(omega t).
struct CarriedWave {
    double omega = 0;              ///< [rad/s]
    double along[3] = {0, 0, 0};   ///< of length 1
};

/// A discretisation: particles, or a baseline that runs the same case.
class Method {
public:
    static constexpr const char* kind = "method";
    virtual ~Method() = default;
    /// Throws std::invalid_argument with a remedy where the scene has what the method does not know.
    virtual std::unique_ptr<Solver> discretise(const Scene& scene) const = 0;
    /// False for a method that needs no kernel, equations or viscosity; a case that names them then gets a warning.
    virtual bool meshfree() const = 0;
    /// True for one that knows of several media; a case that has them is refused for the others.
    virtual bool several_media() const { return false; }
    /// True for one that knows of bodies; a case that has them is refused for the others.
    virtual bool bodies() const { return meshfree(); }
    /// The wave of wave vector k [rad/m] in steps of dt [s], for predictions; false, and nothing written, where the method's theory is not known.
    virtual bool carry(const Medium&, const Box&, double /*dt*/, const double* /*k*/, CarriedWave&) const { return false; }
};

}    // namespace sphonic::abi
