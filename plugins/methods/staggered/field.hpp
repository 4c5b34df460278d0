#pragma once
#include <cstddef>
#include <new>
#include <vector>

namespace staggered {

/// Begins on a cache line.
template <class T>
struct Aligned {
    using value_type = T;
    static constexpr std::align_val_t line{64};

    Aligned() = default;
    template <class Other>
    Aligned(const Aligned<Other>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
    void deallocate(T* p, std::size_t) { ::operator delete(p, line); }
    bool operator==(const Aligned&) const { return true; }
};

using Field = std::vector<double, Aligned<double>>;

}    // namespace staggered
