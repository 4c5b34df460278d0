#pragma once
#include <vector>

#include <sphonic/expression.hpp>
#include <sphonic/plugin/abi/media.hpp>

namespace sphonic {

/// The media of a case: number 0 fills the box, the others regions of it, a later one over an earlier.
class MediaMap {
public:
    explicit MediaMap(const abi::Medium& whole) : media_{whole} {}
    void add(const abi::Medium& medium, Region region);

    bool several() const { return media_.size() > 1; }
    const std::vector<abi::Medium>& list() const { return media_; }
    /// The medium whose sound is fastest.
    const abi::Medium& fastest() const;
    /// Writes each point's number. Not for two threads at once.
    void find(const abi::Points& points, int* number) const;
    /// The same for plugins; valid as long as the map.
    abi::Media view() const;

private:
    std::vector<abi::Medium> media_;
    std::vector<Region> regions_;    ///< of media 1 ...
};

}    // namespace sphonic
