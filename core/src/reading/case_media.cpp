#include <algorithm>

#include <sphonic/parameters.hpp>

#include "case_reader.hpp"

namespace sphonic {
namespace {

abi::Medium read_medium(Section& section) {
    abi::Medium medium;
    medium.c0 = section.real(common_key("medium", "c0"));
    medium.rho0 = section.real(common_key("medium", "rho0"));
    return medium;
}

/// Where media have spacings of their own, the coordinate in which they are even.
void read_stretch(Case& scene, MediaMap& media, const Section& root, const std::vector<double>& spacing) {
    if (std::ranges::all_of(spacing, [&](double dx) { return dx == scene.box.dx; })) return;
    const auto refuse = [&](const std::string& what, const std::string& remedy) { root.fail("medium", "a medium has a dx of its own, and " + what, remedy); };
    if (scene.box.dimension > 1) refuse("the box has more than one dimension", "Leave it out: one spacing serves all media");
    if (!scene.arrangement->regular()) refuse("these particles do not lie on a lattice", "Use the arrangement \"lattice\"");
    if (scene.motion == Motion::lagrangian) refuse("the particles move", "Use frozen particles");
    constexpr double most_looks = 1e7;    // for media along the axis
    const double looks = (scene.box.upper[0] - scene.box.lower[0]) / std::ranges::min(spacing);
    if (!(looks > 0 && looks <= most_looks)) refuse("the box is " + number_text(looks) + " of the smallest long", "Choose a larger dx, and upper above lower");
    media.space(spacing);
    scene.stretch = std::make_shared<Stretch>(scene.box, media.view());
}

}    // namespace

void read_media(Case& scene, Section& root) {
    const std::string remedy = "Give { \"c0\": sound speed [m/s], \"rho0\": density [kg/m^3] }";
    const Json& given = root.need("medium", remedy);
    if (!given.is_array()) {
        Section section = root.child("medium", remedy);
        scene.medium = read_medium(section);
        section.finish();
        root.resolved["medium"] = section.resolved;
        scene.media = std::make_shared<MediaMap>(scene.medium);
        return;
    }
    if (given.empty()) root.fail("medium", "the list is empty", remedy);
    Json resolved = Json::array();
    std::shared_ptr<MediaMap> media;
    std::vector<double> spacing;
    for (std::size_t i = 0; i < given.size(); ++i) {
        Section section(given[i], root.file(), "/medium/" + std::to_string(i));
        const abi::Medium medium = read_medium(section);
        if (i == 0) {
            scene.medium = medium;
            media = std::make_shared<MediaMap>(medium);
            if (section.value().contains("dx")) section.fail("dx", "the first medium's spacing is that of the particles", "Give it as dx of \"particles\"");
            spacing.push_back(scene.box.dx);
        } else {
            const std::string text = section.read(common_key("medium", "region")).text;
            if (text.empty()) section.fail("region", "is missing", "Give a condition on x, y, z, r: the first medium fills the box, the others their regions");
            media->add(medium, Region(text, constants(scene), scene.box.dimension, section.place("region")));
            spacing.push_back(section.optional_real(common_key("medium", "dx")).value_or(scene.box.dx));
        }
        section.finish();
        resolved.push_back(section.resolved);
    }
    root.resolved["medium"] = resolved;
    scene.media = media;
    read_stretch(scene, *media, root, spacing);
}

}    // namespace sphonic
