#include <span>

#include <sphonic/parameters.hpp>
#include <sphonic/version.hpp>

#include "plugin_rows.hpp"

namespace sphonic::driver {
namespace {

/// Text that no reader of Markdown takes for a mark.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '|' || c == '*' || c == '<' || c == '\\' || c == '`' || c == '_') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out;
}

/// A table ends a code span at no bar but an escaped one.
std::string code(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
    return out.empty() ? "" : "`" + out + "`";
}

std::string cell_default(const std::string& shown) { return shown == "required" ? shown : code(shown); }

std::string row(const abi::ParameterInfo& r, const std::string& initial) {
    return "| " + code(r.name) + " | " + escaped(r.unit) + " | " + cell_default(initial) + " | " + code(range_short(r)) + " | " +
           escaped(r.doc) + " |\n";
}

const std::string head = "| key | unit | default | values | what it is |\n|---|---|---|---|---|\n";

std::string sentence(const KeyRule& rule) {
    using enum KeyRule::How;
    std::string keys;
    for (std::size_t i = 0; i < rule.keys.size(); ++i)
        keys += (i == 0 ? "" : i + 1 == rule.keys.size() ? " and " : ", ") + code(rule.keys[i]);
    switch (rule.how) {
        case required: return "";
        case required_to_impose: return "\nSources that impose values must have " + keys + ".\n";
        case exactly_one: return "\nExactly one of " + keys + " must be given.\n";
        case at_most_one: return "\nAt most one of " + keys + " may be given.\n";
    }
    return "";
}

std::string section(const Plugin& plugin) {
    std::string text = "\n### " + escaped(plugin.name) + "\n\n" + escaped(plugin.doc) + "\n";
    if (!plugin.parameters.empty()) text += "\n" + head;
    for (const auto& r : plugin.parameters) text += row(r, shown_default(r));
    return text;
}

std::string common_section(const std::string& kind) {
    if (common_keys(kind).empty()) return "";
    std::string text = "\n### Keys of every " + kind + "\n\n" + head;
    for (const auto& r : common_keys(kind)) text += row(r, shown_default(r, kind));
    for (const KeyRule& rule : key_rules(kind)) text += sentence(rule);
    return text;
}

}    // namespace

std::string plugins_markdown(const std::vector<const Plugin*>& plugins) {
    std::string text = std::string("# Plugins of sphonic ") + version() + "\n";
    for (std::size_t i = 0; i < plugins.size(); ++i) {
        const std::string& kind = plugins[i]->kind;
        if (i == 0 || plugins[i - 1]->kind != kind) text += "\n## " + escaped(kind) + "\n";
        text += section(*plugins[i]);
        if (i + 1 == plugins.size() || plugins[i + 1]->kind != kind) text += common_section(kind);
    }
    return text;
}

}    // namespace sphonic::driver
