#include "section.hpp"

#include <algorithm>

#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>
#include <sphonic/parameters.hpp>

namespace sphonic {
namespace {

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
    refuse_typo(key);
    fail(key, "is missing", remedy);
}

void Section::refuse_typo(const std::string& key) const {
    const std::string name[] = {key};
    for (const auto& [other, member] : value_.items())
        if (!known_.count(other) && !nearest(other, name).empty())
            fail(other, "unknown key \"" + other + "\"", "Did you mean \"" + key + "\"?");
}

void Section::obey(const KeyRule& rule, const std::string& kind, int dimension) {
    using enum KeyRule::How;
    if (rule.how == required || rule.how == required_to_impose) {
        for (const std::string& key : rule.keys) {
            const abi::ParameterInfo& row = common_key(kind, key);
            const bool vector = row.initial.type == abi::ParameterType::vector;
            need(key, rule.remedy[0] ? rule.remedy : vector ? list_remedy(dimension) : range_sentence(row));
        }
        return;
    }
    std::vector<std::string> given;
    for (const std::string& key : rule.keys)
        if (has(key)) given.push_back(key);
    if (given.size() > 1)
        fail(rule.how == exactly_one ? "" : given[1], given[0] + " and " + given[1] + " are both given", rule.remedy);
    if (rule.how == at_most_one || !given.empty()) return;
    for (const std::string& key : rule.keys) refuse_typo(key);
    fail("", std::string(rule.what) + " is missing", rule.remedy);
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

void Section::pass_over_schema() {
    const Json* schema = find("$schema");
    if (schema && !schema->is_string()) fail("$schema", shown(*schema) + " is not a string", "Give a string");
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
