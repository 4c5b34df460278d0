#pragma once
/// Work shared among threads. What a piece of work is depends on the scene only, never on the number of threads, and no
/// two pieces write the same value: results are the same to the last bit for any number.

#include <algorithm>

#include <sphonic/case.hpp>

#include "store.hpp"

namespace sphonic {

/// Calls piece(i) for i = 0 ... n - 1, in contiguous shares.
template <class Piece>
void in_parallel(int threads, long n, Piece piece) {
    if (threads == 1 || n == 1) {    // an idle region costs a tenth of a step of a small set
        for (long i = 0; i < n; ++i) piece(i);
        return;
    }
#pragma omp parallel for schedule(static) num_threads(threads)
    for (long i = 0; i < n; ++i) piece(i);
}

/// Values of a field that one piece of work covers: whole vectors.
inline constexpr long block_length = 4096;

/// Calls block(begin, end) over [0, n).
template <class Block>
void in_blocks(int threads, long n, Block block) {
    in_parallel(threads, (n + block_length - 1) / block_length,
                [&](long i) { block(i * block_length, std::min((i + 1) * block_length, n)); });
}

/// Calls block(row, offset of the block in the field, its first particle in the row, particles) over all rows of a layout.
template <class Block>
void in_row_blocks(int threads, const Layout& layout, Block block) {
    const long n = layout.count[0], per_row = (n + block_length - 1) / block_length;
    in_parallel(threads, per_row * layout.rows(), [&](long i) {
        const long row = i / per_row, begin = i % per_row * block_length;
        block(row, layout.row(row) + begin, begin, std::min(block_length, n - begin));
    });
}

/// Threads for a run: those that the case asks for; else as many as the machine has, but none for less than a worthwhile share.
int threads_for(const Case& scene);

}    // namespace sphonic
