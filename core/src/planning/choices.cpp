#include "choices.hpp"

#include <algorithm>
#include <cmath>

#include <sphonic/shown.hpp>

#include "spacings.hpp"

namespace sphonic {
namespace {

Json step(const std::string& key, double value) { return {{"type", "leapfrog"}, {key, value}}; }

/// The case's integrator with a step where only that is open.
std::vector<Json> integrators(const OpenCase& open, const std::vector<Json>& steps) {
    if (!open.step) return {Json()};
    std::vector<Json> list = steps;
    if (!open.integrator)
        for (Json& one : list) {
            const Json given = open.document["integrator"];
            one.update(given);
        }
    return list;
}

std::vector<Json> kernels(const OpenCase& open, bool corrected) {
    if (!open.kernel) return {Json()};
    const auto kernel = [](const char* type, double h) { return Json{{"type", type}, {"h_over_dx", h}}; };
    std::vector<Json> list{kernel("cubic_spline", 1), kernel("super_gaussian", 1.3)};
    if (corrected && open.dimension() > 1) list.push_back(kernel("wendland_c4", 1.6));
    return list;
}

void add_grids(const OpenCase& open, std::vector<Choice>& list) {
    const double diagonal = std::sqrt(double(open.dimension()));
    const auto courants = [&](std::initializer_list<double> shares) {
        std::vector<Json> steps;
        for (const double share : shares) steps.push_back(step("courant", share / diagonal));
        return integrators(open, steps);
    };
    const bool bodies = open.document.contains("obstacles");    // whose staircase outweighs the errors in time
    for (const Json& one : courants({1, 0.7, 0.4}))
        if (!bodies) list.push_back({.family = "kspace", .method = {{"type", "kspace"}}, .equations = {}, .kernel = {}, .integrator = one});
    for (const Json& one : bodies ? courants({1}) : courants({1, 0.7, 0.4})) list.push_back({.family = "fdtd 2", .method = {{"type", "fdtd"}, {"order", 2}}, .equations = {}, .kernel = {}, .integrator = one});
    for (const Json& one : bodies ? courants({0.85}) : courants({0.85, 0.5, 0.25})) list.push_back({.family = "fdtd 4", .method = {{"type", "fdtd"}, {"order", 4}}, .equations = {}, .kernel = {}, .integrator = one});
}

void add_fitted(const OpenCase& open, std::vector<Choice>& list) {
    const std::vector<Json> steps = off_sites(open) ? std::vector{step("courant", 0.55), step("safety", 0.95)} : std::vector{step("courant", 0.4), step("courant", 0.7), step("safety", 0.95)};
    const Json kernel = open.kernel ? Json{{"type", "cubic_spline"}, {"h_over_dx", 1}} : Json();
    const bool cloud = off_sites(open), space = open.dimension() == 3;
    const std::vector<double> lattice_supports = space ? std::vector{2.0, 3.0} : std::vector{2.0, 3.0, 4.0};    // in space a ball of 4 dx has more weights than the fit bears
    const std::vector<double> cloud_supports = open.dimension() == 1 ? std::vector{4.0, 6.0} : space ? std::vector{2.6, 3.3} : std::vector{2.6, 3.3, 4.0};
    const std::vector<double> fits = cloud ? std::vector{0.9, 1.15, 1.45} : space ? std::vector{0.9, 1.3} : std::vector{0.9, 1.1, 1.3};
    for (const double support : cloud ? cloud_supports : lattice_supports)
        for (const double finer : fits)
            for (const Json& one : integrators(open, steps))
                list.push_back({.family = "band_fitted", .method = open.method ? Json{{"type", "particles"}} : Json(), .equations = {}, .kernel = kernel, .integrator = one, .support = support, .finer = finer});
}

void add_kernels(const OpenCase& open, std::vector<Choice>& list) {
    std::vector<std::string> presets{"corrected_acoustics", "linear_acoustics"};
    if (displaced(open)) presets = {"corrected_acoustics"};    // sums without correction do not converge on such sets
    if (several_media(open)) presets = {"acoustics"};
    if (!open.equations) presets = {""};
    std::vector<Json> steps{step("safety", 0.95)};
    if (!displaced(open)) steps.push_back(step("safety", 0.5));    // elsewhere the error in space outweighs the one in time
    for (const std::string& preset : presets)
        for (const Json& kernel : kernels(open, preset == "corrected_acoustics"))
            for (const Json& one : integrators(open, steps))
                list.push_back({.family = preset.empty() ? "the case's own equations" : preset, .method = open.method ? Json{{"type", "particles"}} : Json(),
                                .equations = preset.empty() ? Json() : Json(preset), .kernel = kernel, .integrator = one});
}

/// Terms with a form of its own parameters.
Json fitted_equations(double points, double support, bool cloud) {
    const Json form{{"type", "band_fitted"}, {"points_per_wavelength", points}, {cloud ? "cloud_support" : "support", support}};
    const auto term = [&](const char* op, const char* of, const char* times) { return Json::array({Json{{op, of}, {"form", form}, {"times", times}}}); };
    return {{"p", term("divergence", "u", "-rho0*c0^2")}, {"u", term("gradient", "p", "-1/rho0")}};
}

}    // namespace

Json Choice::apply(const OpenCase& open, double dx, double shortest) const {
    Json document = open.document;
    if (open.spacing) document["particles"]["dx"] = dx;
    if (own_spacings) {
        document["particles"]["dx"] = spread(open, dx, document);
        shortest *= speed(document["medium"][0]) / speed(std::ranges::min(document["medium"], {}, speed));    // all media are like the first
    }
    if (!method.is_null()) document["method"] = method;
    const bool grid = !method.is_null() && method["type"] != "particles";
    if (!integrator.is_null()) document["integrator"] = integrator;
    if (single) document["precision"] = "single";
    if (grid) {
        for (const char* key : {"kernel", "kernels", "equations", "viscosity", "dissipation"}) document.erase(key);
        return document;
    }
    if (!kernel.is_null()) document["kernel"] = kernel;
    if (!equations.is_null()) document["equations"] = equations;
    const double points = std::clamp(std::round(10 * finer * shortest / document["particles"]["dx"].get<double>()) / 10, 3.0, 100.0);
    if (support > 0) document["equations"] = fitted_equations(points, support, off_sites(open));
    if (open.equations && displaced(open) && support == 0 && !document.contains("obstacles") && !document.contains("dissipation")) document["dissipation"] = {{"type", "fourth_order"}};
    return document;
}

std::string Choice::name() const {
    std::string text = family;
    if (support > 0) text += ", support " + shown(support) + " dx";
    if (!kernel.is_null() && support == 0) text += ", " + kernel["type"].get<std::string>() + " h = " + shown(kernel["h_over_dx"].get<double>()) + " dx";
    for (const char* key : {"courant", "safety"})
        if (!integrator.is_null() && integrator.contains(key)) text += std::string(", ") + key + " " + shown(integrator[key].get<double>());
    if (own_spacings) text += ", dx per medium";
    return single ? text + ", single precision" : text;
}

namespace {

std::vector<Choice> of_one_spacing(const OpenCase& open) {
    std::vector<Choice> list;
    if (open.method && !off_sites(open)) add_grids(open, list);
    const bool grid = !open.method && open.document.contains("method") && open.document["method"].value("type", "particles") != "particles";
    if (grid) {
        for (const Json& one : integrators(open, {step("safety", 0.98), step("safety", 0.7), step("safety", 0.4)}))
            list.push_back({.family = open.document["method"]["type"], .method = {}, .equations = {}, .kernel = {}, .integrator = one});
        return list;
    }
    if (open.equations) add_fitted(open, list);
    add_kernels(open, list);
    return list;
}

}    // namespace

std::vector<Choice> choices(const OpenCase& open) {
    std::vector<Choice> list = of_one_spacing(open);
    if (!open.own_spacings || open.strata.size() < 2 || off_sites(open)) return list;
    const std::size_t n = list.size();
    for (std::size_t i = 0; i < n; ++i) {
        Choice own = list[i];
        own.own_spacings = true;
        if (own.family == "fdtd 2" && own.integrator.is_object() && own.integrator.value("courant", 0.0) == 1) own.integrator = integrators(open, {step("safety", 1)}).front();    // as long: spacings that fit differ a little from the speeds' proportion
        list.push_back(std::move(own));
    }
    return list;
}

}    // namespace sphonic
