#include "row_mends.hpp"

#include <algorithm>
#include <numeric>

namespace sphonic {

void RowMends::add(std::ptrdiff_t at, const Vector& own, std::span<const Entry> others) {
    if (own != Vector{}) added_.emplace_back(at, own);
    if (others.empty()) return;
    rows_.push_back({at, entries_.size(), entries_.size() + others.size()});
    for (const Entry& other : others) entries_.push_back({at + other.at, {other.weight[0], other.weight[1], other.weight[2]}});
}

void RowMends::close() {
    join_runs();
    first_run_ = by_layout_row(runs_);
    first_row_ = by_layout_row(rows_);
}

void RowMends::join_runs() {
    const auto axes = [this](std::size_t i) { return std::array{added_[i].second[0] != 0, added_[i].second[1] != 0, added_[i].second[2] != 0}; };
    for (std::size_t begin = 0, end; begin < added_.size(); begin = end) {
        const auto along = axes(begin);
        for (end = begin + 1; end < added_.size() && added_[end].first == added_[end - 1].first + 1 && axes(end) == along;) ++end;
        runs_.push_back({added_[begin].first, long(end - begin), {along[0], along[1], along[2]}, own_.size()});
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t i = begin; along[a] && i < end; ++i) own_.push_back(added_[i].second[a]);
    }
    added_ = {};
}

template <class Part>
std::vector<std::size_t> RowMends::by_layout_row(const std::vector<Part>& parts) const {
    std::vector<std::size_t> first(layout_row(layout_.size) + 2, 0);
    for (const Part& part : parts) ++first[layout_row(part.at) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
}

template <class Real>
void RowMends::mend_own(std::ptrdiff_t offset, long n, const Real* const* f, Real* const* out, double scale) const {
    const std::size_t here = layout_row(offset);
    for (const Run* run = runs_.data() + first_run_[here]; run != runs_.data() + first_run_[here + 1] && run->at < offset + n; ++run) {
        const long begin = std::max(run->at, offset) - run->at, end = std::min(run->at + run->n, offset + n) - run->at;
        const double* __restrict weight = own_.data() + run->first;
        for (int a = 0; a < 3; ++a) {
            if (!run->along[a]) continue;
            const Real* __restrict value = f[gradient_ ? 0 : a] + run->at;
            Real* __restrict target = out[gradient_ ? a : 0] + run->at;
            for (long i = begin; i < end; ++i) target[i] += Real(scale * weight[i] * value[i]);
            weight += run->n;
        }
    }
}

template <class Real>
void RowMends::mend_by_others(std::ptrdiff_t offset, long n, const Real* const* f, Real* const* out, double scale) const {
    const std::size_t here = layout_row(offset);
    const Row *first = rows_.data() + first_row_[here], *last = rows_.data() + first_row_[here + 1];
    if (first == last) return;
    const int d = layout_.dimension;
    for (const Row* row = std::lower_bound(first, last, offset, [](const Row& r, std::ptrdiff_t at) { return r.at < at; }); row != last && row->at < offset + n; ++row) {
        double sum[3] = {0, 0, 0};
        for (const Entry* entry = entries_.data() + row->begin; entry != entries_.data() + row->end; ++entry)
            for (int a = 0; a < d; ++a) sum[a] += entry->weight[a] * f[gradient_ ? 0 : a][entry->at];
        for (int a = 0; a < d; ++a) out[gradient_ ? a : 0][row->at] += Real(scale * sum[a]);
    }
}

template void RowMends::mend_own<double>(std::ptrdiff_t, long, const double* const*, double* const*, double) const;
template void RowMends::mend_own<float>(std::ptrdiff_t, long, const float* const*, float* const*, double) const;
template void RowMends::mend_by_others<double>(std::ptrdiff_t, long, const double* const*, double* const*, double) const;
template void RowMends::mend_by_others<float>(std::ptrdiff_t, long, const float* const*, float* const*, double) const;

}    // namespace sphonic
