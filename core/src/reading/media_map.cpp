#include <sphonic/media_map.hpp>

#include <algorithm>

namespace sphonic {

MediaMap::MediaMap(std::shared_ptr<const MediaMap> plain, std::shared_ptr<const Stretch> stretch) : media_(plain->media_), plain_(std::move(plain)), stretch_(std::move(stretch)) {
    for (std::size_t m = 0; m < media_.size(); ++m) media_[m] = Stretch::seen(media_[m], stretch_->factors()[m]);
}

void MediaMap::add(const abi::Medium& medium, Region region) {
    media_.push_back(medium);
    regions_.push_back(std::move(region));
}

const abi::Medium& MediaMap::fastest() const {
    return *std::max_element(media_.begin(), media_.end(), [](const auto& a, const auto& b) { return a.c0 < b.c0; });
}

void MediaMap::find(const abi::Points& points, int* number) const {
    if (plain_) {
        std::vector<double> x(points.x[0], points.x[0] + points.n);
        for (double& s : x) s = stretch_->place(s);
        return plain_->find({.dimension = 1, .n = points.n, .x = {x.data()}}, number);
    }
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
    return {.medium = media_.data(), .count = int(media_.size()), .find = find, .host = this, .spacing = spacing_.empty() ? nullptr : spacing_.data()};
}

}    // namespace sphonic
