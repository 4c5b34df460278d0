#include "pair_correction.hpp"

#include <string>

#include <sphonic/error.hpp>

#include "correction.hpp"
#include "parallel.hpp"

namespace sphonic {

PairCorrections::PairCorrections(const PairSet& set, int kernel) : set_(set), kernel_(kernel), positions_(set, {}) {
    for (int t = 0; t < set.threads; ++t) workers_.push_back({PairValues(set, positions_)});
    const int d = set.scene.box.dimension;
    for (int k = 0; k < d * (d + 1) / 2; ++k) entry_[k] = Array(std::size_t(set.layout.size));
}

void PairCorrections::compute(const double* inverse_rho) {
    const long n = tiles(set_), threads = set_.threads;
    positions_.fill(nullptr, inverse_rho);
    in_parallel(set_.threads, threads, [&](long t) {
        Worker& worker = workers_[std::size_t(t)];
        worker.degenerate = -1;
        for (long k = n * t / threads; k < n * (t + 1) / threads && worker.degenerate < 0; ++k) {
            take_tile(set_, k, worker.tile);
            worker.pairs.start(worker.tile);
            compute_tile(worker);
        }
    });
    for (const Worker& worker : workers_)
        if (worker.degenerate >= 0) refuse(worker.degenerate, worker.neighbours);
    reflect();
}

void PairCorrections::compute_tile(Worker& worker) {
    switch (set_.scene.box.dimension) {
        case 1: return compute_in<1>(worker);
        case 2: return compute_in<2>(worker);
        default: return compute_in<3>(worker);
    }
}

template <int D>
void PairCorrections::compute_in(Worker& worker) {
    const double* weight = worker.pairs.weight(kernel_);
    worker.tile.for_rows([&](long i, int first, int last) {
        Moment moment(D);
        long neighbours = 0;
        for (int k = first; k < last; ++k) {
            double r[3] = {};
            for (int a = 0; a < D; ++a) r[a] = worker.pairs.r(a)[k];
            moment.add(r, weight[k]);
            neighbours += weight[k] != 0;
        }
        const auto L = moment.inverse();
        if (!L && worker.degenerate < 0) {
            worker.degenerate = i;
            worker.neighbours = neighbours;
        }
        for (int b = 0; L && b < D; ++b)
            for (int a = 0; a <= b; ++a) entry_[at(a, b)].data()[i] = (*L)[std::size_t(3 * a + b)];
    });
}

/// A virtual particle's matrix is its source's, reflected. Sources behind the walls of obstacles may be mirror images, and the
/// sources of others are behind those walls.
void PairCorrections::reflect() {
    reflect_in_faces();
    if (set_.walls.count() == 0) return;
    double* entry[6] = {};
    for (int k = 0; k < 6; ++k) entry[k] = entry_[k].data();
    set_.walls.reflect(entry);
    reflect_in_faces();
}

/// L_ab changes sign with each of its axes that does.
void PairCorrections::reflect_in_faces() {
    const long n = set_.layout.particles() + set_.walls.count();
    in_blocks(set_.threads, set_.mirrors.count(), [&](long begin, long end) {
        for (int b = 0; b < set_.scene.box.dimension; ++b)
            for (int a = 0; a <= b; ++a) {
                double* L = entry_[at(a, b)].data();
                for (long j = n + begin; j < n + end; ++j) L[j] = set_.mirrors.sign(j, a) * set_.mirrors.sign(j, b) * L[set_.mirrors.source(j)];
            }
    });
}

void PairCorrections::refuse(long i, long neighbours) const {
    std::string at;
    for (int a = 0; a < set_.scene.box.dimension; ++a) at += (a ? ", " : "") + std::to_string(set_.x[a][i]);
    throw Error(Fault::input, set_.scene.file + ": /particles",
                "the " + std::to_string(neighbours) + " neighbours of particle " + std::to_string(i) + " at (" + at +
                    ") m do not determine a gradient, which a corrected form needs",
                "Choose a larger h, or an arrangement without isolated particles");
}

void CorrectedSeparations::start(const PairSet& set, const PairCorrections& corrections, const PairTile& tile, PairValues& pairs) {
    const int d = set.scene.box.dimension;
    const std::int32_t* __restrict j = tile.j;
    for (int a = 0; a < d; ++a) {
        double *__restrict own = pairs.room(own_[a]), *__restrict other = pairs.room(other_[a]);
        for (int b = 0; b < d; ++b) {
            const double *__restrict L = corrections.entry(a, b), *__restrict r = pairs.r(b);
            tile.for_rows([&](long i, int first, int last) {
                for (int k = first; k < last; ++k) own[k] = (b ? own[k] : 0) + L[i] * r[k];
            });
            for (int k = 0; corrections.is_pairwise() && k < tile.n; ++k) other[k] = (b ? other[k] : 0) + L[j[k]] * r[k];
        }
    }
}

}    // namespace sphonic
