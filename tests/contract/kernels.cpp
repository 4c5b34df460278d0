/// Laws that hold for every kernel found, in every dimension that it claims.
#include <limits>

#include "quadrature.hpp"
#include "subjects.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

/// Runs a law over all kernels and the dimensions that they claim.
template <class Law>
void for_each_kernel(Law&& law) {
    for (const auto& subject : subjects<abi::Kernel>())
        for (int d = 1; d <= 3; ++d) {
            INFO(subject.label << " in " << d << "-D");
            if (subject.object->defined(d)) law(*subject.object, d);
        }
}

/// n distances strictly inside the support, evenly spread but on no round multiple of h.
std::vector<double> inside(const abi::Kernel& kernel, double h, int n) {
    auto r = std::vector<double>(std::size_t(n));
    for (int k = 0; k < n; ++k) r[std::size_t(k)] = (k + 0.37) / n * kernel.support() * h;
    return r;
}

std::vector<double> values(const abi::Kernel& kernel, int d, const std::vector<double>& r, double h) {
    std::vector<double> W(r.size());
    kernel.evaluate(d, int(r.size()), r.data(), h, W.data(), nullptr);
    return W;
}

/// dW/dr, which unlike dW_over_r is no quotient of small numbers near r = 0.
std::vector<double> slopes(const abi::Kernel& kernel, int d, const std::vector<double>& r, double h) {
    std::vector<double> dW(r.size());
    kernel.evaluate(d, int(r.size()), r.data(), h, nullptr, dW.data());
    for (std::size_t k = 0; k < r.size(); ++k) dW[k] *= r[k];
    return dW;
}

std::vector<double> shifted(std::vector<double> r, double by) {
    for (double& x : r) x += by;
    return r;
}

std::vector<double> scaled(std::vector<double> r, double by) {
    for (double& x : r) x *= by;
    return r;
}

}    // namespace

TEST_CASE("a kernel claims one dimension at least and none but one to three", "[kernel]") {
    for (const auto& subject : subjects<abi::Kernel>()) {
        INFO(subject.label);
        const abi::Kernel& kernel = *subject.object;
        CHECK((kernel.defined(1) || kernel.defined(2) || kernel.defined(3)));
        CHECK_FALSE(kernel.defined(0));
        CHECK_FALSE(kernel.defined(4));
        CHECK(kernel.support() > 0);
        CHECK(std::isfinite(kernel.support()));
    }
}

TEST_CASE("a kernel integrates to one in every dimension it claims but for the defect it declares", "[kernel]") {
    for_each_kernel([](const abi::Kernel& kernel, int d) {
        const double defect = kernel.properties().mass_defect[d];
        CHECK(std::abs(defect) < 1);
        for (const double h : {1.0, 0.13}) CHECK(mass(kernel, d, h) == Approx(1 - defect).epsilon(0).margin(1e-8));
    });
}

TEST_CASE("a kernel's dW_over_r times r is the derivative of W", "[kernel]") {
    for_each_kernel([](const abi::Kernel& kernel, int d) {
        const double h = 0.13, e = 1e-5 * h;
        const auto r = inside(kernel, h, 200);
        const auto after = values(kernel, d, shifted(r, e), h), before = values(kernel, d, shifted(r, -e), h);
        std::vector<double> difference;
        for (std::size_t k = 0; k < r.size(); ++k) difference.push_back((after[k] - before[k]) / (2 * e));
        CHECK(gap(slopes(kernel, d, r, h), difference) <= 1e-8 * largest(after) / h);
    });
}

TEST_CASE("a kernel and its slope vanish at and beyond the support", "[kernel]") {
    for_each_kernel([](const abi::Kernel& kernel, int d) {
        for (const double h : {0.021, 0.042, 0.13, 1.0}) {    // r / h of the first two rounds to below the support
            const double edge = kernel.support() * h;
            const std::vector<double> r{edge, edge * (1 + 1e-15), 1.5 * edge, 10 * edge, 1e6 * edge};
            CHECK(largest(values(kernel, d, r, h)) == 0);
            CHECK(largest(slopes(kernel, d, r, h)) == 0);
        }
    });
}

