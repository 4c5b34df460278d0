#include <algorithm>
#include <cstdio>
#include <iostream>

#include <sphonic/error.hpp>
#include <sphonic/log.hpp>
#include <sphonic/nearest.hpp>
#include <sphonic/result_folder.hpp>

#include "atlas_page.hpp"
#include "commands.hpp"
#include "interruption.hpp"

namespace sphonic::driver {
namespace {

std::string remedy(const std::string& name, const std::vector<std::string>& known) {
    if (const std::string near = nearest(name, known); !near.empty()) return "Did you mean \"" + near + "\"?";
    std::string list = "Known: ";
    for (const std::string& one : known) list += (&one == &known[0] ? "" : ", ") + one;
    return list;
}

std::vector<const AtlasRow*> chosen(const Atlas& atlas, const std::vector<std::string>& names) {
    std::vector<const AtlasRow*> rows;
    std::vector<std::string> known;
    for (const AtlasRow& row : atlas.rows) known.push_back(row.name);
    for (const std::string& name : names) {
        const auto row = std::ranges::find(atlas.rows, name, &AtlasRow::name);
        if (row == atlas.rows.end())
            throw Error(Fault::input, "--row", "there is no row \"" + name + "\" in " + atlas.file.string(), remedy(name, known));
        rows.push_back(&*row);
    }
    for (const AtlasRow& row : atlas.rows)
        if (names.empty()) rows.push_back(&row);
    return rows;
}

void print(const AtlasEntry& entry) {
    std::size_t width = 0;
    for (const auto* list : {&entry.result.failures, &entry.result.cures})
        for (const AtlasRun& run : *list) width = std::max(width, run.variant->name.size());
    std::printf("%s: %s\n", entry.row.name.c_str(), entry.row.title.c_str());
    for (const auto& [side, list] : {std::pair{"failure", &entry.result.failures}, std::pair{"cure", &entry.result.cures}})
        for (const AtlasRun& run : *list)
            std::printf("  %-8s %-*s  %s%s\n", side, int(width), run.variant->name.c_str(), run.outcome.c_str(), run.as_told ? "" : "  NOT AS TOLD");
}

}    // namespace

int atlas(const AtlasOptions& options) {
    const Interruptible interruptible;
    Registry registry(Registry::search_path(options.plugin_path));
    const Atlas atlas = load_atlas(options.folder);
    const auto rows = chosen(atlas, options.rows);
    ResultFolder folder(options.out.empty() ? ResultFolder::unused("atlas") : options.out, options.force);
    std::vector<AtlasEntry> entries;
    Json all = Json::array();
    for (const AtlasRow* row : rows) {
        entries.push_back({*row, run_row(atlas, *row, registry, [&] { interruptible.stop_if_asked(atlas.file.string(), "in row " + row->name + "; nothing was written"); })});
        const AtlasResult& result = entries.back().result;
        all.push_back(to_json(*row, result));
        const auto chart = atlas_chart(*row, result);
        if (chart && !draw(*chart, folder.path() / row->name)) log::warn("gnuplot is not installed: the charts are left as .gp scripts");
        if (!options.json) print(entries.back());
    }
    folder.write("summary.json", json_text(all));
    folder.write("atlas.html", atlas_page(atlas, entries, folder.path()));
    folder.commit();
    if (options.json)
        std::cout << json_text(all);
    else
        std::printf("the page is %s\n", (folder.target() / "atlas.html").string().c_str());
    const auto odd = std::ranges::find_if(entries, [](const AtlasEntry& entry) { return !entry.result.as_told(); });
    if (odd == entries.end()) return 0;
    log::error(atlas.file.string() + ": row " + odd->row.name + " did not come out as it is told");
    return int(Fault::diverged);
}

}    // namespace sphonic::driver
