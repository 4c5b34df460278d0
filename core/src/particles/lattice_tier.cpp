#include <algorithm>
#include <cmath>

#include <sphonic/error.hpp>

#include "lattice_ghosts.hpp"
#include "lattice_operators.hpp"
#include "lattice_terms.hpp"
#include "parallel.hpp"
#include "tier.hpp"

namespace sphonic {
namespace {

class LatticeProgram final : public Program {
public:
    LatticeProgram(const LatticeGrid& grid, const Components& components, const std::vector<int>& variables) : terms_(grid, components, variables) {}
    void evaluate(const Evaluation& e) override { terms_.evaluate(e); }

private:
    LatticeTerms<double> terms_;
};

class LatticeTier final : public Tier {
public:
    LatticeTier(const Case& scene, const Components& components, const ParticleMedia& media)
        : components_(components), grid_(scene, media), ghosts_(scene, components, media, grid_.layout, grid_.tiles, grid_.threads) {}

    const char* name() const override { return "lattice"; }
    const Layout& layout() const override { return grid_.layout; }
    std::unique_ptr<Program> compile(const std::vector<int>& variables) override {
        return std::make_unique<LatticeProgram>(grid_, components_, variables);
    }
    void moved(const double* const*) override {}
    double bytes() const override { return 0; }

    double neighbours_mean() const override { return grid_.neighbours_mean(); }

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
};

}    // namespace

std::unique_ptr<Tier> make_lattice_tier(const Case& scene, const Components& components, const ParticleMedia& media) {
    return std::make_unique<LatticeTier>(scene, components, media);
}

}    // namespace sphonic
