#pragma once
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <sphonic/json.hpp>
#include <sphonic/parameters.hpp>
#include <sphonic/plugin/abi/entry.hpp>

namespace sphonic {

/// One JSON object being read. Every key must be asked for: `finish` refuses the rest with the nearest name.
/// What is read, and each default used, goes to `resolved` in the order of reading.
class Section {
public:
    /// `value` and the section must outlive every abi::Value read from it.
    Section(const Json& value, std::string file, std::string pointer);

    /// Marks the key as known.
    bool has(const std::string& key);
    /// The member, or null; marks the key as known.
    const Json* find(const std::string& key);
    /// The member; an error with the remedy if it is missing.
    const Json& need(const std::string& key, const std::string& remedy);
    Section child(const std::string& key, const std::string& remedy);

    std::string text(const std::string& key, const std::string& fallback);
    std::string choice(const std::string& key, const std::string& fallback, const std::vector<std::string>& choices);
    double real(const abi::ParameterInfo& row);
    std::optional<double> optional_real(const abi::ParameterInfo& row);
    /// Refuses common keys of a kind that do not stand together as `rule` wants it.
    void obey(const KeyRule& rule, const std::string& kind, int dimension);
    /// d finite numbers.
    std::vector<double> point(const std::string& key, int dimension);

    /// The default if the key is missing; an error if there is none (a default outside its own range).
    abi::Value read(const abi::ParameterInfo& row);
    std::vector<abi::Value> read(std::span<const abi::ParameterInfo> table);

    /// Editors find the schema of a file by the key "$schema".
    void pass_over_schema();
    void finish() const;

    /// "FILE: /pointer" of this object or of one of its members.
    std::string place(const std::string& key = {}) const;
    [[noreturn]] void fail(const std::string& key, const std::string& problem, const std::string& remedy = {}) const;
    const std::string& file() const { return file_; }
    const std::string& pointer() const { return pointer_; }
    const Json& value() const { return value_; }

    Json resolved = Json::object();

private:
    const Json& value_;
    std::string file_, pointer_;
    std::set<std::string> known_;
    std::deque<std::string> paths_;    ///< that values point to

    abi::Value read_file(const abi::ParameterInfo& row, const std::string& name);
    abi::Value read_vector(const abi::ParameterInfo& row, const Json& list) const;
    /// For a key that is missing: an unknown one near to it is more likely a typo.
    void refuse_typo(const std::string& key) const;
};

/// A parameter row of a key that stands in no table of `common_keys`.
abi::ParameterInfo real_row(const char* name, const char* unit, double lower, double upper, const char* doc,
                            double initial = 0);

/// The integer that a number is, be it written 3 or 3.0.
std::optional<std::int64_t> whole_number(const Json& value);
/// "Give a list of 2 numbers".
std::string list_remedy(int dimension);
/// A finite number, or an error at `place`.
double finite_number(const Json& value, const std::string& place);
/// "string \"a\"", "number 3", ... for messages.
std::string shown(const Json& value);
std::string join(std::span<const std::string> names);

}    // namespace sphonic
