/// Values of a section by the rows of parameter tables.
#include <cmath>
#include <filesystem>

#include <sphonic/error.hpp>
#include <sphonic/parameters.hpp>

#include "section.hpp"

namespace sphonic {
namespace {

bool in_range(const abi::ParameterInfo& row, double x) { return x >= row.lower && x <= row.upper; }

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t bar; (bar = text.find('|', begin)) != std::string::npos; begin = bar + 1)
        parts.push_back(text.substr(begin, bar - begin));
    parts.push_back(text.substr(begin));
    return parts;
}

}    // namespace

abi::ParameterInfo real_row(const char* name, const char* unit, double lower, double upper, const char* doc,
                            double initial) {
    return {name, unit, lower, upper, doc, "", {.type = abi::ParameterType::real, .real = initial}};
}

std::optional<std::int64_t> whole_number(const Json& value) {
    constexpr double exact = 9007199254740992;    // 2^53: beyond it a double skips integers
    if (value.is_number_integer()) return value.get<std::int64_t>();
    const double x = value.is_number() ? value.get<double>() : 0.5;
    if (x != std::floor(x) || std::abs(x) > exact) return std::nullopt;
    return std::int64_t(x);
}

std::string list_remedy(int dimension) {
    return "Give a list of " + std::to_string(dimension) + (dimension == 1 ? " number" : " numbers");
}

double finite_number(const Json& value, const std::string& place) {
    if (!value.is_number()) throw Error(Fault::input, place, shown(value) + " is not a number", "Give a number");
    const double x = value.get<double>();
    if (!std::isfinite(x)) throw Error(Fault::input, place, "the number is not finite", "Give a finite number");
    return x;
}

abi::Value Section::read(const abi::ParameterInfo& row) {
    const Json* member = find(row.name);
    if (!member) {
        if (is_required(row)) need(row.name, range_sentence(row));
        if (row.initial.type != abi::ParameterType::vector || row.initial.size > 0) resolved[row.name] = to_json(row.initial);
        return row.initial;
    }
    abi::Value value{.type = row.initial.type};
    switch (value.type) {
        case abi::ParameterType::real:
            value.real = finite_number(*member, place(row.name));
            if (!in_range(row, value.real)) fail(row.name, shown(*member) + " is out of range", range_sentence(row));
            break;
        case abi::ParameterType::integer:
            if (!whole_number(*member)) fail(row.name, shown(*member) + " is not an integer", "Give an integer");
            value.integer = *whole_number(*member);
            if (!in_range(row, member->get<double>())) fail(row.name, shown(*member) + " is out of range", range_sentence(row));
            break;
        case abi::ParameterType::boolean:
            if (!member->is_boolean()) fail(row.name, shown(*member) + " is not true or false", "Give true or false");
            value.boolean = member->get<bool>();
            break;
        case abi::ParameterType::text:
            if (row.choices[0]) choice(row.name, "", split(row.choices));
            if (!member->is_string()) fail(row.name, shown(*member) + " is not a string", "Give a string");
            value.text = member->get_ptr<const std::string*>()->c_str();
            if (row.unit == std::string(abi::file_unit)) return read_file(row, value.text);
            break;
        case abi::ParameterType::vector: value = read_vector(row, *member);
    }
    resolved[row.name] = *member;
    return value;
}

abi::Value Section::read_vector(const abi::ParameterInfo& row, const Json& list) const {
    if (!list.is_array() || list.empty() || list.size() > 3)
        fail(row.name, shown(list) + " is not a list of one to three numbers", "Give one number per dimension");
    abi::Value value{.type = abi::ParameterType::vector};
    for (const Json& x : list) {
        value.vector[value.size] = finite_number(x, place(row.name) + "/" + std::to_string(value.size));
        if (!in_range(row, value.vector[value.size])) fail(row.name, shown(x) + " is out of range", range_sentence(row));
        ++value.size;
    }
    return value;
}

/// The whole path of a file that is named as seen from the case's folder; so resolved, the case runs from anywhere.
abi::Value Section::read_file(const abi::ParameterInfo& row, const std::string& name) {
    if (name.empty()) fail(row.name, "\"\" names no file", "Name one as seen from the case's folder");
    const auto folder = std::filesystem::path(file_).parent_path();
    paths_.push_back(std::filesystem::absolute(folder / name).lexically_normal().string());
    resolved[row.name] = paths_.back();
    return {.type = abi::ParameterType::text, .text = paths_.back().c_str()};
}

std::vector<abi::Value> Section::read(std::span<const abi::ParameterInfo> table) {
    std::vector<abi::Value> values;
    for (const abi::ParameterInfo& row : table) values.push_back(read(row));
    return values;
}

double Section::real(const abi::ParameterInfo& row) { return read(row).real; }

std::optional<double> Section::optional_real(const abi::ParameterInfo& row) {
    if (!find(row.name)) return std::nullopt;
    return read(row).real;
}

std::vector<double> Section::point(const std::string& key, int dimension) {
    const std::string form = list_remedy(dimension);
    const Json& list = need(key, form);
    if (!list.is_array() || int(list.size()) != dimension)
        fail(key, shown(list) + " does not fit dimension " + std::to_string(dimension), form);
    std::vector<double> x;
    for (const Json& entry : list) x.push_back(finite_number(entry, place(key) + "/" + std::to_string(x.size())));
    resolved[key] = list;
    return x;
}

}    // namespace sphonic
