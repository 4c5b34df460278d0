#include "layers.hpp"

#include <algorithm>
#include <cmath>

#include <sphonic/error.hpp>
#include <sphonic/shown.hpp>

#include "choices.hpp"
#include "spacings.hpp"

namespace sphonic {
namespace {

constexpr double margin = 6;          ///< what layers return at right angles stays below the target by [dB]
constexpr double probe_points = 4;    ///< per shortest wave, of runs that tell what they return
constexpr double finer_points = 8;    ///< the same, asked where that is too much: coarse steps throw back more

bool is_layer(const Json& boundary) { return boundary.value("type", "") == "absorbing_layer"; }
bool is_open(const OpenCase& open, const Json& layer) { return open.attenuation || !layer.contains("attenuation") || layer["attenuation"] == "auto"; }

std::string place_of(std::size_t i) { return "/boundaries/" + std::to_string(i) + "/attenuation"; }

/// A set-up, and what its layers return by it.
struct Probe {
    Choice choice;
    double dx, returned;

    std::string name() const { return choice.name() + " at dx = " + shown(dx) + " m"; }
};

std::optional<Probe> probe(const OpenCase& open, double shortest, double points, const std::vector<Choice>& from, Judge& judge) {
    const std::vector<double> all = spacings(open, shortest / points, 1e6);
    if (all.empty()) return {};
    for (const Choice& choice : from)
        if (const auto returned = judge.beyond_theory(choice.apply(open, all.front(), shortest))) return Probe{choice, all.front(), *returned};
    return {};
}

[[noreturn]] void too_loud(const OpenCase& open, const Probe& least, double target) {
    const Json& boundaries = open.document["boundaries"];
    const auto first = std::size_t(std::ranges::find_if(boundaries, is_layer) - boundaries.begin());
    throw Error(Fault::input, open.file + ": /boundaries/" + std::to_string(first), "what the layers return is " + shown(least.returned, 2) + " of the sound in the scene, by a run of " + least.name() + ", and the target " + shown(target),
                "Give them more thickness, move them further out, or choose a larger target");
}

}    // namespace

std::vector<std::size_t> fit_layers(OpenCase& open, const PlanRequest& request, Plan& plan) {
    std::vector<std::size_t> fitted;
    const double needed = std::ceil(-20 * std::log10(request.target) + margin);
    if (!open.document.contains("boundaries")) return fitted;
    for (std::size_t i = 0; i < open.document["boundaries"].size(); ++i) {
        Json& boundary = open.document["boundaries"][i];
        if (!is_layer(boundary)) continue;
        const bool given = boundary.contains("attenuation") && boundary["attenuation"] != "auto";
        const bool own = !is_open(open, boundary);
        if (!own) fitted.push_back(i);
        if (given && boundary["attenuation"] >= needed) continue;
        if (own) {
            plan.warnings.push_back(place_of(i) + ": " + boundary["attenuation"].dump() + " dB come back, a target of " + shown(request.target) + " needs " + shown(needed) + " dB");
            continue;
        }
        boundary["attenuation"] = needed;
        plan.decisions.push_back({place_of(i), needed, "what the layer returns must stay 6 dB below the target of " + shown(request.target), ""});
    }
    return fitted;
}

void weigh_layers(OpenCase& open, const std::vector<std::size_t>& fitted, double target, double shortest, Judge& judge, Plan& plan) {
    Json& boundaries = open.document["boundaries"];
    if (std::ranges::none_of(boundaries, is_layer)) return;
    const auto first = probe(open, shortest, probe_points, choices(open), judge);
    if (!first) return;
    double returned = first->returned, weakest = 0;
    const auto set = [&](double attenuation) {
        for (const std::size_t i : fitted) boundaries[i]["attenuation"] = attenuation;
    };
    const Json strong = boundaries;
    for (const double attenuation : fitted.empty() ? std::vector<double>{} : std::vector{20.0, 10.0, 3.0, 1.0}) {
        if (returned <= target / 2) break;
        set(attenuation);
        const auto less = judge.beyond_theory(first->choice.apply(open, first->dx, shortest));
        if (less && *less < returned) returned = *less, weakest = attenuation;
    }
    boundaries = strong;
    if (weakest > 0) set(weakest);
    Probe least{first->choice, first->dx, returned};
    if (returned > target / 2)
        if (const auto finer = probe(open, shortest, finer_points, {first->choice}, judge); finer && finer->returned < returned) least = *finer;
    if (least.returned > target) too_loud(open, least, target);
    const std::string by = least.name();
    judge.add_returned(least.returned, ", and what layers return by a run of " + by);
    if (weakest == 0) return;
    std::erase_if(plan.decisions, [](const Decision& d) { return d.what.ends_with("/attenuation"); });
    for (const std::size_t i : fitted)
        plan.decisions.push_back({place_of(i), weakest, "steeper damping throws back more at once: a run of " + first->name() + " errs by " + shown(first->returned, 2) + " at " +
                                                            strong[i]["attenuation"].dump() + " dB and by " + shown(returned, 2) + " so, before its wall is heard", ""});
}

}    // namespace sphonic
