#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <sphonic/atlas.hpp>

namespace sphonic::driver {

/// A row with what came of it.
struct AtlasEntry {
    const AtlasRow& row;
    AtlasResult result;
};

/// The atlas as one HTML file without links outside; the rows' drawings stand as NAME.svg in `folder`.
std::string atlas_page(const Atlas& atlas, const std::vector<AtlasEntry>& entries, const std::filesystem::path& folder);

}    // namespace sphonic::driver
