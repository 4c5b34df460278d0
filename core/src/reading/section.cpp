#include "section.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>
#include <sphonic/parameters.hpp>

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

std::string escaped(const std::string& key) {
    std::string token;
    for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return token;
}

}    // namespace

std::string shown(const Json& value) {
    std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
}

std::string join(std::span<const std::string> names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

abi::ParameterInfo real_row(const char* name, const char* unit, double lower, double upper, const char* doc,
                            double initial) {
    return {name, unit, lower, upper, doc, "", {.type = abi::ParameterType::real, .real = initial}};
}

double finite_number(const Json& value, const std::string& place) {
    if (!value.is_number()) throw Error(Fault::input, place, shown(value) + " is not a number", "Give a number");
    const double x = value.get<double>();
    if (!std::isfinite(x)) throw Error(Fault::input, place, "the number is not finite", "Give a finite number");
    return x;
}

Section::Section(const Json& value, std::string file, std::string pointer)
    : value_(value), file_(std::move(file)), pointer_(std::move(pointer)) {
    if (!value.is_object()) fail("", shown(value) + " is not an object", "Write { ... } here");
}

std::string Section::place(const std::string& key) const {
    const std::string at = key.empty() ? pointer_ : pointer_ + "/" + escaped(key);
    return file_ + ": " + (at.empty() ? "/" : at);
}

void Section::fail(const std::string& key, const std::string& problem, const std::string& remedy) const {
    throw Error(Fault::input, place(key), problem, remedy);
}

bool Section::has(const std::string& key) {
    known_.insert(key);
    return value_.contains(key);
}

const Json* Section::find(const std::string& key) {
    known_.insert(key);
    const auto member = value_.find(key);
    return member == value_.end() ? nullptr : &*member;
}

const Json& Section::need(const std::string& key, const std::string& remedy) {
    if (const Json* member = find(key)) return *member;
    const std::string name[] = {key};
    for (const auto& [other, member] : value_.items())
        if (!known_.count(other) && !nearest(other, name).empty())
            fail(other, "unknown key \"" + other + "\"", "Did you mean \"" + key + "\"?");
    fail(key, "is missing", remedy);
}

Section Section::child(const std::string& key, const std::string& remedy) {
    return {need(key, remedy), file_, pointer_ + "/" + escaped(key)};
}

std::string Section::text(const std::string& key, const std::string& fallback) {
    const Json* member = find(key);
    if (member && !member->is_string()) fail(key, shown(*member) + " is not a string", "Give a string");
    return (resolved[key] = member ? member->get<std::string>() : fallback).get<std::string>();
}

std::string Section::choice(const std::string& key, const std::string& fallback,
                            const std::vector<std::string>& choices) {
    const std::string chosen = text(key, fallback);
    if (std::find(choices.begin(), choices.end(), chosen) != choices.end()) return chosen;
    const std::string near = nearest(chosen, choices);
    fail(key, "\"" + chosen + "\" is not one of " + join(choices), near.empty() ? "" : "Did you mean \"" + near + "\"?");
}

abi::Value Section::read(const abi::ParameterInfo& row) {
    const Json* member = find(row.name);
    if (!member) {
        if (is_required(row)) fail(row.name, "is missing", range_sentence(row));
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
            if (!member->is_number_integer()) fail(row.name, shown(*member) + " is not an integer", "Give an integer");
            value.integer = member->get<std::int64_t>();
            if (!in_range(row, double(value.integer))) fail(row.name, shown(*member) + " is out of range", range_sentence(row));
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
        case abi::ParameterType::vector: {
            if (!member->is_array() || member->empty() || member->size() > 3)
                fail(row.name, shown(*member) + " is not a list of one to three numbers", "Give one number per dimension");
            for (const Json& x : *member) {
                value.vector[value.size] = finite_number(x, place(row.name) + "/" + std::to_string(value.size));
                if (!in_range(row, value.vector[value.size])) fail(row.name, shown(x) + " is out of range", range_sentence(row));
                ++value.size;
            }
        }
    }
    resolved[row.name] = *member;
    return value;
}

/// The whole path of a file that is named as seen from the case's folder; so resolved, the case runs from anywhere.
abi::Value Section::read_file(const abi::ParameterInfo& row, const std::string& name) {
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
    const std::string form = "Give a list of " + std::to_string(dimension) + (dimension == 1 ? " number" : " numbers");
    const Json& list = need(key, form);
    if (!list.is_array() || int(list.size()) != dimension)
        fail(key, shown(list) + " does not fit dimension " + std::to_string(dimension), form);
    std::vector<double> x;
    for (const Json& entry : list) x.push_back(finite_number(entry, place(key) + "/" + std::to_string(x.size())));
    resolved[key] = list;
    return x;
}

void Section::finish() const {
    const std::vector<std::string> known(known_.begin(), known_.end());
    for (const auto& [key, member] : value_.items()) {
        if (known_.count(key)) continue;
        const std::string near = nearest(key, known);
        fail(key, "unknown key \"" + key + "\"",
             near.empty() ? "Known here: " + join(known) : "Did you mean \"" + near + "\"?");
    }
}

}    // namespace sphonic
