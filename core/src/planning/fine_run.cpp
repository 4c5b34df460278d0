#include "fine_run.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <sphonic/error.hpp>
#include <sphonic/shown.hpp>

#include "choices.hpp"
#include "cost.hpp"
#include "machine.hpp"
#include "spacings.hpp"

namespace sphonic {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double refinement = 0.7;    ///< from run to run
constexpr double window = 0.25, looks_per_period = 12;    ///< about the other moment, in periods of the shortest wave: half of the longest step

/// Up to four sites about a place, with Lagrange's weights; shifted inwards at the ends of an axis that does not repeat.
struct Stencil {
    std::array<long, 4> site{};
    std::array<double, 4> weight{};
    long n = 0;

    Stencil(const abi::Box& box, int axis, double x) {
        const double place = (x - box.lower[axis]) / box.dx;
        n = std::min(4L, box.count[axis]);
        long first = long(std::floor(place)) - (n - 1) / 2;
        if (!box.periodic[axis]) first = std::clamp(first, 0L, box.count[axis] - n);
        for (long i = 0; i < n; ++i) {
            weight[std::size_t(i)] = 1;
            for (long j = 0; j < n; ++j)
                if (j != i) weight[std::size_t(i)] *= (place - double(first + j)) / double(i - j);
            site[std::size_t(i)] = ((first + i) % box.count[axis] + box.count[axis]) % box.count[axis];
        }
    }
};

bool lets_out(const Json& boundary) {
    const std::string type = boundary.value("type", "");
    return type == "absorbing_layer" || type == "absorbing_mur";
}

bool on_face(const Json& boundary, int axis, bool upper) {
    const Json given = boundary.value("face", Json());
    const std::string name{"xyz"[axis]}, side = name + (upper ? "_max" : "_min");
    for (const Json& face : given.is_array() ? given : Json::array({given}))
        if (face == "all" || face == name || face == side) return true;
    return false;
}

/// Visits (boundary, axis, upper) of all faces that boundaries name.
template <class Visit>
void for_faces(const OpenCase& open, Visit visit) {
    if (!open.document.contains("boundaries")) return;
    for (const Json& boundary : open.document["boundaries"])
        for (int a = 0; a < open.dimension(); ++a)
            for (const bool upper : {false, true})
                if (on_face(boundary, a, upper)) visit(boundary, a, upper);
}

/// Into small factors, as fast Fourier transforms like it.
bool splits(long n) {
    for (const long factor : {2, 3, 5, 7})
        while (n % factor == 0) n /= factor;
    return n == 1;
}

/// The scene without disorder and outputs, with what lets sound out so far away that nothing comes back before the end.
OpenCase widened(const OpenCase& open, double dx) {
    OpenCase wide = open;
    for (const char* key : {"output", "precision", "accuracy"}) wide.document.erase(key);
    Json& particles = wide.document["particles"];
    if (wide.document["medium"].is_array())
        for (Json& one : wide.document["medium"]) one.erase("dx");
    particles = {{"type", "lattice"}, {"lower", particles["lower"]}, {"upper", particles["upper"]}};
    wide.spacing = wide.step = wide.integrator = wide.equations = wide.kernel = wide.method = true;
    for (const char* key : {"integrator", "equations", "kernel", "kernels", "method", "dissipation"}) wide.document.erase(key);
    double fastest = 0;
    const Json& medium = wide.document["medium"];
    for (const Json& one : medium.is_array() ? medium : Json::array({medium})) fastest = std::max(fastest, one.value("c0", 0.0));
    const double half_way = fastest * wide.document["until"].get<double>() / 2;    // that sound comes there and back
    long further[3], faces[3] = {0, 0, 0};
    for_faces(open, [&](const Json& boundary, int a, bool) { faces[a] += lets_out(boundary); });
    for (int a = 0; a < open.dimension(); ++a) {
        const long sites = std::lround(open.length(a) / dx) + 1;
        further[a] = long(std::ceil(half_way / dx));
        while (faces[a] > 0 && !splits(sites + faces[a] * further[a])) ++further[a];
    }
    for_faces(open, [&](const Json& boundary, int a, bool upper) {
        if (!lets_out(boundary)) return;
        Json& corner = particles[upper ? "upper" : "lower"][std::size_t(a)];
        corner = corner.get<double>() + (upper ? 1 : -1) * double(further[a]) * dx;
    });
    return wide;
}

/// A choice, and the points of the shortest wave that its first run has.
struct Trusted {
    Choice choice;
    double points;
};

/// What is trusted to come to the truth as its spacing shrinks, the best first.
std::vector<Trusted> trusted(const OpenCase& open) {
    const double diagonal = std::sqrt(double(open.dimension()));
    const auto grid = [&](const char* name, Json method, double courant) {
        return Choice{.family = name, .method = std::move(method), .equations = {}, .kernel = {}, .integrator = {{"type", "leapfrog"}, {"courant", courant / diagonal}}};
    };
    const Choice kernels{.family = "corrected kernels", .method = {{"type", "particles"}}, .equations = "corrected_acoustics",
                         .kernel = {{"type", "cubic_spline"}, {"h_over_dx", 1}}, .integrator = {{"type", "leapfrog"}, {"safety", 0.95}}};
    std::vector<Trusted> list;
    const bool bodies = open.document.contains("obstacles");    // a staircase to a grid
    if (!bodies && !several_media(open)) list.push_back({grid("k-space", {{"type", "kspace"}}, 0.8), 4});    // exact in one medium, whatever the step
    if (!bodies) list.push_back({grid("FDTD of order 4", {{"type", "fdtd"}, {"order", 4}}, 0.25), 8});
    if (!bodies) list.push_back({grid("FDTD of order 2", {{"type", "fdtd"}, {"order", 2}}, 0.5), 8});
    if (!several_media(open)) list.push_back({kernels, 8});
    return list;
}

double slowest_speed(const Case& scene) { return std::ranges::min(scene.media->list(), {}, &abi::Medium::c0).c0; }

}    // namespace

