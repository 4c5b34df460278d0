#include "kernel_page.hpp"

#include <cmath>
#include <cstdio>

#include "html.hpp"

namespace sphonic::driver {
namespace {

std::string laws(const KernelCard& card) {
    std::vector<std::vector<std::string>> rows{{"law", "dimension", "holds", "by"}};
    for (const KernelLaw& law : card.laws) rows.push_back({law.what, std::to_string(law.dimension), law.holds ? "yes" : "no", shown(law.value)});
    for (const KernelTransform& t : card.transforms)
        rows.push_back({"has no negative transform (many neighbours do not clump)", std::to_string(t.dimension), t.least < 0 ? "no" : "yes", shown(t.least)});
    return html_table(rows);
}

std::string percent(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%+.3f %%", std::abs(x) < 1e-12 ? 0.0 : 100 * x);
    return text;
}

std::string waves(const std::vector<KernelRow>& all) {
    std::vector<std::vector<std::string>> rows{{"dimension", "h/dx", "neighbours", "speed error, plain", "cut-off [points]", "for 1 % [points]", "for 0.1 % [points]"}};
    for (const auto& [name, limit] : all.empty() ? std::map<std::string, double>{} : all.front().courant_dx) rows[0].push_back("c0 dt/dx, " + name);
    for (const KernelRow& r : all) {
        rows.push_back({std::to_string(r.dimension), shown(r.h_over_dx), std::to_string(r.neighbours), percent(r.speed_error), shown(r.cutoff_ppw), shown(r.ppw_1_percent), shown(r.ppw_01_percent)});
        for (const auto& [name, limit] : r.courant_dx) rows.back().push_back(shown(limit));
    }
    return html_table(rows);
}

std::string ranked(const Ranking& ranking) {
    std::vector<std::vector<std::string>> rows{{"kernel", "h/dx", "neighbours", "points for 1 %", "pairs per wavelength volume and period"}};
    for (const auto& [name, r] : ranking) rows.push_back({name, shown(r.h_over_dx), std::to_string(r.neighbours), shown(r.ppw_1_percent), shown(r.work())});
    return html_table(rows);
}

}    // namespace

std::string shown(const std::optional<double>& x) { return x ? shown(*x) : "none"; }

std::string kernel_page(const KernelCard& card, const Ranking& ranking, const std::filesystem::path& svg) {
    return html_page(card.name, "<h1>" + escaped(card.name) + "</h1>\n<p>" + escaped(card.doc) + ". Support " + shown(card.support) + " h.</p>\n" + inline_svg(svg) + "\n<h2>Laws</h2>\n" + laws(card) +
           "<h2>Sound on a lattice</h2>\n<p>Speed of long waves and largest stable c0 dt/dx by the plain pair of forms; cut-off and points per wavelength for a relative L2 "
           "error of 1 % and 0.1 % after ten wavelengths by corrected weights, time being exact, in the worse of axis and diagonal. The cut-off is the length on the set of the wave of highest frequency: no shorter one carries a signal.</p>\n" + waves(card.rows) +
           "<h2>Recommended h/dx</h2>\n<p>Of least work for 1 %, by leapfrog at its limit.</p>\n" + waves(card.recommended) +
           "<h2>Among the others in " + std::to_string(ranking.empty() ? 0 : ranking.front().second.dimension) + "-D</h2>\n" + ranked(ranking));
}

}    // namespace sphonic::driver
