#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <sphonic/plugin/abi/arrangement.hpp>

namespace sphonic {

/// Zeroed values on a 64-byte boundary.
template <class Real>
class ArrayOf {
public:
    ArrayOf() = default;
    explicit ArrayOf(std::size_t n);
    Real* data() { return data_.get(); }
    const Real* data() const { return data_.get(); }
    std::size_t size() const { return size_; }

private:
    struct Release {
        void operator()(Real* p) const { ::operator delete[](p, std::align_val_t(64)); }
    };
    std::unique_ptr<Real[], Release> data_;
    std::size_t size_ = 0;
};
using Array = ArrayOf<double>;

/// Where particle (i, j, k) of a set lies in a field: x fastest, rows padded, ghosts around.
/// A set without structure is one row without ghosts; its virtual particles, if any, follow its own.
struct Layout {
    int dimension = 1;
    long count[3] = {1, 1, 1};
    long ghosts[3] = {0, 0, 0};    ///< layers on either side, per axis
    long stride[3] = {1, 0, 0};
    long origin = 0;               ///< of particle (0, 0, 0)
    long size = 0;                 ///< values to allocate per field

    /// n particles and room for virtual ones.
    static Layout flat(long n, long room);
    /// Rows on boundaries of `line` values.
    static Layout grid(const abi::Box& box, long reach, long line = 8);

    long rows() const { return count[1] * count[2]; }
    /// Offset in a field of the first particle of a row.
    long row(long r) const { return at(0, r % count[1], r / count[1]); }
    long particles() const { return count[0] * count[1] * count[2]; }
    long at(long i, long j, long k) const { return origin + i + j * stride[1] + k * stride[2]; }

    /// Calls row(offset in the field, index of its first particle) for every row of count[0] particles.
    template <class Row>
    void for_rows(Row row) const {
        long first = 0;
        for (long k = 0; k < count[2]; ++k)
            for (long j = 0; j < count[1]; ++j, first += count[0]) row(at(0, j, k), first);
    }
};

/// Field <-> consecutive particles.
template <class Real>
void gather(const Layout& layout, const Real* field, double* particles) {
    layout.for_rows([&](long offset, long first) { std::copy_n(field + offset, layout.count[0], particles + first); });
}
template <class Real>
void scatter(const Layout& layout, const double* particles, Real* field) {
    layout.for_rows([&](long offset, long first) { std::copy_n(particles + first, layout.count[0], field + offset); });
}
/// Index in the field of each particle.
std::vector<std::ptrdiff_t> field_indices(const Layout& layout);

/// All copies of the state: slot 0 is the state, the others are named histories. Arrays appear when first asked for.
template <class Real>
class StoreOf {
public:
    StoreOf(long field_size, int components);
    int components() const { return components_; }
    int slots() const { return int(slots_.size()); }
    Real* array(int slot, int component);
    int history(const std::string& name);
    /// All values zero.
    void clear();
    /// Bytes allocated so far.
    double bytes() const;

private:
    long field_size_;
    int components_;
    std::vector<std::string> names_{"state"};
    std::vector<std::vector<ArrayOf<Real>>> slots_;
};
using Store = StoreOf<double>;

}    // namespace sphonic
