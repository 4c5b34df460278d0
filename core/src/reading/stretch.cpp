#include <sphonic/stretch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sphonic {
namespace {

constexpr double looks = 4;    ///< for media, in the smallest spacing

/// Where the medium changes between `low`, of number `before`, and `high`.
double interface_between(const abi::Media& media, double low, double high, int before) {
    for (;;) {
        const double middle = std::midpoint(low, high);
        if (middle <= low || middle >= high) return high;
        (media.number_at(1, &middle) == before ? low : high) = middle;
    }
}

}    // namespace

std::vector<Stratum> strata(const abi::Box& box, const abi::Media& media, double step) {
    const long n = long(std::ceil((box.upper[0] - box.lower[0]) / step));
    std::vector<Stratum> list{{.begin = box.lower[0], .end = box.upper[0], .medium = media.number_at(1, box.lower)}};
    double x = box.lower[0];
    for (long i = 1; i <= n; ++i) {
        const double next = std::lerp(box.lower[0], box.upper[0], double(i) / double(n));
        if (const int there = media.number_at(1, &next); there != list.back().medium) {
            list.back().end = interface_between(media, x, next, list.back().medium);
            list.push_back({.begin = list.back().end, .end = box.upper[0], .medium = there});
        }
        x = next;
    }
    return list;
}

Stretch::Stretch(const abi::Box& box, const abi::Media& media) {
    double finest = box.dx;
    for (int m = 0; m < media.count; ++m) {
        finest = std::min(finest, media.spacing[m]);
        factors_.push_back(media.spacing[m] / box.dx);
    }
    for (const Stratum& stratum : strata(box, media, finest / looks))
        pieces_.push_back({stratum.begin, pieces_.empty() ? stratum.begin : site(stratum.begin), factors_[std::size_t(stratum.medium)]});
}

double Stretch::place(double s) const {
    const Piece& piece = *std::prev(std::upper_bound(pieces_.begin() + 1, pieces_.end(), s, [](double v, const Piece& p) { return v < p.s; }));
    return piece.x + piece.factor * (s - piece.s);
}

double Stretch::site(double x) const {
    const Piece& piece = *std::prev(std::upper_bound(pieces_.begin() + 1, pieces_.end(), x, [](double v, const Piece& p) { return v < p.x; }));
    return piece.s + (x - piece.x) / piece.factor;
}

double Stretch::factor(double s) const {
    return std::prev(std::upper_bound(pieces_.begin() + 1, pieces_.end(), s, [](double v, const Piece& p) { return v < p.s; }))->factor;
}

}    // namespace sphonic
