#pragma once
#include <array>
#include <optional>

namespace sphonic {

/// The symmetric moment M = sum_j V_j grad_i W_ij (x) (x_j - x_i) of one particle's neighbourhood, and its inverse, which
/// corrects the kernel's gradient. M is the identity where the kernel's gradient is exact for linear fields.
class Moment {
public:
    explicit Moment(int dimension) : d_(dimension) {}

    /// One neighbour: r = x_i - x_j, and V_j (dW/dr)/r; grad_i W = r (dW/dr)/r.
    void add(const double* r, double weight) {
        for (int a = 0; a < d_; ++a)
            for (int b = 0; b < d_; ++b) m_[std::size_t(3 * a + b)] -= weight * r[a] * r[b];
    }
    /// Row-major 3 x 3, zero beyond the dimension. Nothing where the neighbourhood is degenerate: the neighbours, if any, do
    /// not span the space.
    std::optional<std::array<double, 9>> inverse() const;

private:
    int d_;
    std::array<double, 9> m_{};
};

}    // namespace sphonic
