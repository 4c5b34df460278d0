#include "kernel_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sphonic {
namespace {

constexpr double pi = std::numbers::pi;

/// W and (dW/dr)/r of a kernel with h = 1, at the middles of cells from 0 to its support.
struct Samples {
    static constexpr int cells = 4000;
    std::vector<double> r, W, slope_over_r;
    double cell;

    Samples(const abi::Kernel& kernel, int d) : r(cells), W(cells), slope_over_r(cells), cell(kernel.support() / cells) {
        for (int i = 0; i < cells; ++i) r[std::size_t(i)] = (i + 0.5) * cell;
        kernel.evaluate(d, cells, r.data(), 1, W.data(), slope_over_r.data());
    }
    /// Integral over space of W g(r), by the midpoint rule.
    template <class G>
    double integral(int d, G g) const {
        double sum = 0;
        for (std::size_t i = 0; i < r.size(); ++i) sum += W[i] * g(r[i]) * (d == 1 ? 2 : d == 2 ? 2 * pi * r[i] : 4 * pi * r[i] * r[i]);
        return sum * cell;
    }
};

}    // namespace

std::vector<KernelLaw> kernel_laws(const abi::Kernel& kernel) {
    std::vector<KernelLaw> laws;
    for (int d = 1; d <= 3; ++d) {
        if (!kernel.defined(d)) continue;
        const Samples s(kernel, d);
        const double defect = s.integral(d, [](double) { return 1.0; }) - 1, claimed = kernel.properties().mass_defect[d];
        laws.push_back({"integrates to one", d, defect, std::abs(defect + claimed) < 1e-5});
        const double step = std::abs(s.W.back() / s.W.front());
        laws.push_back({"vanishes at its support", d, step, step < 1e-3});
        const double lowest = *std::min_element(s.W.begin(), s.W.end()) / s.W.front();
        laws.push_back({"is nowhere negative", d, std::min(lowest, 0.0), lowest >= 0});
        const double rise = *std::max_element(s.slope_over_r.begin(), s.slope_over_r.end()) / s.W.front();
        laws.push_back({"falls with distance", d, std::max(rise, 0.0), rise <= 0});
        double worst = 0;
        for (std::size_t i = 1; i + 1 < s.r.size(); ++i)
            worst = std::max(worst, std::abs((s.W[i + 1] - s.W[i - 1]) / (2 * s.cell) - s.slope_over_r[i] * s.r[i]) / s.W.front());
        laws.push_back({"has the slope that it gives", d, worst, worst < 1e-4});
    }
    return laws;
}

KernelTransform kernel_transform(const abi::Kernel& kernel, int d) {
    constexpr double farthest = 16;
    constexpr int points = 321;
    const Samples s(kernel, d);
    const double mass = s.integral(d, [](double) { return 1.0; });
    KernelTransform t{.dimension = d, .kh = {}, .value = {}};
    for (int i = 0; i < points; ++i) {
        const double k = farthest * i / (points - 1);
        const auto wave = [&](double r) { return d == 1 ? std::cos(k * r) : d == 2 ? std::cyl_bessel_j(0., k * r) : k * r > 0 ? std::sin(k * r) / (k * r) : 1; };
        t.kh.push_back(k);
        t.value.push_back(s.integral(d, wave) / mass);
    }
    const double least = *std::min_element(t.value.begin(), t.value.end());
    t.least = least < -1e-6 ? least : 0;    // below is the midpoint rule's error
    return t;
}

}    // namespace sphonic
