#pragma once
#include <array>
#include <vector>

#include <sphonic/case.hpp>

namespace sphonic {

/// A lattice of which copies fill space, such that waves without walls do in one of them what they do in the case's own box:
/// periodic axes as they are, mirrors unfolded into their even or odd images, and where sound leaves for good, enough room beyond
/// the face that none comes back in time.
class RepeatedBox {
public:
    explicit RepeatedBox(const Case& scene);

    const std::array<long, 3>& count() const { return count_; }
    long size() const { return count_[0] * count_[1] * count_[2]; }
    /// True if some face was taken for open.
    bool opened() const { return opened_; }
    /// Wave numbers [rad/m] of a Fourier component, both signs.
    std::array<double, 3> wave_vector(long component) const;

    /// The component of the opposite wave vector: of real fields the conjugate.
    long opposite(long component) const;

    /// A variable's component at t = 0 on the whole lattice; false if the case gives none. `axis` of a vector, -1 for a scalar.
    bool initial(const std::string& variable, int axis, std::vector<double>& out) const;
    /// The places of the box's own points, x fastest, in the case's order.
    std::vector<long> own() const;

private:
    /// Where a point's values come from along an axis: a coordinate [m], and their signs by abi::Part.
    struct Image {
        double x;
        double sign[3];
    };
    const Case& scene_;
    std::array<long, 3> count_{1, 1, 1}, first_{0, 0, 0};    ///< `first_`: the box's own first point
    std::vector<Image> images_[3];
    bool opened_ = false;

    void unfold(int axis);
};

/// True where such a box exists: a regular set of one medium whose faces are periodic, mirrors or open to sound.
bool repeats(const Case& scene);

}    // namespace sphonic
