#include <algorithm>

#include <sphonic/atlas.hpp>
#include <sphonic/error.hpp>

#include "study_reader.hpp"

namespace fs = std::filesystem;

namespace sphonic {
namespace {

const std::vector<std::string> ways{"diverges", "errs", "clumps", "refused", "warned"};    // in the order of Failing
const std::vector<std::string> pictures{"growth", "profile", "places"};                     // of AtlasRow::Picture

template <class Choice>
Choice read_choice(Section& section, const std::string& key, const std::vector<std::string>& names) {
    return Choice(std::ranges::find(names, section.choice(key, names[0], names)) - names.begin());
}

AtlasVariant read_variant(Section section) {
    AtlasVariant variant{.name = need_text(section, "name", "Name the run"), .set = {}};
    if (const Json* set = section.find("set")) {
        if (!set->is_object()) section.fail("set", shown(*set) + " is not an object", "Write { \"/pointer\": value }");
        for (const auto& [pointer, value] : set->items()) variant.set.emplace_back(pointer, value);
    }
    section.finish();
    return variant;
}

std::vector<AtlasVariant> read_variants(Section& section, const std::string& key) {
    const Json& list = need_list(section, key, "Give a list of { \"name\": ..., \"set\": { \"/pointer\": value } }");
    std::vector<AtlasVariant> variants;
    for (std::size_t i = 0; i < list.size(); ++i)
        variants.push_back(read_variant({list[i], section.file(), section.pointer() + "/" + key + "/" + std::to_string(i)}));
    return variants;
}

double read_bound(Section& section, const std::string& key) {
    return finite_number(section.need(key, "Give the bound that a run is judged by"), section.place(key));
}

AtlasRow read_row(Section section, const fs::path& file) {
    AtlasRow row;
    row.name = need_text(section, "name", "Name the row: its files have this name");
    row.title = need_text(section, "title", "Say what fails");
    row.failure = need_text(section, "failure", "Say in a sentence what fails and why");
    row.cure = need_text(section, "cure", "Say in a sentence what cures it");
    row.scene = (file.parent_path() / need_text(section, "case", "Give the case's file")).lexically_normal();
    row.fails = read_choice<Failing>(section, "fails", ways);
    if (row.fails == Failing::errs || row.fails == Failing::clumps) row.bad = read_bound(section, "bad"), row.good = read_bound(section, "good");
    if (row.fails == Failing::warned) row.says = need_text(section, "says", "Give words of the warning");
    row.picture = read_choice<AtlasRow::Picture>(section, "picture", pictures);
    row.failures = read_variants(section, "failures");
    row.cures = read_variants(section, "cures");
    section.finish();
    return row;
}

}    // namespace

std::vector<std::string> AtlasVariant::overrides() const {
    std::vector<std::string> list;
    for (const auto& [pointer, value] : set) list.push_back(pointer + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
    return list;
}

Atlas load_atlas(const fs::path& folder) {
    Atlas atlas{.file = folder / "studies" / "atlas.json", .title = {}, .rows = {}};
    const Json document = read_json(atlas.file);
    Section root(document, atlas.file.string(), "");
    atlas.title = need_text(root, "title", "Give the atlas a title");
    const Json& rows = need_list(root, "rows", "Give a list of failures");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        AtlasRow row = read_row({rows[i], root.file(), "/rows/" + std::to_string(i)}, atlas.file);
        if (std::ranges::find(atlas.rows, row.name, &AtlasRow::name) != atlas.rows.end())
            throw Error(Fault::input, root.file() + ": /rows/" + std::to_string(i) + "/name", "\"" + row.name + "\" is given twice", "Name each row differently");
        atlas.rows.push_back(std::move(row));
    }
    root.finish();
    return atlas;
}

}    // namespace sphonic
