#include <algorithm>

#include <sphonic/error.hpp>

#include "lattice_operators.hpp"
#include "parallel.hpp"

namespace sphonic {
namespace {

/// du_i/dt = -sum_j m_j Pi_ij grad_i W_ij on a lattice: each offset's geometry is prepared once, then the plugin's
/// functor runs over blocks of a row. Pairs along a row are folded: Pi_ij serves i and, shifted, j.
class LatticeViscosity final : public LatticeTerm<double> {
public:
    LatticeViscosity(const LatticeGrid& grid, const Components& components, const Term& term, std::vector<int> target)
        : grid_(grid), viscosity_(*term.viscosity), target_(std::move(target)) {
        const Case& scene = grid.scene;
        const KernelUse& kernel = scene.kernels[std::size_t(term.kernel)];
        const double mass = scene.medium.rho0 * lattice_volume(scene.box);
        if (grid.layout.ghosts[0] > most_reach)
            throw Error(Fault::input, scene.file + ": /kernel", "the support reaches over " + std::to_string(grid.layout.ghosts[0]) +
                        " spacings, viscosity is made for " + std::to_string(most_reach), "Choose a smaller h");
        const auto add = [&](const Offset& n, bool folded) {
            Pair pair{.offset = n, .at = grid.stride(n), .folded = folded};
            for (int a = 0; a < 3; ++a) {
                pair.r[a] = -n.o[a] * scene.box.dx;
                pair.weight[a] = -mass * n.gradient[a];
            }
            pair.prepared.resize(std::size_t(viscosity_.prepared_size()));
            viscosity_.prepare({.n = 1, .r2 = &n.r2, .h = kernel.h, .c = scene.medium.c0, .rho = scene.medium.rho0},
                               pair.prepared.data());
            pairs_.push_back(std::move(pair));
        };
        for (const Offset& n : grid.neighbours[std::size_t(term.kernel)]) {
            const bool along_row = n.o[1] == 0 && n.o[2] == 0;
            if (along_row && n.o[0] < 0) continue;
            add(n, along_row);
        }
        for (int a = 0; a < scene.box.dimension; ++a) u_.push_back(components.first[std::size_t(term.operand)] + a);
    }

    void apply(const Evaluation& e) override {
        const Layout& l = grid_.layout;
        const auto stretches = grid_.tiles.stretches();
        constexpr long parts = block_length / block;
        in_parallel(grid_.tiles.shares(grid_.threads), parts * long(stretches.size()), [&](long i) {
            const LatticeTiles::Stretch& s = stretches[std::size_t(i / parts)];
            const long begin = s.begin + i % parts * block, end = std::min(begin + block, s.begin + s.n);
            if (begin < end) apply_block(e, l.row(s.row), s.row % l.count[1], s.row / l.count[1], begin, end);
        });
    }

private:
    static constexpr long block = 1024, most_reach = 128;
    struct Pair {
        Offset offset;
        std::ptrdiff_t at;
        bool folded;
        double r[3] = {}, weight[3] = {};
        std::vector<double> prepared{};
    };
    const LatticeGrid& grid_;
    const abi::Viscosity& viscosity_;
    std::vector<int> target_, u_;
    std::vector<Pair> pairs_;

    void apply_block(const Evaluation& e, long row, long j, long k, long begin, long end) {
        const int d = grid_.scene.box.dimension;
        double sum[3][block];
        for (int a = 0; a < d; ++a) std::fill_n(sum[a], end - begin, 0.0);
        for (const Pair& pair : pairs_) {
            const auto [j0, j1] = grid_.reachable(pair.offset, 1);
            const auto [k0, k1] = grid_.reachable(pair.offset, 2);
            if (j < j0 || j >= j1 || k < k0 || k >= k1) continue;
            if (pair.folded)
                add_folded(e, row, pair, begin, end, sum);
            else
                add_plain(e, row, pair, begin, end, sum);
        }
        for (int a = 0; a < d; ++a) write_block(sum[a], end - begin, e.scale, e.assign, e.out[target_[std::size_t(a)]] + row + begin);
    }

    static void write_block(const double* __restrict sum, long n, double scale, bool assign, double* __restrict out) {
        if (assign)
            for (long i = 0; i < n; ++i) out[i] = scale * sum[i];
        else
            for (long i = 0; i < n; ++i) out[i] += scale * sum[i];
    }

    static void add_scaled(double weight, const double* __restrict Pi, long n, double* __restrict sum) {
        for (long i = 0; i < n; ++i) sum[i] += weight * Pi[i];
    }

    /// Pi of the pairs (i, i + offset), i = first ... last - 1 in the row.
    void pair_values(const Evaluation& e, long row, const Pair& pair, long first, long last, double* Pi) const {
        abi::RowPairs pairs{.dimension = grid_.scene.box.dimension, .n = int(last - first), .at = pair.at};
        for (int a = 0; a < pairs.dimension; ++a) {
            pairs.u[a] = e.state[u_[std::size_t(a)]] + row + first;
            pairs.r[a] = pair.r[a];
        }
        viscosity_.row(pairs, pair.prepared.data(), Pi);
    }

    void add_plain(const Evaluation& e, long row, const Pair& pair, long begin, long end, double (*sum)[block]) const {
        const auto [i0, i1] = grid_.reachable(pair.offset, 0);
        const long first = std::max(begin, i0), last = std::min(end, i1);
        if (first >= last) return;
        double Pi[block];
        pair_values(e, row, pair, first, last, Pi);
        for (int a = 0; a < grid_.scene.box.dimension; ++a) {
            if (pair.weight[a] == 0) continue;
            add_scaled(pair.weight[a], Pi, last - first, sum[a] + (first - begin));
        }
    }

    /// Pi(i, i+o) with +weight for i, and Pi(i-o, i) with -weight: one evaluation over [begin - o, end).
    void add_folded(const Evaluation& e, long row, const Pair& pair, long begin, long end, double (*sum)[block]) const {
        const auto [i0, i1] = grid_.reachable(pair.offset, 0);
        const long o = pair.offset.o[0];
        const long first = !grid_.open(0, false) ? begin - o : std::max(begin - o, i0), last = std::min(end, i1);
        if (first >= last) return;
        double Pi[block + most_reach];
        pair_values(e, row, pair, first, last, Pi);
        const double weight = pair.weight[0];
        const long ahead = std::max(begin, first), behind = std::max(begin, first + o);
        add_scaled(weight, Pi + (ahead - first), last - ahead, sum[0] + (ahead - begin));
        add_scaled(-weight, Pi + (behind - o - first), std::min(end, last + o) - behind, sum[0] + (behind - begin));
    }
};

}    // namespace

std::unique_ptr<LatticeTerm<double>> make_lattice_viscosity(const LatticeGrid& grid, const Components& components, const Term& term, const std::vector<int>& target) {
    return std::make_unique<LatticeViscosity>(grid, components, term, target);
}

}    // namespace sphonic
