#include "distance_map.hpp"

#include <cmath>

namespace sphonic {
namespace {

constexpr double far = 1e12;    ///< squared

/// min_j f_j + (i - j)^2 along a line, as the lower envelope of parabolas (Felzenszwalb and Huttenlocher 2012).
class Envelope {
public:
    explicit Envelope(std::size_t n) : lowest_(n), from_(n + 1) {}

    void transform(const std::vector<double>& f, std::vector<double>& out) {
        const std::size_t n = f.size();
        std::size_t k = 0;
        lowest_[0] = 0;
        from_[0] = -far;
        for (std::size_t q = 1; q < n; ++q) {
            double begin = meet(f, lowest_[k], q);
            while (k > 0 && begin <= from_[k]) begin = meet(f, lowest_[--k], q);
            if (begin <= from_[k]) begin = from_[k];
            lowest_[++k] = q;
            from_[k] = begin;
        }
        from_[k + 1] = far;
        k = 0;
        for (std::size_t q = 0; q < n; ++q) {
            while (from_[k + 1] < double(q)) ++k;
            const double way = double(q) - double(lowest_[k]);
            out[q] = f[lowest_[k]] + way * way;
        }
    }

private:
    std::vector<std::size_t> lowest_;    ///< vertices of the envelope's parabolas
    std::vector<double> from_;           ///< where each begins to be the lowest

    static double meet(const std::vector<double>& f, std::size_t v, std::size_t q) {
        const double x = double(v), y = double(q);
        return 0.5 * ((f[q] - f[v]) / (y - x) + x + y);
    }
};

}    // namespace

std::vector<double> distances(const abi::Box& box, const std::vector<char>& marked) {
    std::vector<double> squared(marked.size());
    for (std::size_t i = 0; i < marked.size(); ++i) squared[i] = marked[i] ? 0 : far;
    std::size_t stride = 1;
    for (int a = 0; a < box.dimension; ++a) {
        const auto n = std::size_t(box.count[a]), images = std::size_t(box.periodic[a] ? 3 : 1), begin = box.periodic[a] ? n : 0;
        std::vector<double> line(n * images), out(n * images);
        Envelope envelope(line.size());
        for (std::size_t i = 0; i < marked.size(); ++i) {
            if (i / stride % n != 0) continue;
            for (std::size_t k = 0; k < line.size(); ++k) line[k] = squared[i + k % n * stride];
            envelope.transform(line, out);
            for (std::size_t k = 0; k < n; ++k) squared[i + k * stride] = out[begin + k];
        }
        stride *= n;
    }
    for (double& d : squared) d = std::sqrt(d);
    return squared;
}

}    // namespace sphonic
