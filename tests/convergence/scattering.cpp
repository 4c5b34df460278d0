/// A plane wave on a circle.
#include "../support/scattering.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("sound scattered by a rigid circle of ten spacings' radius is right to three per cent at 21 points per wavelength", "[obstacle]") {
    const double coarse = Scattering{.k = 3, .n = 10}.error(), fine = Scattering{.k = 3, .n = 14}.error();
    INFO("10 spacings: " << coarse << ", 14: " << fine);
    CHECK(coarse < 0.03);
    CHECK(std::log(coarse / fine) / std::log(1.4) > 1);
}
