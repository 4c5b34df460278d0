/// Laws that hold for every dissipation found.
#include <random>

#include <sphonic/parameters.hpp>
#include <sphonic/plugin/abi/dissipation.hpp>
#include <sphonic/plugin/abi/kernel.hpp>

#include "subjects.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

/// n pairs in the plane at distances from nearly touching to beyond the support of a cubic spline, with a medium and a volume each.
struct Pairs {
    double h = 0.13;
    std::vector<double> r2, slope, c, volume;

    explicit Pairs(int n, unsigned seed = 1) {
        std::mt19937 engine(seed);
        std::uniform_real_distribution<double> unit(0, 1);
        std::vector<double> r;
        for (int k = 0; k < n; ++k) {
            r.push_back(h * (0.01 + 3 * unit(engine)));
            r2.push_back(r.back() * r.back());
            c.push_back(340 * (0.7 + 0.6 * unit(engine)));
            volume.push_back(0.01 * (0.7 + 0.6 * unit(engine)));
        }
        slope.resize(r.size());
        make<abi::Kernel>("cubic_spline")->evaluate(2, n, r.data(), h, nullptr, slope.data());
    }

    /// Bits of `each` say which of c and the volume go in per pair; the others are those of pair `of`.
    abi::DampedPairs block(unsigned each, std::size_t of = 0) const {
        return {.n = int(r2.size()), .r2 = r2.data(), .slope = slope.data(), .h = h, .c = c[of], .volume = volume[of],
                .c_each = each & 1u ? c.data() : nullptr, .volume_each = each & 2u ? volume.data() : nullptr};
    }
    /// Pair k alone.
    abi::DampedPairs one(std::size_t k, unsigned each) const {
        return {.n = 1, .r2 = &r2[k], .slope = &slope[k], .h = h, .c = c[each & 1u ? k : 0], .volume = volume[each & 2u ? k : 0]};
    }
};

std::vector<double> couplings(const abi::Dissipation& dissipation, const abi::DampedPairs& pairs) {
    std::vector<double> a(std::size_t(pairs.n));
    dissipation.couple(pairs, a.data());
    return a;
}

template <class Law>
void for_each_dissipation(Law&& law) {
    for (const auto& subject : subjects<abi::Dissipation>()) {
        INFO(subject.label);
        law(*subject.object);
    }
}

}    // namespace

TEST_CASE("a dissipation couples pairs by what is not negative and ends with the support", "[dissipation]") {
    for_each_dissipation([](const abi::Dissipation& dissipation) {
        const Pairs pairs(500);
        const auto a = couplings(dissipation, pairs.block(3));
        double least = infinite, beyond = 0, within = 0;
        for (std::size_t k = 0; k < a.size(); ++k) {
            least = std::min(least, a[k]);
            (pairs.slope[k] == 0 ? beyond : within) += std::abs(a[k]);
        }
        CHECK(least >= 0);
        CHECK(beyond == 0);
        CHECK(within > 0);
        CHECK(std::isfinite(within));
    });
}

TEST_CASE("a dissipation is in proportion to the sound speed", "[dissipation]") {
    for_each_dissipation([](const abi::Dissipation& dissipation) {
        const Pairs pairs(100);
        abi::DampedPairs faster = pairs.block(0);
        faster.c *= 3;
        const auto a = couplings(dissipation, pairs.block(0)), b = couplings(dissipation, faster);
        for (std::size_t k = 0; k < a.size(); ++k) CHECK(b[k] == Approx(3 * a[k]).epsilon(1e-13));
    });
}

TEST_CASE("a dissipation sees uniform and per-pair values alike in blocks of any length", "[dissipation]") {
    for_each_dissipation([](const abi::Dissipation& dissipation) {
        for (int n = 1; n <= 40; ++n) {
            const Pairs pairs(n, unsigned(n));
            for (unsigned each = 0; each < 4; ++each) {
                INFO(n << " pairs, each with its own: " << (each & 1u ? "c " : "") << (each & 2u ? "volume" : ""));
                std::vector<double> a(std::size_t(n) + 8, untouched);
                dissipation.couple(pairs.block(each), a.data());
                CHECK(std::count(a.begin() + n, a.end(), untouched) == 8);
                for (std::size_t k = 0; k < std::size_t(n); ++k)
                    CHECK(a[k] == Approx(couplings(dissipation, pairs.one(k, each))[0]).epsilon(1e-13));
            }
        }
    });
}

TEST_CASE("a dissipation's usual strength grows with the disorder and is one that a case may give", "[dissipation]") {
    const abi::ParameterInfo& alpha = common_key("dissipation", "alpha");
    for_each_dissipation([&](const abi::Dissipation& dissipation) {
        double last = -infinite;
        for (const double disorder : {0.0, 0.01, 0.05, 0.1, 0.2, 0.5, 1.0, 10.0}) {
            const double strength = dissipation.strength(disorder);
            CHECK(strength >= std::max(last, alpha.lower));
            CHECK(strength <= alpha.upper);
            last = strength;
        }
        CHECK(last > 0);
    });
}

TEST_CASE("fourth_order couples by c V |dW/dr|", "[dissipation]") {
    const Pairs pairs(100);
    const auto a = couplings(*make<abi::Dissipation>("fourth_order"), pairs.block(3));
    for (std::size_t k = 0; k < a.size(); ++k)
        CHECK(a[k] == Approx(pairs.c[k] * pairs.volume[k] * std::abs(pairs.slope[k]) * std::sqrt(pairs.r2[k])).epsilon(1e-13));
}
