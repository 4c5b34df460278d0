#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <sphonic/plugin/abi/arrangement.hpp>

#include "parallel.hpp"
#include "store.hpp"

namespace sphonic {

/// Boxes of a lattice's particles, of which some are stepped while the others stand still. All are, to begin with.
class LatticeTiles {
public:
    /// Consecutive particles of a row.
    struct Stretch {
        long row, begin, n;       ///< of the layout; the first in it
        std::ptrdiff_t offset;    ///< of the first in a field
    };
    /// Sites first ... last - 1 along each axis.
    struct Sites {
        std::array<long, 3> first, last;
    };

    LatticeTiles(const abi::Box& box, const Layout& layout);

    long count() const { return along_[0] * along_[1] * along_[2]; }
    /// The tile of a place in a field.
    long of(std::ptrdiff_t place) const;
    Sites sites(long tile) const;
    long particles(long tile) const;
    /// Of a site in a field.
    std::ptrdiff_t place(long i, long j, long k) const { return layout_.at(i, j, k); }
    /// Calls visit(tile) for all with a site at most `reach` spacings, along each axis, from one of these; for some twice.
    template <class Visit>
    void near(const Sites& sites, long reach, Visit visit) const;

    /// From now on, tiles where `stepped` is 0 stand still.
    void step_only(const std::vector<char>& stepped);
    bool all() const { return stepped_ == layout_.particles(); }
    /// Particles that are stepped.
    long stepped() const { return stepped_; }
    std::span<const Stretch> stretches() const { return stretches_; }
    /// True if one is stepped that is less than `depth` spacings from a face.
    bool reaches(int axis, bool upper, long depth) const;

    /// As many of these threads as what is stepped is worth.
    int shares(int threads) const { return int(std::clamp(stepped_ / block_length, 1L, long(threads))); }
    /// Calls visit(stretch) for all that is stepped.
    template <class Visit>
    void for_stretches(int threads, Visit visit) const {
        in_parallel(shares(threads), long(stretches_.size()), [&](long i) { visit(stretches_[std::size_t(i)]); });
    }
    /// Calls part(first, last) for the entries of an ascending list of n places, place(i) in a field, that are stepped.
    template <class Place, class Part>
    void for_entries(int threads, long n, Place place, Part part) const;

private:
    Layout layout_;
    bool periodic_[3];
    long length_[3], along_[3];    ///< sites per tile, tiles
    std::vector<Stretch> stretches_;
    long stepped_ = 0;
    Sites extent_{};    ///< of what is stepped

    std::array<long, 3> index(long tile) const { return {tile % along_[0], tile / along_[0] % along_[1], tile / (along_[0] * along_[1])}; }
    template <class Visit>
    void along(int axis, long first, long last, Visit visit) const;
    void add_stretches(long j, long k, long begin, long end);
};

/// Those along an axis with a site in [first, last), which may lie beyond the ends: there are images, or nothing.
template <class Visit>
void LatticeTiles::along(int axis, long first, long last, Visit visit) const {
    const long n = layout_.count[axis];
    for (const long image : {0L, n, -n}) {
        const long from = std::max(first + image, 0L), to = std::min(last + image, n);
        for (long t = from / length_[axis]; from < to && t <= (to - 1) / length_[axis]; ++t) visit(t);
        if (!periodic_[axis]) break;
    }
}

template <class Visit>
void LatticeTiles::near(const Sites& s, long reach, Visit visit) const {
    along(2, s.first[2] - reach, s.last[2] + reach, [&](long k) {
        along(1, s.first[1] - reach, s.last[1] + reach, [&](long j) {
            along(0, s.first[0] - reach, s.last[0] + reach, [&](long i) { visit(i + along_[0] * (j + along_[1] * k)); });
        });
    });
}

template <class Place, class Part>
void LatticeTiles::for_entries(int threads, long n, Place place, Part part) const {
    if (all()) return in_blocks(threads, n, part);
    const auto first_from = [&](std::ptrdiff_t at) {
        long low = 0, high = n;
        while (low < high) {
            const long middle = (low + high) / 2;
            (place(middle) < at ? low : high) = place(middle) < at ? middle + 1 : middle;
        }
        return low;
    };
    in_parallel(shares(threads), n > 0 ? long(stretches_.size()) : 0, [&](long i) {
        const Stretch& s = stretches_[std::size_t(i)];
        const long first = first_from(s.offset), last = first_from(s.offset + s.n);
        if (first < last) part(first, last);
    });
}

}    // namespace sphonic
