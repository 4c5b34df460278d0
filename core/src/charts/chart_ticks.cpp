#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chart_scale.hpp"

namespace sphonic::charting {

namespace {

std::string with_minus(std::string text) {
    for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; at += 3) text.replace(at, 1, "\u2212");
    return text;
}

std::string power_of_ten(int exponent) { return with_minus("10^{" + std::to_string(exponent) + "}"); }

std::string fixed(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return with_minus(text);
}

/// Room [px] that the labels need from one tick to the next.
double room(const std::vector<Tick>& ticks, double font, bool along) {
    return along ? widest(ticks, font) + 1.6 * font : 2 * font;
}

std::vector<Tick> linear_ticks(const Scale& scale, double step) {
    const double size = std::max(std::abs(scale.lower), std::abs(scale.upper));
    const int exponent = size >= 1e6 || size < 1e-3 ? static_cast<int>(std::floor(std::log10(size))) : 0;
    const double unit = std::pow(10.0, exponent);
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step / unit) - 1e-9)));
    std::vector<Tick> ticks;
    for (double n = std::ceil(scale.lower / step - 1e-9); n * step <= scale.upper + 1e-9 * step; ++n) {
        const double value = n * step;
        std::string text = n == 0 ? "0" : fixed(value / unit, decimals);
        if (exponent != 0 && n != 0) text += "×" + power_of_ten(exponent);
        ticks.push_back({value, text});
    }
    return ticks;
}

std::vector<Tick> linear_ticks(const Scale& scale, double length, double font, bool along) {
    const double range = scale.upper - scale.lower;
    int decade = static_cast<int>(std::floor(std::log10(range * font / length)));
    for (;; ++decade)
        for (const int digit : {1, 2, 5}) {
            const double step = digit * std::pow(10.0, decade);
            if (step / range * length < 2 * font) continue;
            const std::vector<Tick> ticks = linear_ticks(scale, step);
            if (ticks.size() <= 2 || step / range * length >= room(ticks, font, along)) return ticks;
        }
}

/// Decades labelled every `stride`; the digits between them are minor ticks while there are few enough.
std::vector<Tick> decade_ticks(const Scale& scale, int first, int last, int stride) {
    std::vector<Tick> ticks;
    for (int exponent = first - 1; exponent <= last; ++exponent)
        for (int digit = 1; digit < (last - first < 9 ? 10 : 2); ++digit) {
            const double value = digit * std::pow(10.0, exponent);
            if (!scale.contains(value)) continue;
            ticks.push_back({value, digit == 1 && exponent % stride == 0 ? power_of_ten(exponent) : ""});
        }
    return ticks;
}

std::string digit_text(const Scale& scale, int digit, int exponent) {
    if (scale.lower >= 9e-4 && scale.upper < 1e5)
        return fixed(digit * std::pow(10.0, exponent), std::max(0, -exponent));
    return (digit == 1 ? "" : std::to_string(digit) + "×") + power_of_ten(exponent);
}

/// Ticks at every digit, with text at those of `labelled`.
std::vector<Tick> digit_ticks(const Scale& scale, std::string_view labelled) {
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::floor(std::log10(scale.lower)));
    for (int exponent = first; std::pow(10.0, exponent) <= scale.upper; ++exponent)
        for (int digit = 1; digit < 10; ++digit) {
            const double value = digit * std::pow(10.0, exponent);
            const bool major = labelled.find(static_cast<char>('0' + digit)) != std::string_view::npos;
            if (scale.contains(value)) ticks.push_back({value, major ? digit_text(scale, digit, exponent) : ""});
        }
    return ticks;
}

/// Whether there are enough labels to read the scale, none of them too near to the next.
bool legible(const Scale& scale, std::vector<Tick> ticks, double length, double needed) {
    std::erase_if(ticks, [](const Tick& tick) { return tick.text.empty(); });
    for (std::size_t i = 1; i < ticks.size(); ++i)
        if ((scale.fraction(ticks[i].at) - scale.fraction(ticks[i - 1].at)) * length < needed) return false;
    return ticks.size() >= 2;
}

std::vector<Tick> log_ticks(const Scale& scale, double length, double font, bool along) {
    const double decades = std::log10(scale.upper / scale.lower);
    const int first = static_cast<int>(std::ceil(std::log10(scale.lower) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(scale.upper) + 1e-9));
    if (decades < 1.7)
        for (const std::string_view labelled : {"123456789", "1235", "125", "13"}) {
            const std::vector<Tick> ticks = digit_ticks(scale, labelled);
            if (legible(scale, ticks, length, room(ticks, font, along))) return ticks;
        }
    if (last - first < 1) return linear_ticks(scale, length, font, along);
    const double needed = room({{1, power_of_ten(first)}, {1, power_of_ten(last)}}, font, along);
    return decade_ticks(scale, first, last, std::max(1, static_cast<int>(std::ceil(needed * decades / length))));
}

}    // namespace

double widest(const std::vector<Tick>& ticks, double font) {
    double width = 0;
    for (const Tick& tick : ticks) width = std::max(width, text_width(tick.text, font));
    return width;
}

std::vector<Tick> ticks_of(const Scale& scale, double length, double font, bool along) {
    return scale.log ? log_ticks(scale, length, font, along) : linear_ticks(scale, length, font, along);
}

}    // namespace sphonic::charting