TEST_CASE("a kernel is finite and its dW_over_r is zero at r = 0", "[kernel]") {
    for_each_kernel([](const abi::Kernel& kernel, int d) {
        const double r = 0;
        double W = -1, dW_over_r = -1;
        kernel.evaluate(d, 1, &r, 0.13, &W, &dW_over_r);
        CHECK(std::isfinite(W));
        CHECK(dW_over_r == 0);
    });
}

TEST_CASE("a kernel scales with h to the power of minus d", "[kernel]") {
    for_each_kernel([](const abi::Kernel& kernel, int d) {
        const auto q = inside(kernel, 1, 100);
        const auto w = values(kernel, d, q, 1), dw = slopes(kernel, d, q, 1);
        for (const double h : {0.018, 0.13, 3.7}) {
            const auto r = scaled(q, h);
            CHECK(gap(scaled(values(kernel, d, r, h), std::pow(h, d)), w) <= 1e-13 * largest(w));
            CHECK(gap(scaled(slopes(kernel, d, r, h), std::pow(h, d + 1)), dw) <= 1e-13 * largest(dw));
        }
    });
}

TEST_CASE("a kernel gives the same values when either output is null", "[kernel]") {
    for_each_kernel([](const abi::Kernel& kernel, int d) {
        const auto r = inside(kernel, 0.13, 37);
        std::vector<double> W(r.size()), dW(r.size());
        kernel.evaluate(d, int(r.size()), r.data(), 0.13, W.data(), dW.data());
        for (std::size_t k = 0; k < r.size(); ++k) dW[k] *= r[k];
        CHECK(gap(values(kernel, d, r, 0.13), W) <= 1e-14 * largest(W));
        CHECK(gap(slopes(kernel, d, r, 0.13), dW) <= 1e-14 * largest(dW));
        kernel.evaluate(d, int(r.size()), r.data(), 0.13, nullptr, nullptr);
    });
}

TEST_CASE("a kernel evaluates a block of any length as it does each distance and writes no further", "[kernel]") {
    for_each_kernel([](const abi::Kernel& kernel, int d) {
        const double h = 0.13;
        for (int n = 1; n <= 40; ++n) {
            auto r = inside(kernel, 1.2 * h, n);    // the last sixth lies beyond the support
            std::reverse(r.begin(), r.end());
            if (n > 2) r[std::size_t(n) / 2] = 0;
            std::vector<double> W(r.size() + 8, untouched), dW = W, W_each(r.size()), dW_each(r.size());
            kernel.evaluate(d, n, r.data(), h, W.data(), dW.data());
            CHECK(std::count(W.begin() + n, W.end(), untouched) == 8);
            CHECK(std::count(dW.begin() + n, dW.end(), untouched) == 8);
            W.resize(r.size());
            dW.resize(r.size());
            for (std::size_t k = 0; k < r.size(); ++k) {
                kernel.evaluate(d, 1, &r[k], h, &W_each[k], &dW_each[k]);
                dW[k] *= r[k];
                dW_each[k] *= r[k];
            }
            CHECK(gap(W, W_each) <= 1e-14 * largest(W_each));
            CHECK(gap(dW, dW_each) <= 1e-14 * largest(dW_each));
        }
    });
}

TEST_CASE("a kernel that declares itself non-negative or monotone is", "[kernel]") {
    for_each_kernel([](const abi::Kernel& kernel, int d) {
        const auto r = inside(kernel, 1, 2000);
        const auto W = values(kernel, d, r, 1), dW = slopes(kernel, d, r, 1);
        if (kernel.properties().non_negative) CHECK(*std::min_element(W.begin(), W.end()) >= -1e-14 * largest(W));
        if (kernel.properties().monotone) CHECK(*std::max_element(dW.begin(), dW.end()) <= 1e-14 * largest(dW));
    });
}

TEST_CASE("a kernel that declares itself positive definite has no negative Fourier component", "[kernel]") {
    for_each_kernel([](const abi::Kernel& kernel, int d) {
        if (!kernel.properties().positive_definite) return;
        double least = std::numeric_limits<double>::infinity();
        for (double k = 0.25; k <= 40; k += 0.25) least = std::min(least, transform(kernel, d, k));
        CHECK(least >= -1e-10);
    });
}
