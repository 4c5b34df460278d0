#pragma once
#include <cmath>
#include <vector>

#include <sphonic/plugin/energy_budget.hpp>

#include "bodies.hpp"
#include "media.hpp"

namespace staggered {

/// The sources of a scene on the points of p and of each component of u, and the energy that they can bring.
class Sources {
public:
    Sources(const abi::Scene& scene, const Grid& grid, const Media& media) : grid_(grid), media_(media), budget_(scene.box, media.fastest()) {
        for (int s = 0; s < scene.source_count; ++s) all_.push_back(place(scene, scene.sources[s]));
    }

    bool set_pressure() const { return any([](const abi::Action& a) { return a.sets_pressure; }); }
    bool set_velocity() const { return any([](const abi::Action& a) { return a.sets_velocity; }); }
    bool adds() const { return any([](const abi::Action& a) { return a.adds; }); }
    EnergyBudget& budget() { return budget_; }
    const EnergyBudget& budget() const { return budget_; }

    /// response(omega, medium) is how the grid carries a tone.
    template <class Response>
    void match(Response response) {
        for (Placed& s : all_)
            if (const double omega = s.source->tone()) s.source->match(response(omega, media_.of(s.p.at[s.p.at.size() / 2])));
    }
    /// p at t = 0, u at t = -dt/2.
    void start(Field& p, Field* u, double dt) {
        set_pressure(p, 0);
        for (Placed& s : all_)
            if (s.action.sets_velocity || s.action.sets_velocity_at_start) impose_velocity(s, u, -dt / 2);
    }
    void set_pressure(Field& p, double t) {
        for (Placed& s : all_) {
            if (!s.action.sets_pressure) continue;
            evaluate(s, s.p, -1, t);
            for (std::size_t i = 0; i < s.p.at.size(); ++i) budget_.imposed(s.p.value[i], 1 / media_.bulk_of(s.p.at[i]));
            s.p.put(p);
        }
    }
    void set_velocity(Field* u, double t) {
        for (Placed& s : all_)
            if (s.action.sets_velocity) impose_velocity(s, u, t);
    }
    /// p += dt times the rates at t; true if any is not zero.
    bool add_pressure(Field& p, double t, double dt) { return add(-1, p, t, dt); }
    bool add_velocity(int axis, Field& u, double t, double dt) { return add(axis, u, t, dt); }

private:
    struct Placed {
        abi::Source* source;
        abi::Action action;
        PointSet p, u[3];
    };
    const Grid& grid_;
    const Media& media_;
    EnergyBudget budget_;
    std::vector<Placed> all_;

    template <class Is>
    bool any(Is is) const {
        return std::any_of(all_.begin(), all_.end(), [&](const Placed& s) { return is(s.action); });
    }
    Placed place(const abi::Scene& scene, const abi::PlacedSource& placed) const {
        Placed out{.source = placed.source, .action = placed.source->action(), .p = outside_bodies(scene, grid_.all(-1)).members(placed), .u = {}};
        for (int a = 0; a < grid_.dimension; ++a) out.u[a] = grid_.all(a).members(placed);
        if (out.p.at.empty()) placed.reaches_nothing(placed.host);
        placed.source->enlist(out.p.points(), grid_.cell());
        return out;
    }
    void evaluate(const Placed& s, PointSet& set, int axis, double t) const {
        abi::AcousticField out;
        (axis < 0 ? out.p : out.u[axis]) = set.value.data();
        s.source->evaluate(t, set.points(), out);
    }
    void impose_velocity(Placed& s, Field* u, double t) {
        for (int a = 0; a < grid_.dimension; ++a) {
            evaluate(s, s.u[a], a, t);
            for (std::size_t i = 0; i < s.u[a].at.size(); ++i) budget_.imposed(s.u[a].value[i], media_.density_of(a, s.u[a].at[i]));
            s.u[a].put(u[a]);
        }
    }
    bool add(int axis, Field& field, double t, double dt) {
        double energy = 0;
        for (Placed& s : all_) {
            if (!s.action.adds) continue;
            PointSet& set = axis < 0 ? s.p : s.u[axis];
            evaluate(s, set, axis, t);
            double own = 0;
            for (std::size_t i = 0; i < set.at.size(); ++i) {
                const double inertia = axis < 0 ? 1 / media_.bulk_of(set.at[i]) : media_.density_of(axis, set.at[i]);
                own += inertia * set.value[i] * set.value[i];
                field[set.at[i]] += dt * set.value[i];
            }
            budget_.added(0.5 * grid_.cell() * own, dt);
            energy += own;
        }
        return energy > 0;
    }
};

}    // namespace staggered
