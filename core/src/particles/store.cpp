#include "store.hpp"

#include <algorithm>

#include "lanes.hpp"

namespace sphonic {

template <class Real>
ArrayOf<Real>::ArrayOf(std::size_t n) : data_(new (std::align_val_t(64)) Real[n]()), size_(n) {}

Layout Layout::flat(long n, long room) {
    Layout layout;
    layout.count[0] = n;
    layout.size = n + room + overrun;
    return layout;
}

Layout Layout::grid(const abi::Box& box, long reach, long line) {
    const long before = line, after = 3 * line;    // what stencils that work ahead read beyond the first and the last row
    Layout layout;
    layout.dimension = box.dimension;
    for (int a = 0; a < box.dimension; ++a) {
        layout.count[a] = box.count[a];
        layout.ghosts[a] = reach;
    }
    const long lead = (reach + line - 1) / line * line;
    const long row = (lead + layout.count[0] + reach + 2 * line - 1) / line * line;
    layout.stride[1] = row;
    layout.stride[2] = row * (layout.count[1] + 2 * layout.ghosts[1]);
    layout.origin = before + lead + layout.ghosts[1] * layout.stride[1] + layout.ghosts[2] * layout.stride[2];
    layout.size = before + layout.stride[2] * (layout.count[2] + 2 * layout.ghosts[2]) + after;
    return layout;
}

std::vector<std::ptrdiff_t> field_indices(const Layout& layout) {
    std::vector<std::ptrdiff_t> index;
    index.reserve(std::size_t(layout.particles()));
    layout.for_rows([&](long offset, long) {
        for (long i = 0; i < layout.count[0]; ++i) index.push_back(offset + i);
    });
    return index;
}

template <class Real>
StoreOf<Real>::StoreOf(long field_size, int components) : field_size_(field_size), components_(components) {
    slots_.resize(1);
    slots_[0].resize(std::size_t(components));
}

template <class Real>
Real* StoreOf<Real>::array(int slot, int component) {
    ArrayOf<Real>& a = slots_[std::size_t(slot)][std::size_t(component)];
    if (!a.data()) a = ArrayOf<Real>(std::size_t(field_size_));
    return a.data();
}

template <class Real>
int StoreOf<Real>::history(const std::string& name) {
    const auto known = std::find(names_.begin(), names_.end(), name);
    if (known != names_.end()) return int(known - names_.begin());
    names_.push_back(name);
    slots_.emplace_back(std::size_t(components_));
    return int(names_.size()) - 1;
}

template <class Real>
void StoreOf<Real>::clear() {
    for (auto& slot : slots_)
        for (ArrayOf<Real>& a : slot) std::fill_n(a.data(), a.size(), Real(0));
}

template <class Real>
double StoreOf<Real>::bytes() const {
    double total = 0;
    for (const auto& slot : slots_)
        for (const ArrayOf<Real>& a : slot) total += sizeof(Real) * double(a.size());
    return total;
}

template class ArrayOf<double>;
template class ArrayOf<float>;
template class StoreOf<double>;
template class StoreOf<float>;

}    // namespace sphonic
