#include <sphonic/run_report.hpp>

#include <cstdio>

#include <sphonic/json.hpp>
#include <sphonic/log.hpp>

namespace sphonic {
namespace {

void append(std::string& text, double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.17g", value);
    text += digits;
}

std::string probes_csv(const ProbeRecord& probes) {
    std::string text = "t";
    for (std::size_t k = 0; k < probes.p.size(); ++k) {
        std::string at;
        for (const double x : probes.read_at[k]) at += (at.empty() ? "" : " ") + Json(x).dump();
        text += ",p(" + at + ")";
        if (!probes.exact[k].empty()) text += ",exact(" + at + ")";
    }
    text += "\n";
    for (std::size_t i = 0; i < probes.t.size(); ++i) {
        append(text, probes.t[i]);
        for (std::size_t k = 0; k < probes.p.size(); ++k) {
            append(text += ",", probes.p[k][i]);
            if (!probes.exact[k].empty()) append(text += ",", probes.exact[k][i]);
        }
        text += "\n";
    }
    return text;
}

std::string profile_csv(const Profile& profile, int dimension) {
    const char* names[3] = {"x", "y", "z"};
    std::string text;
    for (int a = 0; a < dimension; ++a) text += std::string(names[a]) + ",";
    text += profile.exact.empty() ? "p\n" : "p,exact,in_region\n";
    for (std::size_t i = 0; i < profile.p.size(); ++i) {
        for (int a = 0; a < dimension; ++a) {
            append(text, profile.x[a][i]);
            text += ",";
        }
        append(text, profile.p[i]);
        if (!profile.exact.empty()) {
            append(text += ",", profile.exact[i]);
            text += profile.in_region[i] ? ",1" : ",0";
        }
        text += "\n";
    }
    return text;
}

}    // namespace

void write_results(const Case& scene, Simulation& simulation, const ResultFolder& folder) {
    const Summary& summary = simulation.summary();
    const Profile profile = summary.diverged ? simulation.last_good() : simulation.profile();
    folder.write("resolved.json", json_text(*scene.resolved));
    folder.write("summary.json", json_text(to_json(summary)));
    const bool fields = scene.output.fields;
    if (fields) folder.write("profile.csv", profile_csv(profile, scene.box.dimension));
    bool drawn = !fields || draw(pressure_chart(scene, summary, profile), folder.path() / "pressure");
    if (fields && scene.box.dimension > 1) drawn = draw(field_chart(scene, summary, profile), folder.path() / "field") && drawn;
    if (!simulation.probes().p.empty()) {
        folder.write("probes.csv", probes_csv(simulation.probes()));
        drawn = draw(probe_chart(scene, simulation.probes()), folder.path() / "probes") && drawn;
    }
    if (!drawn) log::warn("gnuplot is not installed: the charts are left as .gp scripts");
}

}    // namespace sphonic
