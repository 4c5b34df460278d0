/// Scattering by rigid and soft circles, at 20 points per wavelength and ten spacings to the radius or more.
#include "../support/scattering.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("scattering by a circle is right to three per cent and converges at first order or better", "[obstacle]") {
    for (const bool soft : {false, true})
        for (const double k : {1.0, 3.0, 5.0}) {
            Scattering s{.k = k, .n = std::max(10, int(std::ceil(20 * k / (2 * pi)))), .soft = soft,
                         .kernel = R"({"type":"super_gaussian","h_over_dx":1.3})", .courant = 0.9, .steady = k < 1.5 ? 20.0 : 9.5};
            const double coarse = s.error();
            const int n = s.n;
            s.n += 2 * s.n / 5;
            const double fine = s.error(), order = std::log(coarse / fine) / std::log(double(s.n) / n);
            WARN((soft ? "soft" : "rigid") << ", ka = " << k << ": " << coarse << " at " << n << " spacings, " << fine << " at " << s.n << ", order " << order);
            CHECK(coarse < 0.03);
            CHECK(order > 1);
        }
}
