#pragma once
#include <sphonic/expression.hpp>
#include <sphonic/plugin/abi/shape.hpp>

namespace sphonic {

/// An expression as plugins see it.
class ReadFormula final : public abi::Formula {
public:
    explicit ReadFormula(Expression expression) : expression_(std::move(expression)) {}
    void evaluate(const abi::Points& points, double* value) const override {
        double x[3] = {};
        for (int i = 0; i < points.n; ++i) {
            for (int a = 0; a < points.dimension; ++a) x[a] = points.x[a][i];
            value[i] = expression_(x);
        }
    }

private:
    Expression expression_;
};

}    // namespace sphonic
