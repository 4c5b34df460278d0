#include <algorithm>
#include <cmath>

#include <sphonic/error.hpp>

#include "neighbour_list.hpp"
#include "pair_tile.hpp"
#include "stencil.hpp"
#include "tier.hpp"

namespace sphonic {
namespace {

constexpr long pairs_per_tile = 288;    // some ten arrays of this length stay in the first-level cache
constexpr double skin_over_dx = 0.25;

/// What the programs of one moving set share.
struct MovingSet {
    const Case& scene;
    const Components& components;
    Layout layout;
    NeighbourList list;
    const double* x[3] = {};    ///< by axis
    double mass = 0;        ///< [kg], the same for all
    double volume = 0;      ///< [m^d], where the equations have no density
};

/// Cuts the particles into tiles of about `pairs_per_tile` pairs; the cut depends on the scene only.
template <class Visit>
void for_tiles(const MovingSet& set, Visit visit) {
    const auto& start = set.list.start();
    PairTile tile;
    const long n = set.layout.particles();
    for (tile.begin = 0; tile.begin < n; tile.begin = tile.end) {
        tile.first.assign(1, 0);
        const std::int64_t base = start[std::size_t(tile.begin)];
        tile.end = tile.begin;
        while (tile.end < n && (tile.end == tile.begin || start[std::size_t(tile.end) + 1] - base <= pairs_per_tile))
            tile.first.push_back(int(start[std::size_t(++tile.end)] - base));
        tile.n = tile.first.back();
        tile.first_run = set.list.first_run().data() + tile.begin;
        tile.runs = set.list.runs().data();
        visit(tile);
    }
}

/// Per-pair values of a tile: separations, kernel slopes, and both sides' values of the components in use.
class PairValues {
public:
    /// `components` are those that the program reads.
    PairValues(const MovingSet& set, const std::vector<int>& components) : set_(set), components_(components) {
        slope_.resize(set.scene.kernels.size());
        weight_.resize(set.scene.kernels.size());
        own_.resize(std::size_t(set.components.count) + 1);
        other_.resize(own_.size());
        if (set.scene.equations.density >= 0) inverse_rho_ = Array(std::size_t(set.layout.size + overrun));
    }

    /// Once per evaluation, before any tile.
    void begin(const double* const* state) {
        state_ = state;
        if (!inverse_rho_.data()) return;
        const double* __restrict rho = state[density()];
        double* __restrict inverse = inverse_rho_.data();
        for (long i = 0; i < set_.layout.size; ++i) inverse[i] = 1 / rho[i];
    }

    void start(const PairTile& tile) {
        tile_ = &tile;
        pack_tile();
        const int d = set_.scene.box.dimension, n = tile.n;
        double *__restrict r2 = room(r2_), *__restrict distance = room(distance_);
        for (int a = 0; a < d; ++a) {
            double* __restrict ra = r_[a].data();
            if (const double period = set_.list.period(a); period > 0)
                for (int k = 0; k < n; ++k) ra[k] -= period * std::nearbyint(ra[k] / period);
            for (int k = 0; k < n; ++k) r2[k] = a == 0 ? ra[k] * ra[k] : r2[k] + ra[k] * ra[k];
        }
        for (int k = 0; k < n; ++k) distance[k] = std::sqrt(r2[k]);
        for (std::size_t i = 0; i < set_.scene.kernels.size(); ++i) {
            const KernelUse& use = set_.scene.kernels[i];
            use.kernel->evaluate(d, n, distance, use.h, nullptr, room(slope_[i]));
            weigh(room(weight_[i]), slope_[i].data());
        }
    }

