#include "store.hpp"

#include <algorithm>

#include "lanes.hpp"

namespace sphonic {

Array::Array(std::size_t n) : data_(new (std::align_val_t(64)) double[n]()), size_(n) {}

Layout Layout::flat(long n, long room) {
    Layout layout;
    layout.count[0] = n;
    layout.size = n + room + overrun;
    return layout;
}

Layout Layout::grid(const abi::Box& box, long reach) {
    constexpr long line = lanes;    // a cache line holds as many doubles as the widest vector
    constexpr long before = line, after = 3 * line;    // what stencils that work ahead read beyond the first and the last row
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

void gather(const Layout& layout, const double* field, double* particles) {
    layout.for_rows([&](long offset, long first) { std::copy_n(field + offset, layout.count[0], particles + first); });
}

void scatter(const Layout& layout, const double* particles, double* field) {
    layout.for_rows([&](long offset, long first) { std::copy_n(particles + first, layout.count[0], field + offset); });
}

std::vector<std::ptrdiff_t> field_indices(const Layout& layout) {
    std::vector<std::ptrdiff_t> index;
    index.reserve(std::size_t(layout.particles()));
    layout.for_rows([&](long offset, long) {
        for (long i = 0; i < layout.count[0]; ++i) index.push_back(offset + i);
    });
    return index;
}

Store::Store(long field_size, int components) : field_size_(field_size), components_(components) {
    slots_.resize(1);
    slots_[0].resize(std::size_t(components));
}

double* Store::array(int slot, int component) {
    Array& a = slots_[std::size_t(slot)][std::size_t(component)];
    if (!a.data()) a = Array(std::size_t(field_size_));
    return a.data();
}

int Store::history(const std::string& name) {
    const auto known = std::find(names_.begin(), names_.end(), name);
    if (known != names_.end()) return int(known - names_.begin());
    names_.push_back(name);
    slots_.emplace_back(std::size_t(components_));
    return int(names_.size()) - 1;
}

void Store::clear() {
    for (auto& slot : slots_)
        for (Array& a : slot) std::fill_n(a.data(), a.size(), 0.0);
}

double Store::bytes() const {
    double total = 0;
    for (const auto& slot : slots_)
        for (const Array& a : slot) total += 8.0 * double(a.size());
    return total;
}

}    // namespace sphonic
