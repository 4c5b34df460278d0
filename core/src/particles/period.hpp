#pragma once

namespace sphonic {

/// The length after which an axis repeats [m]; 0 for none.
struct Period {
    double length = 0, inverse = 0;
    Period() = default;
    explicit Period(double l) : length(l), inverse(1 / l) {}

    /// The nearest image of separations, of one number or a vector of them.
    template <class Real>
    Real nearest(Real r) const {
        constexpr double integers = 0x1.8p52;    // adding it leaves no room for a fraction
        return r - length * ((r * inverse + integers) - integers);
    }
};

}    // namespace sphonic
