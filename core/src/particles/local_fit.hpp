#pragma once
#include <array>
#include <vector>

namespace sphonic {

/// Weighted least squares of up to four functions to values at points, as weights of those values.
class LocalFit {
public:
    static constexpr std::size_t most = 4;
    using Basis = std::array<double, most>;

    /// The first of the functions is fitted alone where the points do not tell them apart.
    explicit LocalFit(int functions) : n_(std::size_t(functions)) {}

    void add(const Basis& functions, double weight) { points_.push_back({functions, weight}); }
    /// w with sum_k w_k f_k = the fit, where the functions are `at`. All zero if no point counts.
    std::vector<double> weights(const Basis& at) const;

    /// Weight of a point at distance q from the middle, in radii: Wendland's function, (1 - q)^4 (1 + 4 q), zero beyond one.
    static double closeness(double q) {
        const double rest = q < 1 ? 1 - q : 0;
        return rest * rest * rest * rest * (1 + 4 * q);
    }

private:
    struct Point {
        Basis functions;
        double weight;
    };
    std::size_t n_;
    std::vector<Point> points_;

    Basis solved(const Basis& at) const;
};

}    // namespace sphonic
