#include <algorithm>
#include <cmath>
#include <cstdio>

#include "study_parts.hpp"

namespace sphonic {
namespace {

std::size_t width(const std::string& text) {
    return std::size_t(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));    // UTF-8
}

}    // namespace

std::string formatted(const char* format, double x) {
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

std::string with_digits(double x, const char* format) { return std::isfinite(x) ? formatted(format, x) : ""; }

std::string readable(double x) {
    if (!std::isfinite(x)) return "";
    if (x == 0 || std::abs(x) >= 0.01) return formatted("%.4g", x);
    std::string text = formatted("%.3e", x);
    const std::size_t exponent = text.find("e-0");
    return exponent == std::string::npos ? text : text.erase(exponent + 2, 1);
}

std::string markdown_table(std::vector<std::vector<std::string>> rows, std::size_t labels) {
    std::vector<std::size_t> widths(rows[0].size(), 3);
    for (auto& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) {
            for (std::size_t at = 0; (at = row[c].find('|', at)) != std::string::npos; at += 2) row[c].insert(at, "\\");
            widths[c] = std::max(widths[c], width(row[c]));
        }
    std::string text;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < widths.size(); ++c) {
            const std::string space(widths[c] - width(rows[r][c]), ' ');
            text += "| " + (c < labels ? rows[r][c] + space : space + rows[r][c]) + " ";
        }
        text += "|\n";
        if (r > 0) continue;
        for (std::size_t c = 0; c < widths.size(); ++c)
            text += "| " + std::string(widths[c] - (c >= labels), '-') + (c < labels ? " " : ": ");
        text += "|\n";
    }
    return text;
}

}    // namespace sphonic
