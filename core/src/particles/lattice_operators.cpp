#include "lattice_operators.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "lattice_mends.hpp"
#include "parallel.hpp"
#include "sliding_rows.hpp"
#include "stencil_rows.hpp"

namespace sphonic {
namespace {

/// The interior's weights of one medium, made ready for sliding rows, for a row alone and, by pairs, for a gradient and for a divergence.
template <class Real>
struct FoldedStencil {
    FoldedStencil(const LatticeGrid& grid, const std::vector<Offset>& stencil, double factor, bool gradient)
        : sliding(grid.layout, stencil, factor, gradient) {
        for (const Offset& n : half_neighbours(stencil)) {
            FoldedPair<Real> pair{grid.stride(n), {}};
            for (int a = 0; a < 3; ++a) pair.weight[a] = Real(factor * n.gradient[a]);
            pairs.push_back(pair);
            if (grid.layout.dimension == 1) add_along(n.o[0], pair.weight[0]);
            for (int a = 0; a < 3; ++a)
                if (pair.weight[a] != 0) taps[a].push_back({pair.at, pair.weight[a]});
        }
    }
    SlidingStencil<Real> sliding;
    std::vector<Real> along;    ///< w_1 ... w_R of a set of one dimension
    std::vector<FoldedPair<Real>> pairs;
    std::vector<FoldedTap<Real>> taps[3];

private:
    void add_along(int s, Real weight) {
        along.resize(std::max(along.size(), std::size_t(s)));
        along[std::size_t(s) - 1] = weight;
    }
};

/// By medium.
std::vector<std::vector<Offset>> interior(const LatticeGrid& grid, const Term& term) {
    std::vector<std::vector<Offset>> all;
    for (int m = 0; m < grid.media.count(); ++m)
        all.push_back(weighted_neighbours(grid.scene, term, grid.neighbours[std::size_t(term.kernel)], m));
    return all;
}

/// Gradient or divergence: interior by sliding rows, or where those do not apply by folded pairs, what they leave wrong mended afterwards.
template <class Real>
class Derivative final : public LatticeTerm<Real> {
public:
    using Step = EvaluationOf<Real>;

    Derivative(const LatticeGrid& grid, const Components& components, const Term& term, std::vector<int> target)
        : Derivative(grid, components, term, std::move(target), interior(grid, term)) {}

    Derivative(const LatticeGrid& grid, const Components& components, const Term& term, std::vector<int> target,
               const std::vector<std::vector<Offset>>& stencils)
        : grid_(grid), term_(term), target_(std::move(target)), mends_(lattice_mends(grid, term, stencils)) {
        for (std::size_t m = 0; m < stencils.size(); ++m) {
            const abi::Medium& medium = grid.media.list()[m];
            const double factor = term.coefficient[m] * rest_coefficients(*term.form, derivative(term), medium, medium).other;
            stencils_.emplace_back(grid, stencils[m], factor, term.op == Term::Operator::gradient);
        }
        const int d = grid.scene.box.dimension;
        const Variable& operand = grid.scene.equations.variables[std::size_t(term.operand)];
        for (int a = 0; a < operand.components(d); ++a) operand_.push_back(components.first[std::size_t(term.operand)] + a);
        for (const Factor& f : term.factors) factors_.push_back({components.first[std::size_t(f.variable)], f.power});
    }

    void apply(const Step& e) override {
        if (!factors_.empty()) return apply_with_factors(e);
        Real* out[3];
        for (std::size_t a = 0; a < target_.size(); ++a) out[a] = e.out[target_[a]];
        sweep(e, out, {Real(e.scale), e.assign});
    }

private:
    struct PowerOf {
        int component;
        int power;
    };
    const LatticeGrid& grid_;
    const Term& term_;
    std::vector<int> target_, operand_;
    std::vector<FoldedStencil<Real>> stencils_;    ///< by medium
    RowMends mends_;
    std::vector<PowerOf> factors_;
    ArrayOf<Real> scratch_[3];

    using Fields = const Real* const*;

    template <int D>
    void sweep_in(const Step& e, Real* const* out, const Finish<Real>& finish) const {
        const Real* f[3] = {};
        for (std::size_t a = 0; a < operand_.size(); ++a) f[a] = e.state[operand_[a]];
        grid_.for_blocks([&](int medium, long offset, long n) {
            const FoldedStencil<Real>& s = stencils_[std::size_t(medium)];
            sweep_stretch<D>(s, f, offset, n, finish, out);
            mends_.mend(offset, n, f, out, finish.scale);
        });
    }

    template <int D>
    void sweep_stretch(const FoldedStencil<Real>& s, Fields f, long offset, long n, const Finish<Real>& finish, Real* const* out) const {
        if constexpr (D > 1 && columns_fit) switch (s.sliding.reach) {
            case 1: return slide<D, 1>(s.sliding, f, offset, n, finish, out);
            case 2: return slide<D, 2>(s.sliding, f, offset, n, finish, out);
            case 3: return slide<D, 3>(s.sliding, f, offset, n, finish, out);
        }
        if constexpr (D == 1 && columns_fit) switch (s.along.size()) {
            case 1: return slide_along<Real, 1>(s.along.data(), f[0], offset, n, finish, out);
            case 2: return slide_along<Real, 2>(s.along.data(), f[0], offset, n, finish, out);
            case 3: return slide_along<Real, 3>(s.along.data(), f[0], offset, n, finish, out);
            case 4: return slide_along<Real, 4>(s.along.data(), f[0], offset, n, finish, out);
            case 5: return slide_along<Real, 5>(s.along.data(), f[0], offset, n, finish, out);
            case 6: return slide_along<Real, 6>(s.along.data(), f[0], offset, n, finish, out);
            case 7: return slide_along<Real, 7>(s.along.data(), f[0], offset, n, finish, out);
        }
        sweep_pairs<D>(s, f, offset, n, finish, out);
    }

