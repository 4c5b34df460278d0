#include "../support/jittered_box.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("corrected forms with dissipation converge with order two on disordered sets, by the known errors", "[convergence][dissipation]") {
    const double known[] = {0.109, 0.0287, 0.0069};    // of a prototype with other random displacements
    double last = 0;
    for (int i = 0; i < 3; ++i) {
        const int n = 24 << i;
        const double error = jittered_box_error(n, 0.2);
        INFO("n = " << n << ": " << error << ", before " << last);
        CHECK(error == Approx(known[i]).epsilon(0.1));
        if (i > 0) CHECK(std::log2(last / error) >= 1.9);
        last = error;
    }
}

TEST_CASE("corrected forms with dissipation of the usual strength converge with order two on disordered sets", "[convergence][dissipation]") {
    double last = 0;
    for (const int n : {24, 48, 96}) {
        const double error = jittered_box_error(n);
        INFO("n = " << n << ": " << error << ", before " << last);
        if (last > 0) CHECK(std::log2(last / error) >= 1.9);
        last = error;
    }
}

TEST_CASE("without dissipation the finer disordered box is lost at once", "[convergence][dissipation]") {
    const Summary s = run(repository_case("scenes/jittered_box", {"/dissipation/alpha=0", "/integrator/unstable=allow"}));
    CHECK(s.diverged);
    CHECK(s.t * 340 < 2);    // passages
}
