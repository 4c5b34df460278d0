#include <algorithm>
#include <cmath>
#include <cstdio>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/shown.hpp>
#include <sphonic/stability_table.hpp>

namespace sphonic {
namespace {

constexpr double most_neighbours = 500;
constexpr double widths[] = {1, 1.3, 2, 3.25};
constexpr int sides[4] = {0, 40, 24, 10};                                  ///< twice the reach or more
constexpr StabilityTrial::Options brief{.steps = 800, .precision = 2e-3};    ///< at 0.4 % beyond its limit RK4 grows by 3 % a step
constexpr StabilityTrial::Options long_runs{.steps = 4000, .precision = 5e-3};

/// "divergence gradient" of the forms, such as "difference sum".
Json equations(const std::string& forms) {
    const auto space = forms.find(' ');
    const auto term = [](const char* op, const char* of, const std::string& form, const char* times) {
        return Json::array({Json{{op, of}, {"form", form}, {"times", times}}});
    };
    return {{"p", term("divergence", "u", forms.substr(0, space), "-rho0*c0^2")}, {"u", term("gradient", "p", forms.substr(space + 1), "-1/rho0")}};
}

Json document_of(const LimitTable::Row& row, const std::string& forms, const std::string& face) {
    const auto edges = [&](double x) { return Json(std::vector<double>(std::size_t(row.dimension), x)); };
    return {{"dimension", row.dimension},
            {"medium", {{"c0", 1}, {"rho0", 1}}},
            {"particles", {{"type", "lattice"}, {"dx", 1}, {"lower", edges(0)}, {"upper", edges(row.side)}}},
            {"kernel", {{"type", row.kernel}, {"h_over_dx", row.h_over_dx}}},
            {"equations", equations(forms)},
            {"boundaries", Json::array({Json{{"type", face}, {"face", "all"}}})},
            {"integrator", {{"type", row.integrator}, {"courant", 0.5}, {"unstable", "allow"}}},
            {"until", 1}};
}

/// Within the reach of the kernel, about.
double neighbours(const Case& scene) {
    const double reach = scene.radius() / scene.box.dx, pi = std::acos(-1.0);
    return scene.box.dimension == 1 ? 2 * reach : scene.box.dimension == 2 ? pi * reach * reach : 4 * pi / 3 * std::pow(reach, 3);
}

}    // namespace

bool LimitTable::Row::holds() const {
    if (!(std::abs(deviation()) <= allowed)) return false;
    if (!inviscid || !always_on) return true;
    const double slack = 1 + brief.precision;
    return measured < std::max(*inviscid, *always_on) * slack && measured * slack > std::min(*inviscid, *always_on);
}

std::string name_of(const LimitTable::Row& row) {
    return row.group + ": " + row.set + ", " + row.kernel + " of h/dx = " + shown(row.h_over_dx) + ", " + row.integrator + ", " + std::to_string(row.side) + " a side in " +
           std::to_string(row.dimension) + "-D";
}

LimitTable::LimitTable(Registry& registry) : registry_(registry) {
    list_lattices();
    list_viscosity();
    list_disorder();
    list_walls();
}

/// Nothing of a kernel that does not claim the dimension or reaches no neighbour or too many, or of an integrator without a limit.
void LimitTable::add(Row row, const std::string& forms, const std::string& face, const Json& more) {
    Json document = document_of(row, forms, face);
    document.merge_patch(more);
    try {
        const Case scene = load_case(document, "table", registry_);
        if (neighbours(scene) > most_neighbours || oscillator_limit(scene) == 0) return;
    } catch (const Error&) {
        return;
    }
    rows_.push_back(std::move(row));
    documents_.push_back(document.dump());
}

void LimitTable::list_lattices() {
    for (int d = 1; d <= 3; ++d)
        for (const std::string& kernel : registry_.names("kernel"))
            for (const double h : widths)
                for (const std::string& integrator : registry_.names("integrator"))
                    add({"lattice", "periodic", kernel, integrator, d, sides[d], h, 0.01}, "difference sum", "periodic", Json::object());
}

void LimitTable::list_viscosity() {
    const Json viscosity = {{"viscosity", {{"type", "monaghan"}, {"alpha", 0.06}, {"beta", 0.5}}}};
    for (int d = 1; d <= 2; ++d)
        for (const std::string& kernel : registry_.names("kernel"))
            for (const double h : widths) add({"viscosity", "Monaghan, alpha 0.06", kernel, "leapfrog", d, sides[d], h, 0.01}, "difference sum", "periodic", viscosity);
}

void LimitTable::list_disorder() {
    const auto displaced = [](double jitter) { return Json{{"particles", {{"jitter", jitter}}}}; };
    const auto damped = [&](double jitter, double alpha) {
        Json both = displaced(jitter);
        both["dissipation"] = {{"type", "fourth_order"}, {"alpha", alpha}};
        return both;
    };
    for (const char* integrator : {"leapfrog", "rk4"})
        for (const int side : {10, 18}) {    // all eigenvalues, and a Krylov space's
            const auto row = [&](const char* set) { return Row{"disorder", set, "cubic_spline", integrator, 2, side, 1.3, 0.05}; };
            add(row("jitter 0.2, plain pair"), "difference sum", "periodic", displaced(0.2));
            add(row("jitter 0.2, corrected and its adjoint"), "corrected corrected_adjoint", "periodic", displaced(0.2));
            add(row("jitter 0.2, corrected, dissipation 0.2"), "corrected corrected", "periodic", damped(0.2, 0.2));
            add(row("jitter 0.1, corrected, dissipation 0.5"), "corrected corrected", "periodic", damped(0.1, 0.5));
        }
}

void LimitTable::list_walls() {
    for (const char* face : {"rigid", "soft", "free", "soft_fdtd", "absorbing_mur"})
        for (int d = 1; d <= 2; ++d)
            for (const char* forms : {"difference sum", "corrected corrected"}) {
                const bool corrected = *forms == 'c', remembers = face == std::string("soft_fdtd") || face == std::string("absorbing_mur");
                if ((corrected && face == std::string("free")) || (remembers && (d > 1 || (corrected && *face == 's')))) continue;    // no step is stable there
                add({"walls", face + std::string(corrected ? ", corrected" : ", plain pair"), "cubic_spline", "leapfrog", d, d == 1 ? 40 : 16, 1.3, 0.05}, forms, face, Json::object());
            }
}

const LimitTable::Row& LimitTable::find(std::size_t i, const StabilityTrial::Report& report) {
    Row& row = rows_[i];
    Case scene = load_case(Json::parse(documents_[i]), "table", registry_);
    silence(scene);
    const StabilityFinding found = find_stability(scene, row.group == "walls" ? long_runs : brief, report);
    const auto courant = [&](double dt) { return courant_dx(scene, dt); };
    row.predicted = courant(found.predicted.dt), row.measured = courant(found.measured.dt);
    if (found.inviscid) row.inviscid = courant(*found.inviscid), row.always_on = courant(*found.always_on);
    return row;
}

std::vector<LimitTable::Worst> LimitTable::worst() const {
    std::vector<Worst> all;
    for (const Row& row : rows_) {
        if (!(row.predicted > 0)) continue;
        if (all.empty() || all.back().group != row.group) all.push_back({row.group, 0, 0, row.allowed});
        ++all.back().rows;
        all.back().deviation = std::max(all.back().deviation, std::abs(row.deviation()));
    }
    return all;
}

std::string LimitTable::csv() const {
    std::string text = "group,set,dimension,side,kernel,h_over_dx,integrator,predicted_courant_dx,measured_courant_dx,deviation_percent,allowed_percent,"
                       "inviscid_courant_dx,viscosity_always_on_courant_dx\n";
    for (const Row& r : rows_) {
        if (!(r.predicted > 0)) continue;
        char numbers[160];
        std::snprintf(numbers, sizeof numbers, "%.6g,%.6g,%.3g,%g", r.predicted, r.measured, 100 * r.deviation(), 100 * r.allowed);
        text += r.group + ",\"" + r.set + "\"," + std::to_string(r.dimension) + "," + std::to_string(r.side) + "," + r.kernel + "," + shown(r.h_over_dx) + "," + r.integrator + "," +
                numbers + "," + (r.inviscid ? shown(*r.inviscid, 6) : "") + "," + (r.always_on ? shown(*r.always_on, 6) : "") + "\n";
    }
    return text;
}

Json LimitTable::json() const {
    Json rows = Json::array();
    for (const Row& r : rows_)
        if (r.predicted > 0)
            rows.push_back({{"group", r.group}, {"set", r.set}, {"dimension", r.dimension}, {"side", r.side}, {"kernel", r.kernel}, {"h_over_dx", r.h_over_dx},
                            {"integrator", r.integrator}, {"predicted", {{"courant_dx", r.predicted}}}, {"measured", {{"courant_dx", r.measured}}}, {"holds", r.holds()}});
    return rows;
}

}    // namespace sphonic
