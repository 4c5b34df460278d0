#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace sphonic {

using Words = std::string_view;    // words between blanks
constexpr Words joiners = " and or not ", comparisons = " <= >= == != < > ";

bool among(Words words, std::string_view word);
bool is_letter(char c);
/// A letter or a digit.
bool in_name(char c);
std::string in_quotes(std::string_view text);

/// The text of an expression and where it stands; both must outlive it.
struct SourceText {
    const std::string& text;
    const std::string& place;

    [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const;
};

/// The tokens of the text, one at a time: names, numbers, operators; at the end the empty one.
class Tokens {
public:
    /// `source` must outlive it.
    explicit Tokens(const SourceText& source);

    std::string_view token() const { return token_; }
    std::size_t begin() const;    ///< of the token, in the text
    /// The text from there to the end of the last token taken.
    std::string since(std::size_t from) const;

    std::string take();
    bool accept(std::string_view token);
    void expect(std::string_view token);
    [[noreturn]] void refuse() const;

private:
    void advance();
    std::size_t size_at_start(std::string_view rest) const;

    const SourceText& source_;
    const std::string_view text_;
    std::string_view token_;
    std::size_t next_ = 0, done_ = 0;    // where the text goes on, where the last token taken ends
};

}    // namespace sphonic
