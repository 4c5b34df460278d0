#include "atlas_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "html.hpp"

namespace sphonic::driver {
namespace {

std::string changes(const AtlasVariant& variant) {
    std::string text;
    for (const std::string& one : variant.overrides()) text += (text.empty() ? "" : " ") + std::string("--set '") + one + "'";
    return text;
}

/// "e^12.3" over the run.
std::string exponent(const AtlasRun& run) {
    if (!run.predicted) return "";
    char text[32];
    std::snprintf(text, sizeof text, "e^%.3g", std::abs(*run.predicted) < 1e-6 ? 0.0 : *run.predicted);
    return text;
}

std::string runs(const AtlasResult& result) {
    std::vector<std::vector<std::string>> rows{{"", "run", "changes of the case", "outcome", "growth by theory", "as told"}};
    for (const auto& [side, list] : {std::pair{"failure", &result.failures}, std::pair{"cure", &result.cures}})
        for (const AtlasRun& run : *list) rows.push_back({side, run.variant->name, changes(*run.variant), run.outcome, exponent(run), run.as_told ? "yes" : "NO"});
    return html_table(rows);
}

std::string entry_text(const AtlasEntry& entry, const std::filesystem::path& folder) {
    const AtlasRow& row = entry.row;
    return "<h2 id=\"" + row.name + "\">" + escaped(row.title) + "</h2>\n<p>" + escaped(row.failure) + "<br>\n" + escaped(row.cure) + "</p>\n" +
           inline_svg(folder / (row.name + ".svg")) + "\n<p><code>" + escaped(row.scene.string()) + "</code></p>\n" + runs(entry.result);
}

}    // namespace

std::string atlas_page(const Atlas& atlas, const std::vector<AtlasEntry>& entries, const std::filesystem::path& folder) {
    const auto told = std::ranges::count_if(entries, [](const AtlasEntry& entry) { return entry.result.as_told(); });
    std::string body = "<style>td,th{text-align:left}td:nth-child(3){font:12px monospace;word-break:break-all}</style>\n<h1>" + escaped(atlas.title) + "</h1>\n<p>" +
                       std::to_string(told) + " of " + std::to_string(entries.size()) + " failures fail, and are cured, as they are told here.</p>\n<ul>\n";
    for (const AtlasEntry& entry : entries) body += "<li><a href=\"#" + entry.row.name + "\">" + escaped(entry.row.title) + "</a></li>\n";
    body += "</ul>\n";
    for (const AtlasEntry& entry : entries) body += entry_text(entry, folder);
    return html_page(atlas.title, body);
}

}    // namespace sphonic::driver