LatticeField::LatticeField(const Profile& profile, const abi::Box& box) : t_(profile.t), box_(box) {
    long sites = 1;
    for (int a = 0; a < box.dimension; ++a) sites *= box.count[a];
    p_.assign(std::size_t(sites), unknown);
    for (std::size_t i = 0; i < profile.p.size(); ++i) {
        long site = 0;
        for (int a = box.dimension - 1; a >= 0; --a) site = site * box.count[a] + std::lround((profile.x[a][i] - box.lower[a]) / box.dx);
        p_[std::size_t(site)] = profile.p[i];
    }
}

double LatticeField::at(const double x[3]) const {
    std::array<Stencil, 3> s{Stencil(box_, 0, x[0]), Stencil(box_, 0, x[0]), Stencil(box_, 0, x[0])};
    for (int a = 1; a < box_.dimension; ++a) s[std::size_t(a)] = Stencil(box_, a, x[a]);
    const long ny = box_.dimension > 1 ? s[1].n : 1, nz = box_.dimension > 2 ? s[2].n : 1;
    double sum = 0;
    for (long k = 0; k < nz; ++k)
        for (long j = 0; j < ny; ++j) {
            const double across = (nz > 1 ? s[2].weight[std::size_t(k)] : 1) * (ny > 1 ? s[1].weight[std::size_t(j)] : 1);
            const long row = (nz > 1 ? s[2].site[std::size_t(k)] * box_.count[1] : 0) + (ny > 1 ? s[1].site[std::size_t(j)] : 0);
            for (long i = 0; i < s[0].n; ++i) sum += across * s[0].weight[std::size_t(i)] * p_[std::size_t(row * box_.count[0] + s[0].site[std::size_t(i)])];
        }
    return sum;
}

