#include <cmath>
#include <random>

#include "particle_system.hpp"

namespace sphonic {

double ParticleSystem::largest_frequency(int iterations) {
    const abi::Slot rates = store_.history("core: rate");
    Part& all = part(abi::fields);
    const int pressure = components_.first[std::size_t(evolved_behind(scene_.equations.find("p")))];
    const double impedance = scene_.medium.rho0 * scene_.medium.c0;
    std::mt19937_64 bits(1);
    const auto for_values = [&](auto visit) {
        for (const int c : all.components) {
            double *z = store_.array(abi::state, c), *r = store_.array(rates, c);
            for (long i = 0; i < particles(); ++i) visit(z[i], r[i], c == pressure ? 1 / impedance : 1.0);
        }
    };
    const auto normalise = [&] {
        double sum = 0;
        for_values([&](double& z, double&, double weight) { sum += weight * weight * z * z; });
        const double norm = std::sqrt(sum);
        for_values([&](double& z, double&, double) { z /= norm; });
        return norm;
    };
    for_values([&](double& z, double&, double weight) { z = (double(bits() >> 11) * 0x1p-53 - 0.5) / weight; });
    normalise();
    double squared = 0;
    for (int k = 0; k < iterations; ++k) {
        for (int twice = 0; twice < 2; ++twice) {
            refresh_algebraic(all, 0);
            evaluate_terms(all, rates, 1, true);
            for_values([](double& z, double& r, double) { z = r; });
        }
        squared = normalise();
    }
    for_values([](double& z, double& r, double) { z = r = 0; });
    return std::sqrt(squared);
}

}    // namespace sphonic
