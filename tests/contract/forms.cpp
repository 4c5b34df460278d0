/// Laws of the forms of a gradient and a divergence:
///   (grad f)_i = sum_j V_j (own_ij f_i + other_ij f_j) grad_i W_ij,  the same with a dot product for a divergence.
/// With m_i du_i/dt = -V_i (grad p)_i the force of j on i is
///   F_ij = -V_i V_j (own_ij p_i + other_ij p_j) grad_i W_ij,  and  grad_j W_ij = -grad_i W_ij,
/// so that F_ij = -F_ji for every pressure exactly if own(rho_i, rho_j) = other(rho_j, rho_i).
#include <array>
#include <random>

#include <sphonic/plugin/abi/form.hpp>
#include <sphonic/plugin/abi/kernel.hpp>

#include "subjects.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

struct Coefficients {
    std::vector<double> own, other;
};

Coefficients coefficients(const abi::Form& form, const std::vector<double>& rho_i, const std::vector<double>& rho_j,
                          abi::Derivative derivative = abi::Derivative::gradient) {
    Coefficients c{std::vector<double>(rho_i.size()), std::vector<double>(rho_i.size())};
    std::vector<double> inverse_i, inverse_j;
    for (const double rho : rho_i) inverse_i.push_back(1 / rho);
    for (const double rho : rho_j) inverse_j.push_back(1 / rho);
    form.coefficients(derivative, {int(rho_i.size()), rho_i.data(), rho_j.data(), inverse_i.data(), inverse_j.data(), rho_i.data(), rho_j.data()},
                      c.own.data(), c.other.data());    // c = 1: impedances are densities
    return c;
}

std::vector<double> random_values(int n, double lower, double upper, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> any(lower, upper);
    auto values = std::vector<double>(std::size_t(n));
    for (double& value : values) value = any(engine);
    return values;
}

using Field = std::vector<double>;
using VectorField = std::array<std::vector<double>, 2>;

/// Particles thrown at random into the unit square, of random masses and densities, with all pairs within reach.
struct Cloud {
    static constexpr int n = 300;
    VectorField x{random_values(n, 0, 1, 1), random_values(n, 0, 1, 2)};
    Field m = random_values(n, 0.5, 2, 3), rho = random_values(n, 0.5, 2, 4);

    struct Pair {
        std::size_t i, j;
        double gradient[2];    // grad_i W_ij
    };
    std::vector<Pair> pairs;    // both (i, j) and (j, i)

    Cloud() {
        const auto kernel = make<abi::Kernel>("cubic_spline");
        const double h = 0.08;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                const double a = x[0][i] - x[0][j], b = x[1][i] - x[1][j], r = std::hypot(a, b);
                if (i == j || r >= kernel->support() * h) continue;
                double dW_over_r = 0;
                kernel->evaluate(2, 1, &r, h, nullptr, &dW_over_r);
                pairs.push_back({i, j, {dW_over_r * a, dW_over_r * b}});
            }
    }
    double volume(std::size_t i) const { return m[i] / rho[i]; }

    Coefficients of_pairs(const abi::Form& form) const {
        Field rho_i, rho_j;
        for (const Pair& pair : pairs) {
            rho_i.push_back(rho[pair.i]);
            rho_j.push_back(rho[pair.j]);
        }
        return coefficients(form, rho_i, rho_j);
    }
    VectorField gradient(const abi::Form& form, const Field& f) const {
        const auto [own, other] = of_pairs(form);
        VectorField out{Field(n), Field(n)};
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const auto& [i, j, g] = pairs[k];
            for (std::size_t a = 0; a < 2; ++a) out[a][i] += volume(j) * (own[k] * f[i] + other[k] * f[j]) * g[a];
        }
        return out;
    }
    Field divergence(const abi::Form& form, const VectorField& u) const {
        const auto [own, other] = of_pairs(form);
        Field out(n);
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const auto& [i, j, g] = pairs[k];
            for (std::size_t a = 0; a < 2; ++a) out[i] += volume(j) * (own[k] * u[a][i] + other[k] * u[a][j]) * g[a];
        }
        return out;
    }
    /// sum V_i p_i (div u)_i + sum V_i u_i . (grad p)_i, over the size of its terms: zero for an adjoint pair.
    double adjoint_gap(const abi::Form& of_divergence, const abi::Form& of_gradient) const {
        const Field p = random_values(n, -1, 1, 5);
        const VectorField u{random_values(n, -1, 1, 6), random_values(n, -1, 1, 7)};
        const Field div = divergence(of_divergence, u);
        const VectorField grad = gradient(of_gradient, p);
        double sum = 0, size = 0;
        for (std::size_t i = 0; i < n; ++i)
            for (const double term : {p[i] * div[i], u[0][i] * grad[0][i], u[1][i] * grad[1][i]}) {
                sum += volume(i) * term;
                size += volume(i) * std::abs(term);
            }
        return std::abs(sum) / size;
    }
};

}    // namespace