FineRun::FineRun(const OpenCase& open, Simulation& run, const Case& scene, double period, std::string name) : name_(std::move(name)) {
    for (int a = 0; a < open.dimension(); ++a) {
        const double rounding = 1e-9 * open.length(a);
        inner_lower_[a] = open.document["particles"]["lower"][std::size_t(a)].get<double>() - rounding;
        inner_upper_[a] = open.document["particles"]["upper"][std::size_t(a)].get<double>() + rounding;
    }
    for_faces(open, [&](const Json& boundary, int a, bool upper) {
        if (!lets_out(boundary)) return;
        const double thickness = boundary.value("thickness", 0.0), face = open.document["particles"][upper ? "upper" : "lower"][std::size_t(a)];
        if (thickness > 0) (upper ? inner_upper_ : inner_lower_)[a] = upper ? face - thickness : face + thickness;
    });
    const Summary& s = run.summary();
    const double middle = other_moment * scene.until;
    long last = -1;
    for (double t = std::max(0.0, middle - window * period); t <= std::min(scene.until, middle + window * period) + s.dt / 2; t += period / looks_per_period) {
        const long step = std::min(std::lround(t / s.dt), s.steps - 1);
        if (step <= last) continue;
        last = step;
        run.run_to(step);
        Profile now = run.profile();
        about_other_.emplace_back(now, scene.box);
        if (t <= middle) other_ = std::move(now);
    }
    run.run();
    end_ = run.profile();
    at_end_.emplace_back(end_, scene.box);
}

double FineRun::value(const std::vector<LatticeField>& fields, double t, const double x[3]) const {
    double sum = 0;
    for (const LatticeField& field : fields) {
        double weight = 1;
        for (const LatticeField& other : fields)
            if (&other != &field) weight *= (t - other.t()) / (field.t() - other.t());
        if (weight != 0) sum += weight * field.at(x);
    }
    return sum;
}

Moment FineRun::moment(const Profile& now, bool at_end) const {
    const std::vector<LatticeField>& fields = at_end ? at_end_ : about_other_;
    Moment moment;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        double x[3] = {0, 0, 0};
        bool inside = std::isfinite(now.p[i]);
        for (int a = 0; a < 3 && !now.x[a].empty(); ++a) {
            x[a] = now.x[a][i];
            inside = inside && x[a] > inner_lower_[a] && x[a] < inner_upper_[a];
        }
        const double p = inside ? value(fields, now.t, x) : unknown;
        if (std::isnan(p)) continue;
        moment.error += now.share_of(i) * std::pow(now.p[i] - p, 2);
        moment.power += now.share_of(i) * p * p;
    }
    return moment;
}

std::unique_ptr<FineRun> FineRun::find(const OpenCase& open, double shortest, double target, double most_cpu_s, Registry& registry) {
    constexpr double most_sites = 3e6, settled = 1.0 / 10, of_use = 1.0 / 2;    // the latter of the target
    const double begin = cpu_seconds();
    for (const auto& [choice, points] : trusted(open)) {
        std::unique_ptr<FineRun> coarser;
        const auto as_it_is = [&] { return coarser && coarser->off_by_ <= of_use * target ? std::move(coarser) : nullptr; };
        try {
            for (double wanted = shortest / points;; wanted *= refinement) {
                const std::vector<double> finer = spacings(open, wanted, most_sites);
                if (finer.empty()) return as_it_is();
                const Case scene = load_case(choice.apply(widened(open, finer.front()), finer.front(), shortest), open.file, registry);
                Simulation run(scene);
                if (cpu_seconds() - begin + predicted_seconds(present_costs(), scene, run.summary(), false) > most_cpu_s) return as_it_is();
                std::unique_ptr<FineRun> fine(new FineRun(open, run, scene, shortest / slowest_speed(scene), "a run of " + choice.family + " at dx = " + shown(finer.front(), 3) + " m"));
                if (run.summary().diverged) break;
                if (coarser) fine->off_by_ = worst_l2(fine->moment(coarser->other_, false), fine->moment(coarser->end_, true));
                if (coarser && fine->off_by_ <= settled * target) return fine;
                coarser = std::move(fine);
            }
        } catch (const Error& e) {
            if (e.fault != Fault::input) throw;    // this one does not model the scene
        }
    }
    return {};
}
}    // namespace sphonic
