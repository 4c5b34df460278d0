#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sphonic/chart.hpp>
#include <sphonic/json.hpp>
#include <sphonic/registry.hpp>
#include <sphonic/simulation.hpp>

namespace sphonic {

/// How a failure shows, and how a cure does:
///   diverges  the run is stopped; cured, its pressure is no louder in its second half than in its first, within a half;
///   errs      the relative L2 error is `bad` or more; cured, `good` or less;
///   clumps    the nearest neighbours are on average `bad` dx apart or less; cured, `good` or more;
///   refused   no run is made of it; cured, it runs to its end and no louder;
///   warned    a warning contains `says`; cured, none does.
enum class Failing { diverges, errs, clumps, refused, warned };

/// A row's case with these changes, as JSON pointers and values.
struct AtlasVariant {
    std::string name;
    std::vector<std::pair<std::string, Json>> set;

    /// What `--set` takes: "/pointer=value".
    std::vector<std::string> overrides() const;
};

/// A failure of a method and what cures it.
struct AtlasRow {
    enum class Picture { growth, profile, places };

    std::string name, title, failure, cure;    ///< the last two are sentences
    std::filesystem::path scene;
    Failing fails = Failing::diverges;
    double bad = 0, good = 0;
    std::string says;
    Picture picture = Picture::growth;
    std::vector<AtlasVariant> failures, cures;    ///< each of them at least one
};

struct Atlas {
    std::filesystem::path file;
    std::string title;
    std::vector<AtlasRow> rows;
};

/// Reads FOLDER/studies/atlas.json.
Atlas load_atlas(const std::filesystem::path& folder);

/// One run of a row, as it came out.
struct AtlasRun {
    const AtlasVariant* variant = nullptr;
    bool as_told = false;       ///< a failure failed, a cure cured
    std::string outcome;        ///< in words, with its figure
    /// Of a row that diverges: the exponent by which the worst motion grows over the run, by theory.
    std::optional<double> predicted;
    std::vector<double> t, loudness;    ///< [s]; RMS of the set's pressure [Pa]
    Profile last;               ///< the end, or the last state while all was well
    double dx = 0;
};

struct AtlasResult {
    std::vector<AtlasRun> failures, cures;

    bool as_told() const;
};

/// Runs all failures and cures of a row. `progress` is called some ten times a second, and may throw.
AtlasResult run_row(const Atlas& atlas, const AtlasRow& row, Registry& registry, const std::function<void()>& progress = {});

/// Failures on the left, cures on the right, on the same axes but for warnings; nothing where nothing ran.
std::optional<Chart> atlas_chart(const AtlasRow& row, const AtlasResult& result);

Json to_json(const AtlasRow& row, const AtlasResult& result);

}    // namespace sphonic
