#include <sphonic/expression.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <muParser.h>
#include <sphonic/error.hpp>
#include <sphonic/stretch.hpp>

#include "expression_tokens.hpp"
#include "expression_translator.hpp"

namespace sphonic {

class Formula {
public:
    Formula(std::string source, const Expression::Constants& constants, int dimension, const std::string& place,
            bool condition)
        : text(std::move(source)), dimension_(dimension), stretch_(constants.stretch) {
        const std::string code = muparser_code(text, constants, dimension, place, condition);
        try {
            for (std::size_t i = 0; i < at_.size(); ++i) parser_.DefineVar(std::string(1, "xyzr"[i]), &at_[i]);
            parser_.SetExpr(code);
            parser_.Eval();
        } catch (const mu::ParserError& error) {
            throw Error(Fault::input, place, in_quotes(text) + ": muParser says: " + error.GetMsg());
        }
    }

    double operator()(const double* x) {
        std::copy_n(x, dimension_, at_.begin());
        if (stretch_) at_[0] = stretch_->place(at_[0]);
        at_[3] = std::hypot(at_[0], at_[1], at_[2]);
        return parser_.Eval();
    }

    const std::string text;

private:
    int dimension_;
    std::shared_ptr<const Stretch> stretch_;
    std::array<double, 4> at_{};    // x, y, z, r
    mu::Parser parser_;
};

Expression::Expression(const std::string& text, const Constants& constants, int dimension, const std::string& place)
    : formula_(std::make_unique<Formula>(text, constants, dimension, place, false)) {}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;
double Expression::operator()(const double* x) const { return (*formula_)(x); }
const std::string& Expression::text() const { return formula_->text; }

Region::Region(const std::string& text, const Expression::Constants& constants, int dimension, const std::string& place)
    : formula_(std::make_unique<Formula>(text, constants, dimension, place, true)) {}
Region::Region(Region&&) noexcept = default;
Region& Region::operator=(Region&&) noexcept = default;
Region::~Region() = default;
bool Region::contains(const double* x) const { return (*formula_)(x) != 0; }
const std::string& Region::text() const { return formula_->text; }

}    // namespace sphonic
