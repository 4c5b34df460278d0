#pragma once
#include <memory>
#include <vector>

#include <sphonic/expression.hpp>
#include <sphonic/plugin/abi/media.hpp>
#include <sphonic/stretch.hpp>

namespace sphonic {

/// The media of a case: number 0 fills the box, the others regions of it, a later one over an earlier.
class MediaMap {
public:
    explicit MediaMap(const abi::Medium& whole) : media_{whole} {}
    /// The same in the coordinate of a stretch, as sets see them.
    MediaMap(std::shared_ptr<const MediaMap> plain, std::shared_ptr<const Stretch> stretch);
    void add(const abi::Medium& medium, Region region);
    /// By number [m], where media have spacings of their own.
    void space(std::vector<double> spacing) { spacing_ = std::move(spacing); }

    bool several() const { return media_.size() > 1; }
    const std::vector<abi::Medium>& list() const { return media_; }
    /// As they are, whatever the coordinate.
    const std::vector<abi::Medium>& materials() const { return plain_ ? plain_->media_ : media_; }
    /// The medium whose sound is fastest.
    const abi::Medium& fastest() const;
    /// Writes each point's number. Not for two threads at once.
    void find(const abi::Points& points, int* number) const;
    /// The same for plugins; valid as long as the map.
    abi::Media view() const;

private:
    std::vector<abi::Medium> media_;
    std::vector<Region> regions_;    ///< of media 1 ...
    std::vector<double> spacing_;
    std::shared_ptr<const MediaMap> plain_;
    std::shared_ptr<const Stretch> stretch_;
};

}    // namespace sphonic