TEST_CASE("a form takes the neighbour's value whole where densities are equal", "[form]") {
    const Field rho = random_values(40, 0.1, 2000, 1);
    for (const auto& subject : subjects<abi::Form>()) {
        INFO(subject.label);
        CHECK(gap(coefficients(*subject.object, rho, rho).other, Field(rho.size(), 1)) <= 1e-14);
    }
}

TEST_CASE("a form that calls itself uniform does not look at densities", "[form]") {
    const Field rho_i = random_values(40, 0.1, 2000, 1), rho_j = random_values(40, 0.1, 2000, 2);
    for (const auto& subject : subjects<abi::Form>()) {
        INFO(subject.label);
        if (!subject.object->uniform()) continue;
        const auto [own, other] = coefficients(*subject.object, rho_i, rho_j);
        CHECK(gap(own, Field(own.size(), own[0])) == 0);
        CHECK(gap(other, Field(other.size(), other[0])) == 0);
    }
}

TEST_CASE("a form weighs a block of any length as it does each pair", "[form]") {
    for (const auto& subject : subjects<abi::Form>())
        for (int n = 1; n <= 40; ++n) {
            INFO(subject.label << ", " << n << " pairs");
            const Field rho_i = random_values(n, 0.5, 2, 1), rho_j = random_values(n, 0.5, 2, 2);
            const auto [own, other] = coefficients(*subject.object, rho_i, rho_j);
            for (std::size_t k = 0; k < own.size(); ++k) {
                const auto alone = coefficients(*subject.object, {rho_i[k]}, {rho_j[k]});
                CHECK(own[k] == Approx(alone.own[0]).epsilon(1e-14));
                CHECK(other[k] == Approx(alone.other[0]).epsilon(1e-14));
            }
        }
}

TEST_CASE("the difference gradient of a constant vanishes for arbitrary neighbours", "[form]") {
    const Cloud cloud;
    const Field constant(Cloud::n, 101325);
    const VectorField of_difference = cloud.gradient(*make<abi::Form>("difference"), constant);
    CHECK(largest(of_difference[0]) == 0);
    CHECK(largest(of_difference[1]) == 0);
    // On such a cloud that is a property of the form: the sum does not have it.
    CHECK(largest(cloud.gradient(*make<abi::Form>("sum"), constant)[0]) > 101325);
}

TEST_CASE("sum and symmetric gradients give equal and opposite pair forces for arbitrary densities", "[form]") {
    const Cloud cloud;
    const Field p = random_values(Cloud::n, -1, 1, 5);
    for (const char* name : {"sum", "symmetric"}) {
        INFO(name);
        const auto form = make<abi::Form>(name);
        const auto [own, other] = cloud.of_pairs(*form);
        Field opposed, forces;
        for (std::size_t k = 0; k < cloud.pairs.size(); ++k) {
            const auto& [i, j, g] = cloud.pairs[k];
            const auto back = coefficients(*form, {cloud.rho[j]}, {cloud.rho[i]});
            const double of_volumes = cloud.volume(i) * cloud.volume(j);
            forces.push_back(-of_volumes * (own[k] * p[i] + other[k] * p[j]) * g[0]);
            opposed.push_back(-of_volumes * (back.own[0] * p[j] + back.other[0] * p[i]) * g[0]);
        }
        CHECK(gap(forces, opposed) <= 1e-14 * largest(forces));

        const VectorField gradient = cloud.gradient(*form, p);
        for (const Field& component : gradient) {
            double total = 0, size = 0;
            for (std::size_t i = 0; i < Cloud::n; ++i) {
                total += cloud.volume(i) * component[i];
                size += std::abs(cloud.volume(i) * component[i]);
            }
            CHECK(std::abs(total) <= 1e-13 * size);
        }
    }
}

TEST_CASE("the symmetric form weighs with masses as p over rho squared does", "[form]") {
    const Field rho_i = random_values(100, 0.5, 2, 1), rho_j = random_values(100, 0.5, 2, 2);
    const auto [own, other] = coefficients(*make<abi::Form>("symmetric"), rho_i, rho_j);
    for (std::size_t k = 0; k < own.size(); ++k) {
        // V_j own = rho_i m_j / rho_i^2,  V_j other = rho_i m_j / rho_j^2,  with V_j = m_j / rho_j
        CHECK(own[k] / rho_j[k] == Approx(rho_i[k] / (rho_i[k] * rho_i[k])).epsilon(1e-14));
        CHECK(other[k] / rho_j[k] == Approx(rho_i[k] / (rho_j[k] * rho_j[k])).epsilon(1e-14));
    }
}

TEST_CASE("the difference divergence is minus the adjoint of the sum gradient on any arrangement", "[form]") {
    const Cloud cloud;
    const auto difference = make<abi::Form>("difference"), sum = make<abi::Form>("sum");
    CHECK(cloud.adjoint_gap(*difference, *sum) <= 1e-13);
    CHECK(cloud.adjoint_gap(*sum, *difference) <= 1e-13);
    CHECK(cloud.adjoint_gap(*difference, *difference) > 1e-3);
}
