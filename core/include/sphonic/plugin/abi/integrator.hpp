#pragma once

namespace sphonic::abi {

/// A set of variables that an integrator advances together.
/// Values from 0 on are the splitting groups of the case ("order"), in their order; by default vectors, then the rest.
using Group = int;
inline constexpr Group everything = -1;    ///< all evolved variables, positions included
inline constexpr Group fields = -2;        ///< all evolved variables except positions
inline constexpr Group positions = -3;     ///< positions alone; empty on frozen sets

/// A copy of the whole state's size: the state itself, or a named array that the runtime allocates, zeroes and keeps.
using Slot = int;
inline constexpr Slot state = 0;

/// All that an integrator sees of the equations.
class System {
public:
    virtual ~System() = default;

    virtual int groups() const = 0;
    /// The array of that name, zero when first asked for. Every array must be asked for in the first step (index 0).
    virtual Slot history(const char* name) = 0;
    /// out[group] = time derivative of the group at the present state and time t [s]. `out` is not the state.
    virtual void rate(Group group, double t, Slot out) = 0;
    /// state[group] += dt * (its time derivative), in one pass where the group does not read itself.
    virtual void advance(Group group, double t, double dt) = 0;
    /// to[group] = from[group]
    virtual void copy(Group group, Slot from, Slot to) = 0;
    /// y[group] += a x[group]
    virtual void axpy(Group group, double a, Slot x, Slot y) = 0;
    /// After the group changed: impose sources at time t, refresh algebraic variables and ghosts.
    virtual void settle(Group group, double t) = 0;
};

/// Where u stands in time when p is at t_n: the discrete energy that the scheme conserves depends on it.
/// `behind`: at t_n - dt/2, from the given initial u on; `behind_after_start`: the given u is at t = 0 and the first step
/// takes it to dt/2; `centred`: at t_n, in a scheme that kicks by halves.
enum class Stagger : int { none, behind, behind_after_start, centred };

struct Step {
    long index;    ///< 0 for the first step of a run
    double t;      ///< time at the beginning of the step [s]
    double dt;     ///< [s]
};

/// A time integrator. Stateless: what it must remember lives in history slots.
class Integrator {
public:
    static constexpr const char* kind = "integrator";
    virtual ~Integrator() = default;

    /// Called once, before the first step of dt [s], with the values given at t = 0: makes of them what the scheme works with.
    virtual void begin(System&, double) const {}
    virtual void step(System& system, const Step& step) const = 0;
    virtual Stagger stagger() const { return Stagger::none; }
};

}    // namespace sphonic::abi
