#pragma once
#include <array>
#include <cmath>
#include <vector>

#include <sphonic/plugin/form.hpp>

#include "band_averages.hpp"
#include "cholesky.hpp"

namespace sphonic::band {

/// Weights on a cloud. For particle i at the origin, with o_j = (x_j - x_i)/dx, and <.> the mean over the plane waves exp(i k . o) of
/// the band, uniform in wave-number space:
///   gradient   minimises  < |sum_j w_j (exp(i k . o_j) - 1) - i F(|k|) k_a/|k||^2 > + eps |w|^2    for each axis a,
///   residual   f_i - sum_j z_j f_j, sum_j z_j = 1, minimises the same with the target 0: about zero for the band, zero for a constant.
/// Both have the matrix
///   M_jl = K(|o_j - o_l|) - K(|o_j|) - K(|o_l|) + 1,    K(r) = < cos k . o >,
/// so that one factorisation serves all. Damping is by the residual, and by a little of a Laplacian L_ij = L_ji,
///   d_ij = sigma [z_j + delta L(|o_j|)],    L(r) = 8 (2/pi)^(d/2) exp(-2 r^2),    sum_j L (f_j - f_i) = dx^2 lap f about,
/// which outweighs what the residual makes of the band: it is not symmetric, and alone lets modes within the band grow
/// by some 1e-5 c0/dx.
class CloudBand final : public abi::CloudFit {
public:
    CloudBand(int dimension, double courant, double points_per_wavelength, double support, double damping)
        : dimension_(dimension), damping_(damping * usual_damping[dimension]), laplacian_(8 * std::pow(2 / pi, 0.5 * dimension)),
          averages_(dimension, beyond * 2 * pi / points_per_wavelength, courant, 2 * support) {}

    bool fit(const abi::CloudNeighbours& neighbours, const abi::CloudWeights& weights) const override {
        const int n = neighbours.n;
        std::vector<double> matrix(std::size_t(n) * std::size_t(n)), distance(std::size_t(n), 0.0);
        for (int a = 0; a < dimension_; ++a)
            for (int j = 0; j < n; ++j) distance[std::size_t(j)] = std::hypot(distance[std::size_t(j)], neighbours.offset[a][j]);
        assemble(neighbours, distance, matrix.data());
        if (!factorise(matrix.data(), n)) return false;

        std::vector<double> z(std::size_t(n), 1.0);
        solve(matrix.data(), n, z.data());
        double sum = 0;
        for (const double value : z) sum += value;
        for (int j = 0; j < n; ++j) {
            const double r = distance[std::size_t(j)];
            weights.damping[j] = damping_ * (z[std::size_t(j)] / sum + diffusion[dimension_] * laplacian_ * std::exp(-2 * r * r));
        }
        for (int a = 0; a < dimension_; ++a) {
            for (int j = 0; j < n; ++j) weights.gradient[a][j] = averages_.slope(distance[std::size_t(j)]) * neighbours.offset[a][j];
            solve(matrix.data(), n, weights.gradient[a]);
        }
        return true;
    }

private:
    static constexpr double beyond = 1.25;        ///< the band that is fitted goes on: least squares are worst at its end
    static constexpr double tikhonov[4] = {0, 1e-7, 1e-7, 3e-7};    ///< less makes weights large, more makes the band inexact
    static constexpr double diffusion[4] = {0, 1. / 3000, 1. / 3000, 1. / 1000};

    static constexpr double usual_damping[4] = {0, 0.25, 0.25, 0.4};    ///< sigma [c0/dx]

    int dimension_;
    double damping_, laplacian_;
    BandAverages averages_;

    /// The lower triangle of M + eps.
    void assemble(const abi::CloudNeighbours& neighbours, const std::vector<double>& distance, double* matrix) const {
        const int n = neighbours.n;
        std::vector<double> own(std::size_t(n), 0.0);
        for (int j = 0; j < n; ++j) own[std::size_t(j)] = averages_.value(distance[std::size_t(j)]) - 0.5;
        for (int j = 0; j < n; ++j)
            for (int l = 0; l <= j; ++l) {
                double squared = 0;
                for (int a = 0; a < dimension_; ++a) squared += std::pow(neighbours.offset[a][j] - neighbours.offset[a][l], 2);
                matrix[std::size_t(j) * std::size_t(n) + std::size_t(l)] =
                    averages_.value(std::sqrt(squared)) - own[std::size_t(j)] - own[std::size_t(l)] + (j == l ? tikhonov[dimension_] : 0);
            }
    }
};

}    // namespace sphonic::band
