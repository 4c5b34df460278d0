#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sphonic {

class Formula;
class Stretch;

/// A scalar expression of x, y, z, r (r = |x|) and named constants, evaluated at set-up only: + - * / ^, parentheses,
/// pi, and sin cos tan exp sqrt abs log (natural) of one argument, min and max of two or more. -x^2 is -(x^2), and
/// 2^3^2 is 2^(3^2). Evaluation writes into the object: two threads must not evaluate the same one at once.
class Expression {
public:
    /// pi is always there.
    struct Constants {
        std::vector<std::pair<std::string, double>> values;
        std::shared_ptr<const Stretch> stretch{};    ///< points are given in its coordinate, and x is what it makes of them; null: x itself
    };

    Expression(const std::string& text, const Constants& constants, int dimension, const std::string& place);
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;
    ~Expression();

    /// The value at the point x of `dimension` entries; not finite where the expression is not.
    double operator()(const double* x) const;
    const std::string& text() const;

private:
    std::unique_ptr<Formula> formula_;
};

/// A membership test: comparisons < <= > >= == != of expressions, joined by and, or, not and parentheses.
/// `a <= x <= b` means both; such a chain keeps one direction. A comparison with NaN is false, except !=.
/// Two threads must not evaluate the same object at once.
class Region {
public:
    Region(const std::string& text, const Expression::Constants& constants, int dimension, const std::string& place);
    Region(Region&&) noexcept;
    Region& operator=(Region&&) noexcept;
    ~Region();

    /// x has `dimension` entries.
    bool contains(const double* x) const;
    const std::string& text() const;

private:
    std::unique_ptr<Formula> formula_;
};

}    // namespace sphonic
