#include <sphonic/media_map.hpp>

#include <algorithm>

namespace sphonic {

void MediaMap::add(const abi::Medium& medium, Region region) {
    media_.push_back(medium);
    regions_.push_back(std::move(region));
}

const abi::Medium& MediaMap::fastest() const {
    return *std::max_element(media_.begin(), media_.end(), [](const auto& a, const auto& b) { return a.c0 < b.c0; });
}

void MediaMap::find(const abi::Points& points, int* number) const {
    double x[3] = {0, 0, 0};
    for (int i = 0; i < points.n; ++i) {
        for (int a = 0; a < points.dimension; ++a) x[a] = points.x[a][i];
        number[i] = 0;
        for (std::size_t m = 0; m < regions_.size(); ++m)
            if (regions_[m].contains(x)) number[i] = int(m) + 1;
    }
}

abi::Media MediaMap::view() const {
    const auto find = [](const void* host, const abi::Points& points, int* number) { static_cast<const MediaMap*>(host)->find(points, number); };
    return {media_.data(), int(media_.size()), find, this};
}

}    // namespace sphonic
