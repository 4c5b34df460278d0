#pragma once
#include <cstdint>
#include <vector>

#include "interleaved.hpp"
#include "neighbour_list.hpp"

namespace sphonic {

/// The pairs of a neighbour list that are within its bare radius at the present positions, tile by tile: all that evaluates pairs before
/// particles move again takes them from here.
class NearPairs {
public:
    /// Of a list that outlives it.
    explicit NearPairs(const NeighbourList& list) : list_(list) {}

    /// The list was built anew: cuts its rows into tiles of about so many pairs.
    void cut(long pairs_per_tile);
    /// All pairs of the list, or only those near at positions `x` of `n` own and virtual particles.
    void take_all();
    void narrow(const double* const* x, long n, int threads);

    long tiles() const { return long(cuts_.size()) - 1; }
    long begin(long tile) const { return cuts_[std::size_t(tile)]; }    ///< row; that of the tile past the last is the end
    /// First pair of each of a tile's rows, counted in the tile, and the end.
    const std::int32_t* first(long tile) const { return first_.data() + begin(tile) + tile; }
    /// The other particles of a tile's pairs; there are `overrun` more.
    const std::int32_t* neighbours(long tile) const { return j_ + base(tile); }
    /// The tile's first pair in the list.
    std::int64_t base(long tile) const { return list_.start()[std::size_t(begin(tile))]; }

private:
    const NeighbourList& list_;
    std::vector<long> cuts_;
    std::vector<std::int32_t> first_;
    const std::int32_t* j_ = nullptr;    ///< a tile begins where it does in the list
    std::vector<std::int32_t> near_;
    Interleaved places_;

    template <int D>
    void narrow_tile(const double* const* x, long tile);
};

}    // namespace sphonic
