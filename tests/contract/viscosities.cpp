/// Laws that hold for every viscosity found.
#include <random>

#include <sphonic/plugin/abi/viscosity.hpp>

#include "subjects.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

/// n pairs of a gas of h ~ 0.13 m, c ~ 340 m/s, rho ~ 1.2 kg/m^3, from nearly touching to beyond any support,
/// approaching and receding; media of each pair for those blocks that want them.
struct Pairs {
    std::vector<double> u_dot_r, r2, h, c, rho;

    explicit Pairs(int n, unsigned seed = 1) {
        std::mt19937 engine(seed);
        std::uniform_real_distribution<double> unit(0, 1);
        for (int k = 0; k < n; ++k) {
            h.push_back(0.13 * (0.7 + 0.6 * unit(engine)));
            c.push_back(340 * (0.7 + 0.6 * unit(engine)));
            rho.push_back(1.2 * (0.7 + 0.6 * unit(engine)));
            const double r = 0.13 * (0.01 + 3 * unit(engine));
            r2.push_back(r * r);
            u_dot_r.push_back((2 * unit(engine) - 1) * 0.1 * r * c.back());
        }
    }
    int size() const { return int(r2.size()); }

    /// Bits of `each` say which of h, c, rho go in per pair; the others are those of pair `of`.
    abi::PairBlock block(unsigned each, std::size_t of = 0) const {
        return {.n = size(),
                .u_dot_r = u_dot_r.data(),
                .r2 = r2.data(),
                .h = h[of],
                .c = c[of],
                .rho = rho[of],
                .h_each = each & 1u ? h.data() : nullptr,
                .c_each = each & 2u ? c.data() : nullptr,
                .rho_each = each & 4u ? rho.data() : nullptr};
    }
    /// Pair k alone, with uniform media: what the block of 1 sees.
    abi::PairBlock one(std::size_t k, unsigned each) const {
        return {.n = 1,
                .u_dot_r = &u_dot_r[k],
                .r2 = &r2[k],
                .h = h[each & 1u ? k : 0],
                .c = c[each & 2u ? k : 0],
                .rho = rho[each & 4u ? k : 0]};
    }
};

std::vector<double> pressure(const abi::Viscosity& viscosity, const abi::PairBlock& block) {
    std::vector<double> Pi(std::size_t(block.n));
    viscosity.pairs(block, Pi.data());
    return Pi;
}

/// Touching pairs outweigh the others by orders of magnitude: each pair is compared by its own size.
double relative_gap(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    std::vector<double> gaps;
    for (std::size_t k = 0; k < a.size(); ++k)
        gaps.push_back(a[k] == b[k] ? 0 : (a[k] - b[k]) / std::max(std::abs(a[k]), std::abs(b[k])));
    return largest(gaps);
}

template <class Law>
void for_each_viscosity(Law&& law) {
    for (const auto& subject : subjects<abi::Viscosity>()) {
        INFO(subject.label);
        law(*subject.object, subject.defaults);
    }
}

}    // namespace

TEST_CASE("a viscosity is zero for receding pairs and brakes approaching ones", "[viscosity]") {
    for_each_viscosity([](const abi::Viscosity& viscosity, bool defaults) {
        const Pairs pairs(500);
        const auto Pi = pressure(viscosity, pairs.block(7));
        double driving = 0, receding = 0, weakest = infinite;
        for (std::size_t k = 0; k < Pi.size(); ++k) {
            driving = std::max(driving, Pi[k] * pairs.u_dot_r[k]);
            if (pairs.u_dot_r[k] >= 0) receding = std::max(receding, std::abs(Pi[k]));
            if (pairs.u_dot_r[k] < 0) weakest = std::min(weakest, Pi[k]);
        }
        CHECK(driving == 0);
        CHECK(receding == 0);
        if (defaults) CHECK(weakest > 0);
    });
}

