#include "lattice_tiles.hpp"

namespace sphonic {
namespace {

/// Sites per tile along x and across it, by dimension: whole vectors, and as little as pays beyond a front.
constexpr long along_rows[4] = {0, 32, 16, 16}, across_rows = 4;

}    // namespace

LatticeTiles::LatticeTiles(const abi::Box& box, const Layout& layout) : layout_(layout) {
    for (int a = 0; a < 3; ++a) {
        periodic_[a] = a < box.dimension && box.periodic[a];
        length_[a] = a == 0 ? along_rows[layout.dimension] : across_rows;
        along_[a] = (layout.count[a] + length_[a] - 1) / length_[a];
    }
    step_only(std::vector<char>(std::size_t(count()), 1));
}

long LatticeTiles::of(std::ptrdiff_t place) const {
    long rest = place - layout_.origin, site[3] = {0, 0, 0};
    for (int a = 2; a >= 0; --a) {
        if (a >= layout_.dimension) continue;
        site[a] = rest / layout_.stride[a];
        rest %= layout_.stride[a];
    }
    return site[0] / length_[0] + along_[0] * (site[1] / length_[1] + along_[1] * (site[2] / length_[2]));
}

LatticeTiles::Sites LatticeTiles::sites(long tile) const {
    const auto at = index(tile);
    Sites s{};
    for (std::size_t a = 0; a < 3; ++a) {
        s.first[a] = at[a] * length_[a];
        s.last[a] = std::min(s.first[a] + length_[a], layout_.count[a]);
    }
    return s;
}

long LatticeTiles::particles(long tile) const {
    const Sites s = sites(tile);
    return (s.last[0] - s.first[0]) * (s.last[1] - s.first[1]) * (s.last[2] - s.first[2]);
}

void LatticeTiles::add_stretches(long j, long k, long begin, long end) {
    for (long i = begin; i < end; i += block_length)
        stretches_.push_back({j + layout_.count[1] * k, i, std::min(block_length, end - i), layout_.at(i, j, k)});
}

/// Rows of one tile follow each other, except where all are stepped: then rows come in the order of the field.
void LatticeTiles::step_only(const std::vector<char>& stepped) {
    stretches_.clear();
    stepped_ = 0;
    extent_ = {{layout_.count[0], layout_.count[1], layout_.count[2]}, {0, 0, 0}};
    const bool all = std::ranges::all_of(stepped, [](char s) { return s != 0; });
    const auto add_box = [&](const Sites& s) {
        stepped_ += (s.last[0] - s.first[0]) * (s.last[1] - s.first[1]) * (s.last[2] - s.first[2]);
        for (std::size_t a = 0; a < 3; ++a) {
            extent_.first[a] = std::min(extent_.first[a], s.first[a]);
            extent_.last[a] = std::max(extent_.last[a], s.last[a]);
        }
        for (long k = s.first[2]; k < s.last[2]; ++k)
            for (long j = s.first[1]; j < s.last[1]; ++j) add_stretches(j, k, s.first[0], s.last[0]);
    };
    if (all) return add_box({{0, 0, 0}, {layout_.count[0], layout_.count[1], layout_.count[2]}});
    for (long row = 0; row < along_[1] * along_[2]; ++row)
        for (long i = 0; i < along_[0]; ++i) {
            const char* first = stepped.data() + row * along_[0];
            if (!first[i]) continue;
            long last = i;
            while (last + 1 < along_[0] && first[last + 1]) ++last;
            add_box({sites(row * along_[0] + i).first, sites(row * along_[0] + last).last});
            i = last;
        }
}

bool LatticeTiles::reaches(int axis, bool upper, long depth) const {
    const auto a = std::size_t(axis);
    return upper ? extent_.last[a] > layout_.count[axis] - depth : extent_.first[a] < depth;
}

}    // namespace sphonic
