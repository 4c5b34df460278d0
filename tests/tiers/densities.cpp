#include "sound.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

/// Equations in current densities; the gradient in so many equal parts. Two parts take the general way through the pairs.
std::string equations(const std::string& form, int parts) {
    std::string gradient;
    for (int i = 0; i < parts; ++i)
        gradient += (i ? "," : "") + std::string(R"({"gradient":"p","form":")") + form + R"(","times":"-)" + (parts == 2 ? "0.5/rho" : "1/rho") + R"("})";
    return R"(/equations={"drho":[{"divergence":"u","form":"difference","times":"-rho"}],"rho":{"state":"total_density","of":"drho"},
               "p":{"state":"acoustic","of":"drho"},"u":[)" + gradient + "]}";
}

}    // namespace

TEST_CASE("pairs in current densities, fused and term by term, are the same", "[tiers]") {
    for (const int d : {1, 2, 3})
        for (const char* form : {"sum", "symmetric", "difference", "impedance"})
            for (const char* boundary : {"periodic", "rigid"})
                for (const char* integrator : {"symplectic_euler", "leapfrog_li2015"}) {
                    std::vector<std::string> set{std::string(R"(/boundaries=[{"type":")") + boundary + R"(","face":"all"}])", "/kernel/h_over_dx=1.3", viscosity,
                                                 "/particles/motion=lagrangian", "/particles/jitter=0.1", std::string("/integrator/type=") + integrator,
                                                 "/initial/u=[" + std::string(d == 1 ? "\"0.3*sin(2*pi*x)\"]" : d == 2 ? "\"0.3*sin(2*pi*x)\",\"0.1*cos(2*pi*x)\"]"
                                                                                                                       : "\"0.3*sin(2*pi*x)\",\"0.1*cos(2*pi*x)\",\"0\"]"),
                                                 d == 3 ? "/until=0.06" : "/until=0.2"};
                    const int n = d == 3 ? 11 : 21;
                    set.push_back(equations(form, 1));
                    const Profile fused = final_state(d, n, set);
                    set.back() = equations(form, 2);
                    const Profile apart = final_state(d, n, set);
                    INFO(d << "-D, " << form << ", " << boundary << ", " << integrator);
                    CHECK(largest_difference(fused, apart) < 1e-11);
                    CHECK(*std::max_element(fused.p.begin(), fused.p.end()) > 0.02);
                }
}