    int n() const { return tile_->n; }
    const double* r(int axis) const { return r_[axis].data(); }
    const double* r2() const { return r2_.data(); }
    /// (dW/dr)/r, and the same times V_j.
    const double* slope(int kernel) const { return slope_[std::size_t(kernel)].data(); }
    const double* weight(int kernel) const { return weight_[std::size_t(kernel)].data(); }
    const double* own(int component) const { return own_[std::size_t(component)].data(); }
    const double* other(int component) const { return other_[std::size_t(component)].data(); }
    const double* own_inverse_rho() const { return own_.back().data(); }
    const double* other_inverse_rho() const { return other_.back().data(); }
    /// A scratch array of the tile's length.
    double* room(Array& array) const {
        const long need = tile_->n + overrun;
        if (long(array.size()) < need) array = Array(std::size_t(std::max(need, pairs_per_tile + overrun)));
        return array.data();
    }

private:
    const MovingSet& set_;
    std::vector<int> components_;
    const double* const* state_ = nullptr;
    const PairTile* tile_ = nullptr;
    Array r_[3], r2_, distance_, inverse_rho_;
    std::vector<Array> slope_, weight_, own_, other_;
    std::vector<Packing> packings_;

    int density() const { return set_.components.first[std::size_t(set_.scene.equations.density)]; }

    void pack_tile() {
        packings_.clear();
        for (int a = 0; a < set_.scene.box.dimension; ++a) packings_.push_back({set_.x[a], nullptr, room(r_[a])});
        for (const int c : components_)
            packings_.push_back({state_[c], room(own_[std::size_t(c)]), room(other_[std::size_t(c)])});
        if (inverse_rho_.data()) packings_.push_back({inverse_rho_.data(), room(own_.back()), room(other_.back())});
        pack(*tile_, packings_);
    }

    void weigh(double* __restrict weight, const double* __restrict slope) const {
        if (!inverse_rho_.data()) {
            for (int k = 0; k < n(); ++k) weight[k] = set_.volume * slope[k];
            return;
        }
        const double* __restrict inverse = other_inverse_rho();
        const double mass = set_.mass;
        for (int k = 0; k < n(); ++k) weight[k] = mass * inverse[k] * slope[k];
    }
};

class MovingProgram final : public Program {
public:
    MovingProgram(MovingSet& set, const std::vector<int>& variables)
        : set_(set), variables_(variables), pairs_(set, components_read(set, variables)) {}

    void evaluate(const Evaluation& e) override {
        pairs_.begin(e.state);
        for_tiles(set_, [&](const PairTile& tile) {
            pairs_.start(tile);
            for (const int v : variables_) evaluate_variable(v, tile, pairs_, e);
        });
    }

private:
    MovingSet& set_;
    std::vector<int> variables_;
    PairValues pairs_;
    Array sum_, density_, own_, other_, u_dot_r_, Pi_, value_;

    static std::vector<int> components_read(const MovingSet& set, const std::vector<int>& variables) {
        const Equations& e = set.scene.equations;
        std::vector<int> read;
        const auto add = [&](int v) {
            for (int c = 0; c < e.variables[std::size_t(v)].components(set.scene.box.dimension); ++c)
                read.push_back(set.components.first[std::size_t(v)] + c);
        };
        if (e.density >= 0) add(e.density);
        for (const int v : variables)
            for (const Term& term : e.variables[std::size_t(v)].terms) {
                add(term.operand);
                for (const Factor& f : term.factors) add(f.variable);
            }
        std::sort(read.begin(), read.end());
        read.erase(std::unique(read.begin(), read.end()), read.end());
        return read;
    }

    const Variable& variable(int v) const { return set_.scene.equations.variables[std::size_t(v)]; }
    int component(int v) const { return set_.components.first[std::size_t(v)]; }

