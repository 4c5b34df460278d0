#pragma once
#include <string>
#include <utility>
#include <vector>

#include <sphonic/expression.hpp>

#include "expression_tokens.hpp"

namespace sphonic {

/// The names an expression may use: the coordinates its dimension has, r, pi, the functions and the constants.
class Names {
public:
    /// `source` must outlive it.
    Names(const SourceText& source, const Expression::Constants& constants, int dimension);

    /// A coordinate, r or a constant in muParser's notation: constants become literals, in parentheses for their sign.
    std::string value(const std::string& name) const;
    void require_function(const std::string& name) const;
    void require_arguments(const std::string& function, std::size_t count) const;

private:
    bool is_known(const std::string& name) const;
    void add_constant(const std::string& name, double value);
    [[noreturn]] void refuse(const std::string& name, const std::string& misuse, const std::string& remedy) const;

    const SourceText& source_;
    std::vector<std::pair<std::string, double>> constants_;
    const int dimension_;
    std::vector<std::string> known_;
};

}    // namespace sphonic