    template <int D, int R>
    void slide(const SlidingStencil<Real>& s, Fields f, long offset, long n, const Finish<Real>& finish, Real* const* out) const {
        if (target_.size() > 1)
            SlidingRow<Real, D, R, true>::apply(s, f, offset, n, finish, out);
        else
            SlidingRow<Real, D, R, false>::apply(s, f, offset, n, finish, out);
    }

    template <int D>
    void sweep_pairs(const FoldedStencil<Real>& s, Fields f, long offset, long n, const Finish<Real>& finish, Real* const* out) const {
        constexpr int wide = D == 3 ? 3 : 4;
        if (term_.op == Term::Operator::gradient)
            sweep_row<D, wide>(offset, n, finish, out, [&](std::ptrdiff_t i, auto& sum) { gradient_block(f[0] + i, s.pairs, sum); });
        else
            sweep_row<1, 4>(offset, n, finish, out, [&]<int V>(std::ptrdiff_t i, LaneOf<Real>(&sum)[1][V]) { divergence_block<Real, D, V>(f, i, s.taps, sum); });
    }

    void sweep(const Step& e, Real* const* out, const Finish<Real>& finish) const {
        switch (grid_.scene.box.dimension) {
            case 1: return sweep_in<1>(e, out, finish);
            case 2: return sweep_in<2>(e, out, finish);
            default: return sweep_in<3>(e, out, finish);
        }
    }

    /// The derivative into scratch, then multiplied by powers of variables.
    void apply_with_factors(const Step& e) {
        const Layout& l = grid_.layout;
        Real* out[3];
        for (std::size_t a = 0; a < target_.size(); ++a) {
            if (!scratch_[a].data()) scratch_[a] = ArrayOf<Real>(std::size_t(l.size));
            out[a] = scratch_[a].data();
        }
        sweep(e, out, {1, true});
        for (std::size_t a = 0; a < target_.size(); ++a)
            grid_.for_stretches([&](const LatticeTiles::Stretch& s) {
                multiply_row(e, out[a] + s.offset, e.out[target_[a]] + s.offset, s.offset, s.n);
            });
    }

    void multiply_row(const Step& e, Real* __restrict value, Real* __restrict target, long offset, long n) const {
        for (const PowerOf& factor : factors_) {
            const Real* __restrict f = e.state[factor.component] + offset;
            for (int p = 0; p < std::abs(factor.power); ++p)
                for (long i = 0; i < n; ++i) value[i] = factor.power > 0 ? value[i] * f[i] : value[i] / f[i];
        }
        const Real scale = Real(e.scale);
        for (long i = 0; i < n; ++i) target[i] = e.assign ? scale * value[i] : target[i] + scale * value[i];
    }
};

}    // namespace

LatticeGrid::LatticeGrid(const Case& scene, const ParticleMedia& media, long line)
    : scene(scene), media(media), layout(Layout::grid(scene.box, long(std::floor(scene.radius() / scene.box.dx + 1e-9)), line)), tiles(scene.box, layout), threads(threads_for(scene)) {
    for (const KernelUse& use : scene.kernels) neighbours.push_back(lattice_neighbours(scene.box, use));
    if (!media.several()) return;
    layout.for_rows([&](long offset, long first) {
        for (long i = 0, begin = 0; i < layout.count[0]; ++i) {
            const bool last = i + 1 == layout.count[0] || media.number(first + i + 1) != media.number(first + i) || i + 1 - begin == block_length;
            if (last) stretches_.push_back({media.number(first + i), offset + begin, i + 1 - begin});
            if (last) begin = i + 1;
        }
    });
}

double LatticeGrid::neighbours_mean() const {
    std::size_t most = 0;
    for (const auto& n : neighbours) most = std::max(most, n.size());
    for (const Variable& v : scene.equations.variables)
        for (const Term& term : v.terms)
            for (const auto& fitted : term.fitted) most = std::max(most, 2 * fitted->weight.size());
    return double(most);
}

template <class Real>
std::unique_ptr<LatticeTerm<Real>> make_lattice_term(const LatticeGrid& grid, const Components& components, const Term& term, const std::vector<int>& target) {
    if constexpr (std::is_same_v<Real, double>)
        if (term.op == Term::Operator::viscosity) return make_lattice_viscosity(grid, components, term, target);
    return std::make_unique<Derivative<Real>>(grid, components, term, target);
}

template std::unique_ptr<LatticeTerm<double>> make_lattice_term<double>(const LatticeGrid&, const Components&, const Term&, const std::vector<int>&);
template std::unique_ptr<LatticeTerm<float>> make_lattice_term<float>(const LatticeGrid&, const Components&, const Term&, const std::vector<int>&);

}    // namespace sphonic
