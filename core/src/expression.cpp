#include <sphonic/expression.hpp>

#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string_view>

namespace sphonic {
namespace {

using Words = std::string_view;    // words between blanks
constexpr Words one_argument = " sin cos tan exp sqrt abs log ", more_arguments = " min max ";
constexpr Words coordinates = " x y z ", joiners = " and or not ", comparisons = " <= >= == != < > ";
constexpr std::array<Words, 4> joining{" or ", " and ", " + - ", " * / "};    // loosest first
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> foreign{{    // as written elsewhere, and here
    {"&&", "and"}, {"||", "or"}, {"**", "^"}, {"=<", "<="}, {"=>", ">="}, {"<>", "!="}, {"=", "=="}, {"!", "not"}}};
constexpr int max_nesting = 64;

bool among(Words words, std::string_view word) { return words.find(" " + std::string(word) + " ") != words.npos; }
bool is_function(std::string_view name) { return among(one_argument, name) || among(more_arguments, name); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool in_name(char c) { return is_letter(c) || is_digit(c); }
std::string in_quotes(std::string_view text) { return '"' + std::string(text) + '"'; }

/// A translated part of the text: a number or a condition, in muParser's notation, parenthesised.
struct Piece { std::string code; bool condition; std::string source; };

/// Recursive descent from the house syntax to muParser's, which knows no and, or, not, and reads a <= x <= b as
/// (a <= x) <= b. Constants become literals.
class Translator {
public:
    Translator(std::string_view text, const Expression::Constants& constants, int dimension, const std::string& place)
        : text_(text), constants_(constants.values), dimension_(dimension), place_(place) {
        assert(dimension >= 1 && dimension <= 3);
        known_.assign({"x", "y", "z"});
        known_.resize(static_cast<std::size_t>(dimension));
        known_.insert(known_.end(), {"r", "pi"});
        std::istringstream functions(std::string(one_argument) + std::string(more_arguments));
        known_.insert(known_.end(), std::istream_iterator<std::string>(functions), {});
        for (const auto& [name, value] : constants_)
            add_constant(name, value);
        constants_.emplace_back("pi", std::numbers::pi);
    }

    std::string translate(bool condition) {
        advance();
        if (token_.empty())
            refuse("there is no text", "Write an expression");
        const Piece whole = joined(0);
        if (!token_.empty())
            refuse_token();
        return need(condition, whole).code;
    }

private:
    [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
        throw Error(Fault::input, place_, in_quotes(text_) + ": " + problem, remedy);
    }

    bool is_known(const std::string& name) const { return std::count(known_.begin(), known_.end(), name) > 0; }

    void add_constant(const std::string& name, double value) {
        const std::string constant = "the constant " + in_quotes(name);
        const bool is_name = !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), in_name);
        if (!is_name || among(joiners, name) || among(coordinates, name) || is_known(name))
            throw Error(Fault::input, place_, constant + " has a name that is taken or is no name", "Rename it");
        if (!std::isfinite(value))
            throw Error(Fault::input, place_, constant + " is not finite", "Give it a finite value");
        known_.push_back(name);
    }

    [[noreturn]] void refuse_token() const {
        if (token_.empty())
            refuse("something is missing at the end", "Complete it");
        refuse(in_quotes(token_) + " is out of place at column " + std::to_string(begin() + 1), "Correct it there");
    }

    const Piece& need(bool condition, const Piece& piece) const {
        const std::string what = piece.source == text_ ? "this" : in_quotes(piece.source);
        if (condition && !piece.condition)
            refuse(what + " is a number, not a condition", "Compare it with a number");
        if (!condition && piece.condition)
            refuse(what + " is a condition, not a number", "Remove the comparison");
        return piece;
    }

    std::size_t begin() const { return static_cast<std::size_t>(token_.data() - text_.data()); }
    Piece since(std::size_t from, const std::string& code, bool condition) const {
        return {code, condition, std::string(text_.substr(from, done_ - from))};
    }

    std::size_t token_size(std::string_view rest) const {
        if (rest.empty() || is_letter(rest[0]))
            return std::find_if_not(rest.begin(), rest.end(), in_name) - rest.begin();
        double number;
        const auto [end, fault] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
        if (rest[0] != '-' && fault == std::errc::result_out_of_range)
            refuse("the number " + std::string(rest.data(), end) + " does not fit a double", "Write one that does");
        if (rest[0] != '-' && fault == std::errc())
            return end - rest.data();
        if (among(comparisons, rest.substr(0, 2)))
            return 2;
        for (const auto& [wrong, right] : foreign)
            if (rest.starts_with(wrong))
                refuse(in_quotes(wrong) + " is not used here", "Write " + std::string(right));
        return std::find_if(rest.begin() + 1, rest.end(), [](char c) { return (c & 0xC0) != 0x80; }) - rest.begin();
    }

    void advance() {
        done_ = next_;
        const std::size_t from = std::min(text_.find_first_not_of(" \t\r\n", next_), text_.size());
        token_ = text_.substr(from, token_size(text_.substr(from)));
        next_ = from + token_.size();
    }

    std::string take() { std::string token(token_); return advance(), token; }
    bool accept(std::string_view token) { return token_ == token && (advance(), true); }
    void expect(std::string_view token) {
        if (!accept(token))
            refuse(in_quotes(token) + " is missing at column " + std::to_string(begin() + 1), "Add it");
    }