    /// All terms of a variable as one scalar per pair, which a vector multiplies by r_ij.
    void evaluate_variable(int v, const PairTile& tile, PairValues& pairs, const Evaluation& e) {
        double* sum = pairs.room(sum_);
        const auto& terms = variable(v).terms;
        if (terms.empty()) std::fill_n(sum, tile.n, 0.0);
        for (const Term& term : terms) {
            const bool first = &term == &terms.front();
            if (term.op == Term::Operator::viscosity)
                add_viscosity(term, pairs, sum, first);
            else
                add_derivative(term, pairs, sum, first);
        }
        if (!variable(v).is_vector) return row_sums(tile, sum, e.scale, e.assign, e.out[component(v)]);
        for (int a = 0; a < set_.scene.box.dimension; ++a)
            row_sums(tile, sum, pairs.r(a), e.scale, e.assign, e.out[component(v) + a]);
    }

    void add_derivative(const Term& term, PairValues& pairs, double* __restrict sum, bool first) {
        const auto [own, other] = coefficients(term, pairs);
        double* __restrict value = pairs.room(value_);
        const bool gradient = term.op == Term::Operator::gradient;
        for (int a = 0; a < (gradient ? 1 : set_.scene.box.dimension); ++a) {
            const int c = component(term.operand) + a;
            combine(pairs.n(), own, other, pairs.own(c), pairs.other(c), gradient ? nullptr : pairs.r(a), a == 0, value);
        }
        const double coefficient = term.coefficient;
        const double* __restrict weight = pairs.weight(term.kernel);
        for (const Factor& factor : term.factors) multiply(value, pairs, factor);
        if (first)
            for (int k = 0; k < pairs.n(); ++k) sum[k] = coefficient * value[k] * weight[k];
        else
            for (int k = 0; k < pairs.n(); ++k) sum[k] += coefficient * value[k] * weight[k];
    }

    /// Per-pair coefficients; a stride of 0 in `Coefficient` stands for a uniform one.
    struct Coefficient {
        const double* value;
        int stride;
    };

    std::pair<Coefficient, Coefficient> coefficients(const Term& term, PairValues& pairs) {
        double *own = pairs.room(own_), *other = pairs.room(other_);
        const int rho = set_.scene.equations.density;
        if (term.form->uniform() || rho < 0) {
            const RestCoefficients c = rest_coefficients(*term.form, set_.scene.medium.rho0);
            own[0] = c.own, other[0] = c.other;
            return {{own, 0}, {other, 0}};
        }
        term.form->coefficients({pairs.n(), pairs.own(component(rho)), pairs.other(component(rho)), pairs.own_inverse_rho(),
                                 pairs.other_inverse_rho()}, own, other);
        return {{own, 1}, {other, 1}};
    }

    /// value = own f_i + other f_j, times r_a and added up over the axes for a divergence.
    static void combine(int n, Coefficient own, Coefficient other, const double* __restrict fi, const double* __restrict fj,
                        const double* __restrict r, bool first, double* __restrict value) {
        const auto sweep = [&](auto pair) {
            if (!r)
                for (int k = 0; k < n; ++k) value[k] = pair(k);
            else if (first)
                for (int k = 0; k < n; ++k) value[k] = pair(k) * r[k];
            else
                for (int k = 0; k < n; ++k) value[k] += pair(k) * r[k];
        };
        if (own.stride == 0) {
            const double a = own.value[0], b = other.value[0];
            sweep([=](int k) { return a * fi[k] + b * fj[k]; });
        } else {
            const double *a = own.value, *b = other.value;
            sweep([=](int k) { return a[k] * fi[k] + b[k] * fj[k]; });
        }
    }

    void multiply(double* __restrict value, PairValues& pairs, const Factor& factor) const {
        const bool inverse = factor.power < 0, density = factor.variable == set_.scene.equations.density;
        const double* __restrict f = inverse && density ? pairs.own_inverse_rho() : pairs.own(component(factor.variable));
        const int n = pairs.n();
        for (int p = 0; p < std::abs(factor.power); ++p) {
            if (inverse && !density)
                for (int k = 0; k < n; ++k) value[k] /= f[k];
            else
                for (int k = 0; k < n; ++k) value[k] *= f[k];
        }
    }

