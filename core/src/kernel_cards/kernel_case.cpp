#include "kernel_case.hpp"

#include <sphonic/json.hpp>

namespace sphonic {

Case kernel_case(Registry& registry, const std::string& kernel, int dimension, double h_over_dx, Pairing forms, const std::string& integrator) {
    const bool plain = forms == Pairing::plain;
    const auto edges = [dimension](double x) { return Json(std::vector<double>(std::size_t(dimension), x)); };
    const auto term = [](const char* op, const char* of, const char* form, const char* times) {
        return Json::array({Json{{op, of}, {"form", form}, {"times", times}}});
    };
    Json text = {{"dimension", dimension},
                 {"medium", {{"c0", 1}, {"rho0", 1}}},
                 {"particles", {{"type", "lattice"}, {"dx", 1}, {"lower", edges(0)}, {"upper", edges(100)}}},
                 {"kernel", {{"type", kernel}, {"h_over_dx", h_over_dx}}},
                 {"equations", {{"p", term("divergence", "u", plain ? "difference" : "corrected", "-rho0*c0^2")},
                                {"u", term("gradient", "p", plain ? "sum" : "corrected", "-1/rho0")}}},
                 {"boundaries", Json::array({Json{{"type", "periodic"}, {"face", "all"}}})},
                 {"integrator", {{"type", integrator}, {"dt", 1e-6}, {"unstable", "allow"}}},
                 {"until", 1}};
    return load_case(std::move(text), "kernel " + kernel, registry);
}

}    // namespace sphonic
