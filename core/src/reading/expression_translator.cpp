#include "expression_translator.hpp"

#include <algorithm>
#include <array>

#include "expression_names.hpp"
#include "expression_tokens.hpp"

namespace sphonic {
namespace {

constexpr std::array<Words, 4> joining{" or ", " and ", " + - ", " * / "};    // loosest first
constexpr int max_nesting = 64;

/// A translated part of the text: a number or a condition, in muParser's notation, parenthesised.
struct Piece {
    std::string code;
    bool condition;
    std::string source;
};

/// Recursive descent from the house syntax to muParser's, which knows no and, or, not, and reads a <= x <= b as
/// (a <= x) <= b.
class Translator {
public:
    Translator(const SourceText& source, const Names& names) : source_(source), names_(names), tokens_(source) {}

    std::string translate(bool condition) {
        if (tokens_.token().empty()) source_.refuse("there is no text", "Write an expression");
        const Piece whole = joined(0);
        if (!tokens_.token().empty()) tokens_.refuse();
        return need(condition, whole).code;
    }

private:
    const Piece& need(bool condition, const Piece& piece) const {
        const std::string what = piece.source == source_.text ? "this" : in_quotes(piece.source);
        if (condition && !piece.condition)
            source_.refuse(what + " is a number, not a condition", "Compare it with a number");
        if (!condition && piece.condition)
            source_.refuse(what + " is a condition, not a number", "Remove the comparison");
        return piece;
    }

    Piece since(std::size_t from, const std::string& code, bool condition) const {
        return {code, condition, tokens_.since(from)};
    }

    Piece joined(std::size_t level) {
        const bool condition = level < 2;
        const std::size_t from = tokens_.begin();
        Piece left = level == 1 ? negation() : level == 3 ? unary() : joined(level + 1);
        while (among(joining[level], tokens_.token())) {
            const std::string word = tokens_.take(), op = word == "or" ? "||" : word == "and" ? "&&" : word;
            const Piece right = level == 1 ? negation() : level == 3 ? unary() : joined(level + 1);
            left = since(from, "(" + need(condition, left).code + op + need(condition, right).code + ")", condition);
        }
        return left;
    }

    Piece negation() {
        const std::size_t from = tokens_.begin();
        std::size_t count = 0;
        while (tokens_.accept("not")) ++count;
        const Piece inner = comparison();
        return count == 0 ? inner : since(from, "(" + need(true, inner).code + (count % 2 ? "==0)" : "!=0)"), true);
    }

    Piece comparison() {
        const std::size_t from = tokens_.begin();
        Piece left = joined(2);
        std::string code, first;
        while (among(comparisons, tokens_.token())) {
            const std::string op = tokens_.take();
            if (!first.empty() && (op[0] != first[0] || op == "!="))
                source_.refuse(in_quotes(first) + " and " + in_quotes(op) + " do not chain",
                               "Join two comparisons with and");
            const Piece right = joined(2);
            code += (first.empty() ? "(" : "&&(") + need(false, left).code + op + need(false, right).code + ")";
            first = first.empty() ? op : first;
            left = right;
        }
        return first.empty() ? left : since(from, "(" + code + ")", true);
    }

    Piece unary() {
        if (++nesting_ > max_nesting)
            source_.refuse("more than " + std::to_string(max_nesting) + " parts are nested", "Nest less deeply");
        const std::size_t from = tokens_.begin();
        std::string signs;
        while (tokens_.token() == "+" || tokens_.token() == "-") signs += tokens_.take();
        const std::size_t unsigned_from = tokens_.begin();
        Piece inner = primary();
        if (tokens_.accept("^")) {
            const std::string base = need(false, inner).code;
            inner = since(unsigned_from, "(" + base + "^" + need(false, unary()).code + ")", false);
        }
        --nesting_;
        const bool minus = std::count(signs.begin(), signs.end(), '-') % 2 == 1;
        return signs.empty() ? inner : since(from, (minus ? "(-" : "(") + need(false, inner).code + ")", false);
    }

    Piece primary() {
        const std::size_t from = tokens_.begin();
        if (tokens_.accept("(")) {
            const Piece inner = joined(0);
            tokens_.expect(")");
            return since(from, inner.code, inner.condition);
        }
        const std::string_view token = tokens_.token();
        const char first = token.empty() ? ' ' : token[0];
        if (among(joiners, token) || !(in_name(first) || (first == '.' && token.size() > 1))) tokens_.refuse();
        const std::string word = tokens_.take();
        if (!is_letter(first)) return since(from, word, false);
        return since(from, tokens_.accept("(") ? call(word) : names_.value(word), false);
    }

    std::string call(const std::string& name) {
        names_.require_function(name);
        std::size_t count = 0;
        std::string code = name;
        do code += (count++ == 0 ? "(" : ",") + need(false, joined(0)).code;
        while (tokens_.accept(","));
        tokens_.expect(")");
        names_.require_arguments(name, count);
        return code + ")";
    }

    const SourceText& source_;
    const Names& names_;
    Tokens tokens_;
    int nesting_ = 0;
};

}    // namespace

std::string muparser_code(const std::string& text, const Expression::Constants& constants, int dimension,
                          const std::string& place, bool condition) {
    const SourceText source{text, place};
    const Names names(source, constants, dimension);
    return Translator(source, names).translate(condition);
}

}    // namespace sphonic