TEST_CASE("a viscosity prepared once and applied gives what it gives for pairs", "[viscosity]") {
    for_each_viscosity([](const abi::Viscosity& viscosity, bool) {
        const Pairs pairs(24);
        const int size = viscosity.prepared_size();
        REQUIRE(size > 0);
        for (unsigned each = 0; each < 8; ++each) {
            INFO("per pair: " << (each & 1u ? "h " : "") << (each & 2u ? "c " : "") << (each & 4u ? "rho" : ""));
            abi::PairBlock geometry = pairs.block(each);
            geometry.u_dot_r = nullptr;    // not there yet when the geometry is prepared
            std::vector<double> prepared(std::size_t(size * pairs.size()));
            viscosity.prepare(geometry, prepared.data());
            for (std::size_t k = 0; k < std::size_t(pairs.size()); ++k) {
                // Every motion of the set, with the geometry of pair k.
                std::vector<double> applied(pairs.u_dot_r.size()), direct;
                // as a row in one dimension: r = 1 and the other side at rest, so that u_ij . r_ij is u_i
                std::vector<double> u = pairs.u_dot_r;
                u.resize(2 * u.size(), 0.0);
                const abi::RowPairs row{.dimension = 1, .n = pairs.size(), .at = pairs.size(), .u = {u.data()}, .r = {1}};
                viscosity.row(row, prepared.data() + std::ptrdiff_t(k) * size, applied.data());
                for (const double& u_dot_r : pairs.u_dot_r) {
                    abi::PairBlock one = pairs.one(k, each);
                    one.u_dot_r = &u_dot_r;
                    direct.push_back(pressure(viscosity, one)[0]);
                }
                CHECK(relative_gap(applied, direct) <= 1e-13);
            }
        }
    });
}

TEST_CASE("a viscosity sees uniform and per-pair media alike in blocks of any length", "[viscosity]") {
    for_each_viscosity([](const abi::Viscosity& viscosity, bool) {
        for (int n = 1; n <= 40; ++n) {
            const Pairs pairs(n, unsigned(n));
            for (unsigned each = 0; each < 8; ++each) {
                INFO(n << " pairs, each with its own: " << (each & 1u ? "h " : "") << (each & 2u ? "c " : "")
                       << (each & 4u ? "rho" : ""));
                std::vector<double> Pi(std::size_t(n) + 8, untouched), alone;
                viscosity.pairs(pairs.block(each), Pi.data());
                CHECK(std::count(Pi.begin() + n, Pi.end(), untouched) == 8);
                Pi.resize(std::size_t(n));
                for (std::size_t k = 0; k < Pi.size(); ++k) alone.push_back(pressure(viscosity, pairs.one(k, each))[0]);
                CHECK(relative_gap(Pi, alone) <= 1e-13);
            }
        }
    });
}

TEST_CASE("a viscosity's slope is the limit of Pi over u.r for slow approach", "[viscosity]") {
    for_each_viscosity([](const abi::Viscosity& viscosity, bool) {
        const Pairs pairs(50);
        for (std::size_t k = 0; k < std::size_t(pairs.size()); ++k) {
            const auto chord = [&](double u_dot_r) {
                abi::PairBlock one = pairs.one(k, 7);
                one.u_dot_r = &u_dot_r;
                return pressure(viscosity, one)[0] / u_dot_r;
            };
            const double sonic = pairs.c[k] * std::sqrt(pairs.r2[k]), e = 1e-5 * sonic;
            const double limit = 2 * chord(-e / 2) - chord(-e);    // without the part linear in e
            abi::PairBlock one = pairs.one(k, 7);
            one.u_dot_r = nullptr;
            CHECK(viscosity.slope(one) == Approx(limit).epsilon(1e-6).margin(1e-7 * std::abs(chord(-0.1 * sonic))));
            CHECK(viscosity.slope(one) <= 0);
        }
    });
}

TEST_CASE("monaghan is the formula of Monaghan and Gingold", "[viscosity]") {
    const auto formula = [](double alpha, double beta, double u_dot_r, double r2, double h, double c, double rho) {
        if (u_dot_r >= 0) return 0.0;
        const double phi = h * u_dot_r / (r2 + (0.1 * h) * (0.1 * h));
        return (-alpha * c * phi + beta * phi * phi) / rho;
    };
    const Plugin& plugin = registry().find("viscosity", "monaghan", "contract");
    REQUIRE(plugin.parameters.size() == 2);
    REQUIRE(std::string(plugin.parameters[0].name) == "alpha");
    REQUIRE(std::string(plugin.parameters[1].name) == "beta");
    CHECK(plugin.parameters[0].initial.real == 0.06);
    CHECK(plugin.parameters[1].initial.real == 0.5);

    const Pairs pairs(100);
    for (const auto& [alpha, beta] : {std::pair{0.06, 0.5}, {0.06, 0.0}, {0.0, 0.5}, {1.0, 2.0}}) {
        auto values = usual(plugin);
        values[0].real = alpha;
        values[1].real = beta;
        const auto Pi = pressure(*registry().create<abi::Viscosity>(plugin, values), pairs.block(7));
        for (std::size_t k = 0; k < Pi.size(); ++k)
            CHECK(Pi[k] ==
                  Approx(formula(alpha, beta, pairs.u_dot_r[k], pairs.r2[k], pairs.h[k], pairs.c[k], pairs.rho[k]))
                      .epsilon(1e-13));
    }
}
