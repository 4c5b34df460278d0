/// Constants and facts of the literature for the kernels that come with sphonic.
#include "quadrature.hpp"
#include "subjects.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

double at_zero(const abi::Kernel& kernel, int d) {
    const double r = 0;
    double W = 0;
    kernel.evaluate(d, 1, &r, 1, &W, nullptr);
    return W;
}

std::unique_ptr<abi::Kernel> gaussian(double cutoff, bool renormalise) {
    const Plugin& plugin = registry().find("kernel", "gaussian", "contract");
    auto values = usual(plugin);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string name = plugin.parameters[i].name;
        if (name == "cutoff") values[i].real = cutoff;
        if (name == "renormalise") values[i].boolean = renormalise;
    }
    return registry().create<abi::Kernel>(plugin, values);
}

}    // namespace

TEST_CASE("kernels carry their published constants in one two and three dimensions", "[kernel]") {
    struct Published {
        const char* name;
        double w0;          // w(0)
        double sigma[3];    // 1-D, 2-D, 3-D
    };
    const Published table[] = {
        {"gaussian", 1, {1 / std::sqrt(pi), 1 / pi, 1 / (pi * std::sqrt(pi))}},
        {"cubic_spline", 2. / 3, {1, 15 / (7 * pi), 3 / (2 * pi)}},
        {"quintic_spline", 66, {1. / 120, 7 / (478 * pi), 1 / (120 * pi)}},
    };
    for (const auto& [name, w0, sigma] : table) {
        const auto kernel = make<abi::Kernel>(name);
        for (int d = 1; d <= 3; ++d) {
            INFO(name << " in " << d << "-D");
            CHECK(at_zero(*kernel, d) == Approx(sigma[d - 1] * w0).epsilon(1e-14));
        }
    }
}

TEST_CASE("the quintic spline's printed 3-D constant would integrate to 1.002786", "[kernel]") {
    const auto quintic = make<abi::Kernel>("quintic_spline");
    const double printed = 66 * 3 / (359 * pi), ours = at_zero(*quintic, 3);
    CHECK(mass(*quintic, 3, 1) == Approx(1).margin(1e-10));
    CHECK(mass(*quintic, 3, 1) * printed / ours == Approx(1.002786).margin(5e-7));
}

TEST_CASE("the Gaussian cut at 3h misses the mass it declares and renormalise restores it", "[kernel]") {
    const double published[] = {0.999978, 0.999877, 0.999560};
    const auto cut = gaussian(3, false), restored = gaussian(3, true);
    for (int d = 1; d <= 3; ++d) {
        INFO(d << "-D");
        CHECK(mass(*cut, d, 1) == Approx(published[d - 1]).margin(5e-7));
        CHECK(cut->properties().mass_defect[d] == Approx(1 - published[d - 1]).margin(5e-7));
        CHECK(mass(*restored, d, 1) == Approx(1).margin(1e-10));
        CHECK(restored->properties().mass_defect[d] == 0);
    }
}

TEST_CASE("the cubic spline's transform is sinc to the fourth in 1-D and changes sign in 2-D and 3-D", "[kernel]") {
    const auto cubic = make<abi::Kernel>("cubic_spline");
    double least[4] = {1, 1, 1, 1};
    for (double k = 0.25; k <= 40; k += 0.25) {
        const double sinc = std::sin(k / 2) / (k / 2);
        CHECK(transform(*cubic, 1, k) == Approx(std::pow(sinc, 4)).margin(1e-10));
        for (int d = 1; d <= 3; ++d) least[d] = std::min(least[d], transform(*cubic, d, k));
    }
    CHECK(least[1] >= -1e-10);
    CHECK(least[2] < -1e-4);
    CHECK(least[3] < -1e-4);
}