    void add_viscosity(const Term& term, PairValues& pairs, double* __restrict sum, bool first) {
        const int n = pairs.n(), rho = set_.scene.equations.density;
        double* __restrict u_dot_r = pairs.room(u_dot_r_);
        for (int a = 0; a < set_.scene.box.dimension; ++a) {
            const int c = component(term.operand) + a;
            const double *__restrict ui = pairs.own(c), *__restrict uj = pairs.other(c), *__restrict r = pairs.r(a);
            if (a == 0)
                for (int k = 0; k < n; ++k) u_dot_r[k] = (ui[k] - uj[k]) * r[k];
            else
                for (int k = 0; k < n; ++k) u_dot_r[k] += (ui[k] - uj[k]) * r[k];
        }
        abi::PairBlock block{.n = n, .u_dot_r = u_dot_r, .r2 = pairs.r2()};
        block.h = set_.scene.kernels[std::size_t(term.kernel)].h;
        block.c = set_.scene.medium.c0;
        block.rho = set_.scene.medium.rho0;
        if (rho >= 0) {
            double* __restrict mean = pairs.room(density_);
            const double *__restrict ri = pairs.own(component(rho)), *__restrict rj = pairs.other(component(rho));
            for (int k = 0; k < n; ++k) mean[k] = 0.5 * (ri[k] + rj[k]);
            block.rho_each = mean;
        }
        double* __restrict Pi = pairs.room(Pi_);
        term.viscosity->pairs(block, Pi);
        const double* __restrict slope = pairs.slope(term.kernel);
        const double mass = set_.mass;
        if (first)
            for (int k = 0; k < n; ++k) sum[k] = -mass * slope[k] * Pi[k];
        else
            for (int k = 0; k < n; ++k) sum[k] -= mass * slope[k] * Pi[k];
    }
};

class MovingTier final : public Tier {
public:
    MovingTier(const Case& scene, const Components& components, const double* const* x)
        : set_{.scene = scene,
               .components = components,
               .layout = Layout::flat(scene.arrangement->size(scene.box)),
               .list = NeighbourList(scene.box, scene.arrangement->size(scene.box), scene.radius(), skin_over_dx * scene.box.dx)} {
        set_.volume = lattice_volume(scene.box);
        set_.mass = scene.medium.rho0 * set_.volume;
        check_box();
        std::copy_n(x, scene.box.dimension, set_.x);
        set_.list.update(x);
        neighbours_mean_ = set_.list.mean_within_radius(x);
    }

    const char* name() const override { return "moving"; }
    const Layout& layout() const override { return set_.layout; }
    std::unique_ptr<Program> compile(const std::vector<int>& variables) override {
        return std::make_unique<MovingProgram>(set_, variables);
    }
    void fill_ghosts(double*) const override {}
    void moved(const double* const* x) override {
        std::copy_n(x, set_.scene.box.dimension, set_.x);
        set_.list.update(x);
    }
    double neighbours_mean() const override { return neighbours_mean_; }
    double bytes() const override { return set_.list.bytes(); }

private:
    MovingSet set_;
    double neighbours_mean_ = 0;

    void check_box() const {
        const abi::Box& box = set_.scene.box;
        const double radius = set_.scene.radius() + skin_over_dx * box.dx;
        for (int a = 0; a < box.dimension; ++a)
            if (box.periodic[a] && box.upper[a] - box.lower[a] < 2 * radius)
                throw Error(Fault::input, set_.scene.file + ": /particles/upper",
                            "the periodic axis " + std::string(1, "xyz"[a]) + " is shorter than two interaction radii of " +
                                std::to_string(radius) + " m",
                            "Lengthen the box or choose a smaller h");
    }
};

}    // namespace

std::unique_ptr<Tier> make_moving_tier(const Case& scene, const Components& components, const double* const* x) {
    return std::make_unique<MovingTier>(scene, components, x);
}

}    // namespace sphonic
