#include <algorithm>
#include <cmath>

#include <sphonic/error.hpp>

#include "lattice_ghosts.hpp"
#include "lattice_operators.hpp"
#include "parallel.hpp"
#include "tier.hpp"

namespace sphonic {
namespace {

class LatticeProgram final : public Program {
public:
    LatticeProgram(const LatticeGrid& grid, const Components& components, const std::vector<int>& variables)
        : grid_(grid) {
        for (const int v : variables) {
            const Variable& variable = grid.scene.equations.variables[std::size_t(v)];
            std::vector<int> target;
            for (int c = 0; c < variable.components(grid.scene.box.dimension); ++c)
                target.push_back(components.first[std::size_t(v)] + c);
            if (variable.terms.empty()) still_.insert(still_.end(), target.begin(), target.end());
            for (std::size_t t = 0; t < variable.terms.size(); ++t)
                operators_.push_back({make_lattice_operator(grid, components, variable.terms[t], target), t == 0});
        }
    }

    void evaluate(const Evaluation& e) override {
        if (e.assign)
            for (const int c : still_) std::fill_n(e.out[c], grid_.layout.size, 0.0);
        for (const auto& [op, first] : operators_) {
            Evaluation share = e;
            share.assign = e.assign && first;
            op->apply(share);
        }
    }

private:
    struct Entry {
        std::unique_ptr<LatticeOperator> op;
        bool first;    ///< of its variable: assigns where the others add
    };
    const LatticeGrid& grid_;
    std::vector<Entry> operators_;
    std::vector<int> still_;
};

class LatticeTier final : public Tier {
public:
    LatticeTier(const Case& scene, const Components& components, const ParticleMedia& media)
        : components_(components), grid_(scene, media, reach(scene)), ghosts_(scene, components, media, grid_.layout, grid_.tiles, grid_.threads) {}

    const char* name() const override { return "lattice"; }
    const Layout& layout() const override { return grid_.layout; }
    std::unique_ptr<Program> compile(const std::vector<int>& variables) override {
        return std::make_unique<LatticeProgram>(grid_, components_, variables);
    }
    void moved(const double* const*) override {}
    double bytes() const override { return 0; }

    /// Without the ends of a bounded set, where particles have fewer.
    double neighbours_mean() const override {
        std::size_t most = 0;
        for (const auto& n : grid_.neighbours) most = std::max(most, n.size());
        for (const Variable& v : grid_.scene.equations.variables)
            for (const Term& term : v.terms)
                for (const auto& fitted : term.fitted) most = std::max(most, 2 * fitted->weight.size());
        return double(most);
    }

    LatticeTiles* tiles() override { return &grid_.tiles; }
    double farthest() const override {
        double squares = 0;
        for (const auto& neighbours : grid_.neighbours)
            for (const Offset& n : neighbours) squares = std::max(squares, n.r2 / std::pow(grid_.scene.box.dx, 2));
        for (const Variable& v : grid_.scene.equations.variables)
            for (const Term& term : v.terms)
                for (const auto& fitted : term.fitted)
                    for (const auto& o : fitted->offset) squares = std::max(squares, double(o[0] * o[0] + o[1] * o[1] + o[2] * o[2]));
        return std::sqrt(squares);
    }
    void fill_ghosts(int component, double* field, const double* pressure, double t) override { ghosts_.fill(component, field, pressure, t); }
    void restart() override { ghosts_.restart(); }
    std::vector<std::span<double>> memory() override { return ghosts_.remembered(); }

private:
    const Components& components_;
    LatticeGrid grid_;
    LatticeGhosts ghosts_;

    static long reach(const Case& scene) { return long(std::floor(scene.radius() / scene.box.dx + 1e-9)); }
};

}    // namespace

std::unique_ptr<Tier> make_lattice_tier(const Case& scene, const Components& components, const ParticleMedia& media) {
    return std::make_unique<LatticeTier>(scene, components, media);
}

}    // namespace sphonic
