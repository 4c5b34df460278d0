#include "expression_tokens.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

#include <sphonic/error.hpp>

namespace sphonic {
namespace {

/// A spelling used elsewhere, and ours.
using Spelling = std::pair<std::string_view, std::string_view>;
constexpr std::array foreign = {Spelling{"&&", "and"}, Spelling{"||", "or"}, Spelling{"**", "^"}, Spelling{"=<", "<="},
                                Spelling{"=>", ">="},  Spelling{"<>", "!="}, Spelling{"=", "=="}, Spelling{"!", "not"}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}    // namespace

bool among(Words words, std::string_view word) { return words.find(" " + std::string(word) + " ") != Words::npos; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool in_name(char c) { return is_letter(c) || is_digit(c); }
std::string in_quotes(std::string_view text) { return '"' + std::string(text) + '"'; }

void SourceText::refuse(const std::string& problem, const std::string& remedy) const {
    throw Error(Fault::input, place, in_quotes(text) + ": " + problem, remedy);
}

Tokens::Tokens(const SourceText& source) : source_(source), text_(source.text) { advance(); }

std::size_t Tokens::begin() const { return static_cast<std::size_t>(token_.data() - text_.data()); }

std::string Tokens::since(std::size_t from) const { return std::string(text_.substr(from, done_ - from)); }

std::string Tokens::take() {
    std::string token(token_);
    return advance(), token;
}

bool Tokens::accept(std::string_view token) { return token_ == token && (advance(), true); }

void Tokens::expect(std::string_view token) {
    if (!accept(token))
        source_.refuse(in_quotes(token) + " is missing at column " + std::to_string(begin() + 1), "Add it");
}

void Tokens::refuse() const {
    if (token_.empty()) source_.refuse("something is missing at the end", "Complete it");
    source_.refuse(in_quotes(token_) + " is out of place at column " + std::to_string(begin() + 1), "Correct it there");
}

void Tokens::advance() {
    done_ = next_;
    const std::size_t from = std::min(text_.find_first_not_of(" \t\r\n", next_), text_.size());
    token_ = text_.substr(from, size_at_start(text_.substr(from)));
    next_ = from + token_.size();
}

std::size_t Tokens::size_at_start(std::string_view rest) const {
    if (rest.empty() || is_letter(rest[0])) return std::find_if_not(rest.begin(), rest.end(), in_name) - rest.begin();
    double number;
    const auto [end, fault] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (rest[0] != '-' && fault == std::errc::result_out_of_range)
        source_.refuse("the number " + std::string(rest.data(), end) + " does not fit a double", "Write one that does");
    if (rest[0] != '-' && fault == std::errc()) return end - rest.data();
    if (among(comparisons, rest.substr(0, 2))) return 2;
    for (const auto& [wrong, right] : foreign)
        if (rest.starts_with(wrong))
            source_.refuse(in_quotes(wrong) + " is not used here", "Write " + std::string(right));
    return std::find_if(rest.begin() + 1, rest.end(), [](char c) { return (c & 0xC0) != 0x80; }) - rest.begin();
}

}    // namespace sphonic