    Piece joined(std::size_t level) {
        const bool condition = level < 2;
        const std::size_t from = begin();
        Piece left = level == 1 ? negation() : level == 3 ? unary() : joined(level + 1);
        while (among(joining[level], token_)) {
            const std::string word = take(), op = word == "or" ? "||" : word == "and" ? "&&" : word;
            const Piece right = level == 1 ? negation() : level == 3 ? unary() : joined(level + 1);
            left = since(from, "(" + need(condition, left).code + op + need(condition, right).code + ")", condition);
        }
        return left;
    }

    Piece negation() {
        const std::size_t from = begin();
        std::size_t count = 0;
        while (accept("not"))
            ++count;
        const Piece inner = comparison();
        return count == 0 ? inner : since(from, "(" + need(true, inner).code + (count % 2 ? "==0)" : "!=0)"), true);
    }

    Piece comparison() {
        const std::size_t from = begin();
        Piece left = joined(2);
        std::string code, first;
        while (among(comparisons, token_)) {
            const std::string op = take();
            if (!first.empty() && (op[0] != first[0] || op == "!="))
                refuse(in_quotes(first) + " and " + in_quotes(op) + " do not chain", "Join two comparisons with and");
            const Piece right = joined(2);
            code += (first.empty() ? "(" : "&&(") + need(false, left).code + op + need(false, right).code + ")";
            first = first.empty() ? op : first;
            left = right;
        }
        return first.empty() ? left : since(from, "(" + code + ")", true);
    }

    Piece unary() {
        if (++nesting_ > max_nesting)
            refuse("more than " + std::to_string(max_nesting) + " parts are nested", "Nest less deeply");
        const std::size_t from = begin();
        std::string signs;
        while (token_ == "+" || token_ == "-")
            signs += take();
        const std::size_t unsigned_from = begin();
        Piece inner = primary();
        if (accept("^")) {
            const std::string base = need(false, inner).code;
            inner = since(unsigned_from, "(" + base + "^" + need(false, unary()).code + ")", false);
        }
        --nesting_;
        const bool minus = std::count(signs.begin(), signs.end(), '-') % 2 == 1;
        return signs.empty() ? inner : since(from, (minus ? "(-" : "(") + need(false, inner).code + ")", false);
    }

    Piece primary() {
        const std::size_t from = begin();
        if (accept("(")) {
            const Piece inner = joined(0);
            expect(")");
            return since(from, inner.code, inner.condition);
        }
        const char first = token_.empty() ? ' ' : token_[0];
        if (among(joiners, token_) || !(in_name(first) || (first == '.' && token_.size() > 1)))
            refuse_token();
        const std::string word = take();
        return since(from, !is_letter(first) ? word : accept("(") ? call(word) : named(word), false);
    }

    std::string call(const std::string& name) {
        if (!is_function(name))
            refuse_name(name, is_known(name) ? " is not a function" : "", "Write * to multiply");
        std::size_t count = 0;
        std::string code = name;
        do
            code += (count++ == 0 ? "(" : ",") + need(false, joined(0)).code;
        while (accept(","));
        expect(")");
        if (among(one_argument, name) ? count != 1 : count < 2)
            refuse(name + " is given " + std::to_string(count) + (count == 1 ? " argument" : " arguments"),
                   among(one_argument, name) ? "Give one" : "Give two or more");
        return code + ")";
    }

    /// Constants become literals, in parentheses for their sign.
    std::string named(const std::string& name) const {
        for (const auto& [constant, value] : constants_)
            if (name == constant) {
                std::array<char, 32> digits;
                return "(" + std::string(digits.data(), std::to_chars(digits.begin(), digits.end(), value).ptr) + ")";
            }
        if (!is_known(name) || is_function(name))
            refuse_name(name, is_function(name) ? " has no arguments" : "", "Write them in parentheses");
        return name;
    }

    [[noreturn]] void refuse_name(const std::string& name, const std::string& misuse, const std::string& remedy) const {
        if (!misuse.empty())
            refuse(in_quotes(name) + misuse, remedy);
        if (among(coordinates, name))
            refuse(in_quotes(name) + " does not exist in " + std::to_string(dimension_) + "-D",
                   dimension_ == 1 ? "Use x or r" : "Use x, y or r");
        std::string list;
        for (const std::string& other : known_)
            list += (list.empty() ? "" : ", ") + other;
        const std::string guess = nearest(name, known_);
        refuse(in_quotes(name) + " is unknown",
               guess.empty() ? "Known are " + list : "Did you mean " + in_quotes(guess) + "?");
    }

    const std::string_view text_;
    std::vector<std::pair<std::string, double>> constants_;
    const int dimension_;
    const std::string place_;
    std::vector<std::string> known_;
    std::string_view token_;
    std::size_t next_ = 0, done_ = 0;    // where the text goes on, where the last token taken ends
    int nesting_ = 0;
};

}    // namespace

class Formula {
public:
    Formula(const std::string& source, const Expression::Constants& constants, int dimension, const std::string& place,
            bool condition)
        : text(source), dimension_(dimension) {
        const std::string code = Translator(text, constants, dimension, place).translate(condition);
        try {
            for (std::size_t i = 0; i < at_.size(); ++i)
                parser_.DefineVar(std::string(1, "xyzr"[i]), &at_[i]);
            parser_.SetExpr(code);
            parser_.Eval();
        } catch (const mu::ParserError& error) {
            throw Error(Fault::input, place, in_quotes(text) + ": muParser says: " + error.GetMsg());
        }
    }

    double operator()(const double* x) {
        std::copy_n(x, dimension_, at_.begin());
        at_[3] = std::hypot(at_[0], at_[1], at_[2]);
        return parser_.Eval();
    }

    const std::string text;

private:
    int dimension_;
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
