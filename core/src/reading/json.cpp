#include <sphonic/json.hpp>

#include <sphonic/error.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <vector>

namespace sphonic {
namespace {

constexpr std::size_t max_depth = 64;

std::string in_quotes(std::string_view text) { return '"' + std::string(text) + '"'; }

/// Why the text is no JSON; `at` is the offset of the last byte looked at.
struct Syntax { std::size_t at; std::string reason, remedy = {}; };

/// Builds the document from the parser's events; the open containers are a stack of its own, so depth costs no calls.
class Builder : public nlohmann::json_sax<Json> {
public:
    explicit Builder(std::string file) : file_(std::move(file)) {}

    Json root;
    std::optional<Syntax> syntax;
    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return open_.pop_back(), true; }
    bool end_array() override { return open_.pop_back(), true; }

    bool string(string_t& value) override {
        if (value.find('\0') != value.npos) refuse("the text has a NUL character", "Remove it");
        return put(std::move(value));
    }

    bool number_float(number_float_t value, const string_t& text) override {
        if (value == 0 && text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != text.npos)
            refuse("the number " + text + " is too small for a double", "Write 0");
        return put(value);
    }

    bool key(string_t& name) override {
        open_.back().key = name;
        if (open_.back().node->contains(name)) refuse("the key " + in_quotes(name) + " is given twice", "Remove one of them");
        return true;
    }

    bool parse_error(std::size_t end, const std::string& token, const nlohmann::detail::exception& error) override {
        if (error.id == 406)    // nlohmann's "number overflow"
            refuse("the number " + token + " is too large for a double", "Write a smaller number");
        const std::string message = error.what();
        const std::size_t from = message.find(" - ") + 3;
        syntax = Syntax{end == 0 ? 0 : end - 1, message.substr(from, message.find("; last read: '") - from)};
        return false;
    }

private:
    struct Frame { Json* node; std::string key; };

    [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
        Json::json_pointer at;
        for (const auto& [node, key] : open_)
            at /= node->is_array() ? std::to_string(node->size() - (node != open_.back().node)) : key;
        throw Error(Fault::input, file_ + ": " + (at.empty() ? "/" : at.to_string()), problem, remedy);
    }

    Json& slot() {
        if (open_.empty()) return root;
        const auto& [node, key] = open_.back();
        return node->is_array() ? node->emplace_back() : (*node)[key];
    }

    bool put(Json value) { return slot() = std::move(value), true; }

    bool open(Json container) {
        if (open_.size() == max_depth) refuse("more than " + std::to_string(max_depth) + " values are nested", "Nest less deeply");
        return open_.push_back({&(slot() = std::move(container)), {}}), true;
    }

