#include <sphonic/plugin/arrangement.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace {

std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
    return begin == text.npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

std::vector<std::string_view> columns(std::string_view line) {
    std::vector<std::string_view> all;
    for (std::size_t comma; (comma = line.find(',')) != line.npos; line.remove_prefix(comma + 1))
        all.push_back(trimmed(line.substr(0, comma)));
    all.push_back(trimmed(line));
    return all;
}

/// The whole of `text` as a number, possibly not a finite one.
std::optional<double> number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double x = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return x;
}

/// A header has words only: a column that begins as a number does is a number with a slip in it.
bool is_word(std::string_view text) { return !text.empty() && !number(text) && text.find_first_of("0123456789+-.") != 0; }

/// Fit for a message: short, and without what a file of another kind would do to a terminal.
std::string quoted(std::string_view text) {
    constexpr std::size_t most = 40;
    std::string plain(text.substr(0, most));
    std::replace_if(plain.begin(), plain.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return '"' + plain + (text.size() > most ? "...\"" : "\"");
}

std::string count(std::size_t n, const std::string& what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

std::string shown(double x) {
    std::ostringstream text;
    text.precision(12);
    text << x;
    return text.str();
}

std::string range(const abi::Box& box, int a) {
    const std::string ends = "[" + shown(box.lower[a]) + ", " + shown(box.upper[a]);
    return box.periodic[a] ? "periodic box, " + ends + ")" : "box, " + ends + "]";
}

}    // namespace

/// One particle per line, its coordinates [m] separated by commas: x, or x,y, or x,y,z. The first line may name the
/// columns; lines that are empty or begin with # are passed over. Each particle stands for the volume dx^d: choose dx so
/// that n dx^d is what the n particles fill.
struct Points final : abi::Arrangement {
    std::string path;

    static constexpr auto parameters() {
        return std::array{file("file", &Points::path, "CSV file: one particle per line, one column per dimension [m]")};
    }

    void prepare(const abi::Box& box) override {
        if (path.empty()) throw std::invalid_argument("file is missing: name a CSV file, one particle per line");
        read(box);
        if (line_of.size() < 2)
            refuse(path, "it holds " + count(line_of.size(), "particle"), "Give two or more, one per line");
        check_places(box);
        check_volume(box);
    }

    bool regular() const override { return false; }
    long size(const abi::Box&) const override { return long(line_of.size()); }
    void place(const abi::Box& box, double* const out[3]) const override {
        for (int a = 0; a < box.dimension; ++a) std::copy(x[a].begin(), x[a].end(), out[a]);
    }

private:
    std::vector<double> x[3];     ///< [m]
    std::vector<long> line_of;    ///< where each particle stands in the file

    [[noreturn]] static void refuse(const std::string& place, const std::string& problem, const std::string& remedy) {
        throw std::invalid_argument(place + ": " + problem + ". " + remedy);
    }
    std::string at(long line) const { return path + ":" + std::to_string(line); }

    void read(const abi::Box& box) {
        std::ifstream in(path);
        if (!in) refuse(path, "cannot be opened", "Check that the file exists and may be read");
        bool first = true;
        long line = 0;
        for (std::string whole; std::getline(in, whole);) {
            std::string_view text = whole;
            if (++line == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);    // byte order mark
            text = trimmed(text);
            if (text.empty() || text.starts_with('#')) continue;
            const auto column = columns(text);
            if (int(column.size()) != box.dimension)
                refuse(at(line), quoted(text) + " has " + count(column.size(), "column"),
                       "Give " + std::to_string(box.dimension) + ", separated by commas");
            if (!std::exchange(first, false) || !std::all_of(column.begin(), column.end(), is_word)) add(box, column, line);
        }
        if (in.bad()) refuse(path, "cannot be read", "Give a CSV file");
    }

    void add(const abi::Box& box, const std::vector<std::string_view>& column, long line) {
        for (int a = 0; a < box.dimension; ++a) {
            const std::string_view text = column[std::size_t(a)];
            const auto value = number(text);
            if (!value || !std::isfinite(*value))
                refuse(at(line), quoted(text) + " is not a finite number", "Give a coordinate in metres");
            const double slack = box.periodic[a] ? 0 : 1e-9 * box.dx;    // the last site of a lattice may round beyond its end
            const bool below_end = box.periodic[a] ? *value < box.upper[a] : *value <= box.upper[a] + slack;
            if (*value < box.lower[a] - slack || !below_end)
                refuse(at(line), std::string(1, "xyz"[a]) + " = " + std::string(text) + " is outside the " + range(box, a),
                       "Move the particle or the box");
            x[a].push_back(*value);
        }
        line_of.push_back(line);
    }

    /// Two particles at one place are next to each other along any direction; along this one few others are,
    /// and none of a lattice.
    void check_places(const abi::Box& box) const {
        constexpr double direction[3] = {1, 0.7548776662466927, 0.5698402909980532};
        const double same = 1e-6 * box.dx;
        const auto place = [&](int a, long i) {
            const double value = x[a][std::size_t(i)];
            return box.periodic[a] && value > box.upper[a] - same ? value - (box.upper[a] - box.lower[a]) : value;
        };
        std::vector<std::pair<double, long>> along(line_of.size());
        for (std::size_t i = 0; i < along.size(); ++i) {
            along[i].second = long(i);
            for (int a = 0; a < box.dimension; ++a) along[i].first += direction[a] * place(a, long(i));
        }
        std::sort(along.begin(), along.end());
        for (std::size_t i = 0; i < along.size(); ++i)
            for (std::size_t j = i + 1; j < along.size() && along[j].first - along[i].first <= 3 * same; ++j) {
                const auto [one, other] = std::minmax(along[i].second, along[j].second);
                bool apart = false;
                for (int a = 0; a < box.dimension; ++a) apart = apart || std::abs(place(a, one) - place(a, other)) > same;
                if (!apart)
                    refuse(at(line_of[std::size_t(other)]),
                           "the particle is at the place of that of line " + std::to_string(line_of[std::size_t(one)]),
                           "Remove one of them");
            }
    }

    /// Where the whole box is filled, the particles' volumes make up its own.
    void check_volume(const abi::Box& box) const {
        double whole = 1;
        for (int a = 0; a < box.dimension; ++a) {
            if (!box.periodic[a]) return;
            whole *= box.upper[a] - box.lower[a];
        }
        const double n = double(line_of.size()), filled = n * volume(box);
        if (std::abs(filled - whole) <= 0.01 * whole) return;
        refuse(path,
               "its " + count(line_of.size(), "particle") + " of volume dx^d fill " + shown(filled) +
                   " of the periodic box's " + shown(whole) + " m^d",
               "Set dx to " + shown(std::pow(whole / n, 1. / box.dimension)));
    }
};

SPHONIC_ARRANGEMENT("points", Points, "Particles from a CSV file; n dx^d is the volume that they fill")
