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
        const auto add = [&](const Offset& n, std::vector<Pair>& pairs) {
            Pair pair{.offset = n, .at = grid.stride(n)};
            for (int a = 0; a < 3; ++a) {
                pair.r[a] = -n.o[a] * scene.box.dx;
                pair.weight[a] = -mass * n.gradient[a];
            }
            pair.prepared.resize(std::size_t(viscosity_.prepared_size()));
            viscosity_.prepare({.n = 1, .r2 = &n.r2, .h = kernel.h, .c = scene.medium.c0, .rho = scene.medium.rho0},
                               pair.prepared.data());
            pairs.push_back(std::move(pair));
        };
        for (const Offset& n : grid.neighbours[std::size_t(term.kernel)]) {
            const bool along_row = n.o[1] == 0 && n.o[2] == 0;
            if (!along_row) add(n, plain_);
            if (along_row && n.o[0] > 0) add(n, folded_);
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
            if (begin < end) apply_part(e, {l.row(s.row), s.row % l.count[1], s.row / l.count[1], begin, end});
        });
    }

private:
    static constexpr long block = 512, most_reach = 128;
    static constexpr std::size_t together = 4;    ///< offsets whose values are summed in one pass: sums are loaded and stored less often
    struct Pair {
        Offset offset;
        std::ptrdiff_t at;
        double r[3] = {}, weight[3] = {};
        std::vector<double> prepared{};
    };
    /// Particles begin ... end - 1 of a row, and (j, k) of the row.
    struct Part {
        long row, j, k, begin, end;
    };
    const LatticeGrid& grid_;
    const abi::Viscosity& viscosity_;
    std::vector<int> target_, u_;
    std::vector<Pair> folded_, plain_;

    void apply_part(const Evaluation& e, const Part& part) {
        const int d = grid_.scene.box.dimension;
        double sum[3][block];
        for (int a = 0; a < d; ++a) std::fill_n(sum[a], part.end - part.begin, 0.0);
        for (const Pair& pair : folded_) add_folded(e, part, pair, sum[0]);
        const Pair* group[together];
        std::size_t n = 0;
        for (const Pair& pair : plain_) {
            if (!reaches(pair, part)) continue;
            group[n++] = &pair;
            if (n == together) add_plain(e, part, group, n, sum), n = 0;
        }
        if (n > 0) add_plain(e, part, group, n, sum);
        for (int a = 0; a < d; ++a) write(sum[a], part.end - part.begin, e.scale, e.assign, e.out[target_[std::size_t(a)]] + part.row + part.begin);
    }

    bool reaches(const Pair& pair, const Part& part) const {
        const auto [j0, j1] = grid_.reachable(pair.offset, 1);
        const auto [k0, k1] = grid_.reachable(pair.offset, 2);
        return part.j >= j0 && part.j < j1 && part.k >= k0 && part.k < k1;
    }

    static void write(const double* __restrict sum, long n, double scale, bool assign, double* __restrict out) {
        if (assign)
            for (long i = 0; i < n; ++i) out[i] = scale * sum[i];
        else
            for (long i = 0; i < n; ++i) out[i] += scale * sum[i];
    }

    /// Pi of the pairs (i, i + offset), i = from ... to - 1 in the row; zero outside of first ... last - 1, where there are none.
    void pair_values(const Evaluation& e, long row, const Pair& pair, long from, long to, long first, long last, double* Pi) const {
        first = std::clamp(first, from, to), last = std::clamp(last, first, to);
        std::fill(Pi, Pi + (first - from), 0.0);
        std::fill(Pi + (last - from), Pi + (to - from), 0.0);
        if (first == last) return;
        abi::RowPairs pairs{.dimension = grid_.scene.box.dimension, .n = int(last - first), .at = pair.at};
        for (int a = 0; a < pairs.dimension; ++a) {
            pairs.u[a] = e.state[u_[std::size_t(a)]] + row + first;
            pairs.r[a] = pair.r[a];
        }
        viscosity_.row(pairs, pair.prepared.data(), Pi + (first - from));
    }

    void add_plain(const Evaluation& e, const Part& part, const Pair* const* group, std::size_t n, double (*sum)[block]) const {
        double Pi[together][block];
        for (std::size_t g = 0; g < n; ++g) {
            const auto [i0, i1] = grid_.reachable(group[g]->offset, 0);
            pair_values(e, part.row, *group[g], part.begin, part.end, i0, i1, Pi[g]);
        }
        for (std::size_t g = n; g < together; ++g) std::fill_n(Pi[g], part.end - part.begin, 0.0);
        for (int a = 0; a < grid_.scene.box.dimension; ++a) {
            double weight[together] = {};
            for (std::size_t g = 0; g < n; ++g) weight[g] = group[g]->weight[a];
            add_weighted(weight, Pi, part.end - part.begin, sum[a]);
        }
    }

    static void add_weighted(const double (&weight)[together], const double (&Pi)[together][block], long n, double* __restrict sum) {
        for (long i = 0; i < n; ++i) sum[i] += (weight[0] * Pi[0][i] + weight[1] * Pi[1][i]) + (weight[2] * Pi[2][i] + weight[3] * Pi[3][i]);
    }

    /// Pi(i, i+o) with +weight for i, and Pi(i-o, i) with -weight: one evaluation over [begin - o, end).
    void add_folded(const Evaluation& e, const Part& part, const Pair& pair, double* __restrict sum) const {
        const auto [i0, i1] = grid_.reachable(pair.offset, 0);
        const long o = pair.offset.o[0], from = part.begin - o, n = part.end - part.begin;
        double Pi[block + most_reach];
        pair_values(e, part.row, pair, from, part.end, grid_.open(0, false) ? i0 : from, i1, Pi);
        const double* __restrict own = Pi + o;
        for (long i = 0; i < n; ++i) sum[i] += pair.weight[0] * (own[i] - Pi[i]);
    }
};

}    // namespace

std::unique_ptr<LatticeTerm<double>> make_lattice_viscosity(const LatticeGrid& grid, const Components& components, const Term& term, const std::vector<int>& target) {
    return std::make_unique<LatticeViscosity>(grid, components, term, target);
}

}    // namespace sphonic