    std::string file_;
    std::vector<Frame> open_;
};

std::optional<Syntax> parse(std::string_view text, Builder& builder) {
    if (text.starts_with("\xEF\xBB\xBF"))
        return Syntax{0, "the text begins with a byte-order mark", "Save it as UTF-8 without one"};
    if (text.find_first_not_of(" \t\r\n") == text.npos)
        return Syntax{0, "the text is empty", "Write a JSON value"};
    if (const std::size_t nul = text.find('\0'); nul != text.npos)
        return Syntax{nul, "the text has a NUL byte", "Remove it"};
    Json::sax_parse(text, &builder);
    return builder.syntax;
}

std::string remedy_for(const std::string& word, const std::string& reason, const std::string& head) {
    if (word == "NaN" || word.ends_with("Infinity")) return "Write a finite number";
    if (reason.ends_with("expected end of input")) return "Remove what follows the first value";
    const bool after_comma = head.substr(0, head.find_last_not_of(" \t\r\n") + 1).ends_with(',');
    return after_comma && (word == "}" || word == "]") ? "Remove the comma before it" : "Correct the JSON there";
}

[[noreturn]] void refuse_syntax(std::string_view text, const std::string& file, Syntax syntax) {
    const auto in_word = [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; };
    const bool literal = syntax.reason == "invalid literal" || syntax.reason.starts_with("invalid number");
    std::size_t from = std::min(syntax.at, text.size()), to = std::min(from + 1, text.size());
    const bool inside = from < to && in_word(text[from]);
    while ((literal || inside) && from > 0 && in_word(text[from - 1]))
        --from;
    while (inside && to < text.size() && in_word(text[to]))
        ++to;
    const std::string word(text.substr(from, to - from)), head(text.substr(0, from));
    if (literal && !word.empty())
        syntax.reason = (word[0] > ' ' && word[0] <= '~' ? in_quotes(word) : "this character") + " is not JSON";
    if (const std::size_t expected = syntax.reason.find("; expected"); expected != std::string::npos)
        syntax.reason[expected] = ',';
    if (syntax.remedy.empty()) syntax.remedy = remedy_for(word, syntax.reason, head);
    const auto line = 1 + std::count(head.begin(), head.end(), '\n');
    const auto column = from - head.rfind('\n');    // npos is -1: the first line needs no case of its own
    const std::string place = file + ":" + std::to_string(line) + ":" + std::to_string(column);
    throw Error(Fault::input, place, syntax.reason, syntax.remedy);
}

std::vector<std::string> tokens_of(const std::string& pointer, const std::string& place) {
    std::vector<std::string> tokens;
    try {
        for (Json::json_pointer left(pointer); !left.empty(); left.pop_back())
            tokens.insert(tokens.begin(), left.back());
    } catch (const Json::parse_error&) { tokens.clear(); }
    if (tokens.empty() || tokens.size() > max_depth || std::count(tokens.begin(), tokens.end(), "") > 0)
        throw Error(Fault::input, place, in_quotes(pointer) + " does not point to a member",
                    "Write it as /object/key, at most " + std::to_string(max_depth) + " deep, ~0 for ~ and ~1 for /");
    return tokens;
}

/// The member of `node`, which stands at `path`; made if it is missing.
Json& member(Json& node, const std::string& token, const std::string& path, const std::string& place) {
    if (node.is_null() || node.is_object())
        return node[token];
    if (!node.is_array())
        throw Error(Fault::input, place, path + " is a " + node.type_name() + " and has no members", "Shorten it");
    for (std::size_t i = 0; i < node.size(); ++i)
        if (token == std::to_string(i))
            return node[i];
    const std::string size = std::to_string(node.size());
    if (token != "-" && token != size)
        throw Error(Fault::input, place, in_quotes(token) + " is no index of " + path + " (" + size + " entries)",
                    "Write an index up to " + size + ", or - to append");
    return node.emplace_back();
}

}    // namespace

Json parse_json(std::string_view text, const std::string& file) {
    Builder builder(file);
    if (const std::optional<Syntax> syntax = parse(text, builder))
        refuse_syntax(text, file, *syntax);
    return std::move(builder.root);
}

Json read_json(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw Error(Fault::input, file.string(), "there is no such file", "Check the path");
    std::ifstream stream(file, std::ios::binary);
    std::string text;
    for (char byte; stream.get(byte);) text += byte;
    if (!stream.eof())
        throw Error(Fault::io, file.string(), "this cannot be read", "Name a file with read permission");
    return parse_json(text, file.string());
}

void set_at(Json& root, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == assignment.npos)
        throw Error(Fault::input, "--set", in_quotes(assignment) + " has no \"=\"", "Write /pointer=value");
    const std::string pointer = assignment.substr(0, equals), text = assignment.substr(equals + 1);
    Builder builder("--set " + pointer);
    set_at(root, pointer, parse(text, builder) ? Json(text) : builder.root, "--set");
}

void set_at(Json& root, const std::string& pointer, const Json& value, const std::string& place) {
    Json* node = &root;
    Json::json_pointer path;
    for (const std::string& token : tokens_of(pointer, place)) {
        node = &member(*node, token, path.empty() ? "/" : path.to_string(), place);
        path /= token;
    }
    *node = value;
}

std::string json_text(const Json& value) { return value.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

}    // namespace sphonic
