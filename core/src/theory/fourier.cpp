#include "fourier.hpp"

#include <cmath>

namespace sphonic {
namespace {

long least_factor(long n) {
    for (long p = 2; p * p <= n; ++p)
        if (n % p == 0) return p;
    return n;
}

/// The transform of one line length.
class Line {
public:
    Line(long n, int sign) : n_(n), in_(std::size_t(n)), out_(in_), terms_(in_) {
        for (long t = 0; t < n; ++t) roots_.push_back(std::polar(1.0, double(sign) * 2 * std::acos(-1.0) * double(t) / double(n)));
    }

    void transform(Complex* f, long stride) {
        for (long i = 0; i < n_; ++i) in_[std::size_t(i)] = f[i * stride];
        split(in_.data(), out_.data(), n_, 1);
        for (long i = 0; i < n_; ++i) f[i * stride] = out_[std::size_t(i)];
    }

private:
    const long n_;
    std::vector<Complex> roots_, in_, out_, terms_;

    /// The transform of n values, `stride` apart; n stride is the length of the line.
    void split(const Complex* in, Complex* out, long n, long stride) {
        if (n == 1) {
            out[0] = in[0];
            return;
        }
        const long p = least_factor(n), m = n / p;
        for (long q = 0; q < p; ++q) split(in + q * stride, out + q * m, m, stride * p);
        for (long j = 0; j < m; ++j) {
            for (long q = 0; q < p; ++q) terms_[std::size_t(q)] = out[q * m + j] * roots_[std::size_t(q * j * stride)];
            for (long r = 0; r < p; ++r) {
                Complex sum = terms_[0];
                for (long q = 1; q < p; ++q) sum += terms_[std::size_t(q)] * roots_[std::size_t(q * r % p * m * stride)];
                out[r * m + j] = sum;
            }
        }
    }
};

}    // namespace

void fourier(std::vector<Complex>& f, const std::array<long, 3>& n, int sign) {
    long stride = 1;
    for (const long length : n) {
        Line line(length, sign);
        for (long begin = 0; begin < long(f.size()); begin += stride * length)
            for (long i = 0; i < stride; ++i) line.transform(f.data() + begin + i, stride);
        stride *= length;
    }
}

double fourier_work(const std::array<long, 3>& n) {
    double size = 1, factors = 0;
    for (long length : n) {
        size *= double(length);
        for (; length > 1; length /= least_factor(length)) factors += double(least_factor(length));
    }
    return size * factors;
}

}    // namespace sphonic
