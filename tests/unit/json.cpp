#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/nearest.hpp>

#include <catch2/catch.hpp>

#include <bit>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

using namespace sphonic;

namespace {

/// The error's text after its fault's number, or "no error".
template <class Action>
std::string refusal(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return std::to_string(static_cast<int>(error.fault)) + " " + error.what();
    }
    return "no error";
}

struct Refused { std::string text, message; };
struct Assigned { std::string assignment, result; };

std::string repeated(const std::string& part, int times) {
    std::string all;
    while (times-- > 0)
        all += part;
    return all;
}

}    // namespace

TEST_CASE("JSON that says one thing is read in the order of the file") {
    const std::string text = R"({"z":[1,-2,0.5,18446744073709551615],"a":{"s":"x","t":true,"n":null},"e":{},"l":[]})";
    CHECK(parse_json("\n " + text + "\n", "case.json").dump() == text);
    CHECK(parse_json("[0e9,0.0]", "case.json").dump() == "[0.0,0.0]");
}

TEST_CASE("JSON that is syntactically valid but ambiguous or out of range is refused at its pointer") {
    const auto [text, message] = GENERATE(values<Refused>({
        {R"({"kernel":{"h":1,"h":2}})", R"(/kernel/h: the key "h" is given twice. Remove one of them)"},
        {R"([[],{},[1,{"a":1,"a":2}]])", R"(/2/1/a: the key "a" is given twice. Remove one of them)"},
        {R"({"a/b~":{"c":1,"c":1}})", R"(/a~1b~0/c: the key "c" is given twice. Remove one of them)"},
        {"1e999", "/: the number 1e999 is too large for a double. Write a smaller number"},
        {R"({"a":[1,-1e999]})", "/a/1: the number -1e999 is too large for a double. Write a smaller number"},
        {R"({"a":1e-999})", "/a: the number 1e-999 is too small for a double. Write 0"},
    }));
    const std::string source = text;
    CHECK(refusal([&] { parse_json(source, "case.json"); }) == "2 case.json: " + message);
}

TEST_CASE("text that is no JSON is refused at its line and column") {
    const auto [text, message] = GENERATE(values<Refused>({
        {"", "1:1: the text is empty. Write a JSON value"},
        {" \n ", "1:1: the text is empty. Write a JSON value"},
        {"\xEF\xBB\xBF{}", "1:1: the text begins with a byte-order mark. Save it as UTF-8 without one"},
        {std::string("{}\0x", 4), "1:3: the text has a NUL byte. Remove it"},
        {R"({"a": NaN})", R"(1:7: "NaN" is not JSON. Write a finite number)"},
        {"[1,\n -Infinity]", R"(2:2: "-Infinity" is not JSON. Write a finite number)"},
        {"[1,]", "1:4: unexpected ']', expected '[', '{', or a literal. Remove the comma before it"},
        {"{\"a\":1,\n}", "2:1: unexpected '}', expected string literal. Remove the comma before it"},
        {"{} {}", "1:4: unexpected '{', expected end of input. Remove what follows the first value"},
        {"{}\n  123", "2:3: unexpected number literal, expected end of input. Remove what follows the first value"},
        {"{}\n// note", R"(2:1: "/" is not JSON. Correct the JSON there)"},
        {"{\n  'a': 1}", R"(2:3: "'" is not JSON. Correct the JSON there)"},
        {"[True]", R"(1:2: "True" is not JSON. Correct the JSON there)"},
        {"[+1]", R"(1:2: "+1" is not JSON. Correct the JSON there)"},
        {"[01]", "1:2: unexpected number literal, expected ']'. Correct the JSON there"},
        {R"({"a":)", "1:6: unexpected end of input, expected '[', '{', or a literal. Correct the JSON there"},
        {"[\"a", "1:4: invalid string: missing closing quote. Correct the JSON there"},
        {"[\"\xff\"]", "1:3: invalid string: ill-formed UTF-8 byte. Correct the JSON there"},
        {"\xff\xfe[]", "1:1: this character is not JSON. Correct the JSON there"},
    }));
    const std::string source = text;
    CHECK(refusal([&] { parse_json(source, "case.json"); }) == "2 case.json:" + message);
}

TEST_CASE("values nest 64 deep and no deeper") {
    const std::string allowed = repeated("[", 64) + repeated("]", 64);
    CHECK(parse_json(allowed, "case.json").dump() == allowed);
    const std::string rest = ": more than 64 values are nested. Nest less deeply";
    const std::string arrays = "2 case.json: " + repeated("/0", 64) + rest;
    CHECK(refusal([&] { parse_json("[" + allowed + "]", "case.json"); }) == arrays);
    CHECK(refusal([&] { parse_json(repeated("[", 100000), "case.json"); }) == arrays);
    const std::string objects = repeated("{\"a\":", 100000);
    CHECK(refusal([&] { parse_json(objects, "case.json"); }) == "2 case.json: " + repeated("/a", 64) + rest);
}

TEST_CASE("a JSON file is read and named in its errors") {
    const auto folder = std::filesystem::temp_directory_path() / "sphonic-unit-json";
    std::filesystem::create_directories(folder);
    const std::string file = (folder / "case.json").string();
    std::ofstream(file) << R"({"h": 0.5})";
    CHECK(read_json(file).at("h") == 0.5);
    std::ofstream(file) << R"({"h": 1, "h": 2})";
    CHECK(refusal([&] { read_json(file); }) == "2 " + file + ": /h: the key \"h\" is given twice. Remove one of them");
    std::filesystem::remove_all(folder);
    CHECK(refusal([&] { read_json(file); }) == "2 " + file + ": there is no such file. Check the path");
    CHECK(refusal([] { read_json("/"); }) == "5 /: this cannot be read. Name a file with read permission");
}

TEST_CASE("an assignment sets the member that its pointer names") {
    const auto [assignment, result] = GENERATE(values<Assigned>({
        {"/s=2.5", R"({"l":[1,2],"s":2.5})"},
        {"/s=", R"({"l":[1,2],"s":""})"},
        {"/s=nan", R"({"l":[1,2],"s":"nan"})"},
        {"/s=0 <= x == 9", R"({"l":[1,2],"s":"0 <= x == 9"})"},
        {"/s=\"7\"", R"({"l":[1,2],"s":"7"})"},
        {"/a/b={\"c\":[true]}", R"({"l":[1,2],"s":"t","a":{"b":{"c":[true]}}})"},
        {"/a~1b~0=null", R"({"l":[1,2],"s":"t","a/b~":null})"},
        {"/l/0=5", R"({"l":[5,2],"s":"t"})"},
        {"/l/2=5", R"({"l":[1,2,5],"s":"t"})"},
        {"/l/-/k=5", R"({"l":[1,2,{"k":5}],"s":"t"})"},
    }));
    Json root = Json::parse(R"({"l":[1,2],"s":"t"})");
    set_at(root, assignment);
    CHECK(root.dump() == result);
}

TEST_CASE("an assignment that names no place is refused and changes nothing") {
    const std::string form = " does not point to a member. "
                             "Write it as /object/key, at most 64 deep, ~0 for ~ and ~1 for /";
    const std::string index = R"( is no index of /l (2 entries). Write an index up to 2, or - to append)";
    const auto [assignment, message] = GENERATE_COPY(values<Refused>({
        {"/s", R"(--set: "/s" has no "=". Write /pointer=value)"},
        {"=1", "--set: \"\"" + form},
        {"s=1", "--set: \"s\"" + form},
        {"/=1", "--set: \"/\"" + form},
        {"/a//b=1", "--set: \"/a//b\"" + form},
        {"/a~2=1", "--set: \"/a~2\"" + form},
        {repeated("/a", 65) + "=1", "--set: \"" + repeated("/a", 65) + "\"" + form},
        {"/l/3=1", "--set: \"3\"" + index},
        {"/l/01=1", "--set: \"01\"" + index},
        {"/l/x=1", "--set: \"x\"" + index},
        {"/s/t=1", "--set: /s is a string and has no members. Shorten it"},
        {R"(/s={"a":1,"a":2})", R"(--set /s: /a: the key "a" is given twice. Remove one of them)"},
        {"/s=1e999", "--set /s: /: the number 1e999 is too large for a double. Write a smaller number"},
    }));
    Json root = Json::parse(R"({"l":[1,2],"s":"t"})");
    const std::string given = assignment;
    CHECK(refusal([&] { set_at(root, given); }) == "2 " + message);
    CHECK(root.dump() == R"({"l":[1,2],"s":"t"})");
}

TEST_CASE("a value set at a pointer names its own place in errors") {
    Json root;
    set_at(root, "/a/b", 1, "sweep.json: /values/0");
    CHECK(root.dump() == R"({"a":{"b":1}})");
    CHECK(refusal([&] { set_at(root, "/a/b/c", 1, "sweep.json: /values/0"); }) ==
          "2 sweep.json: /values/0: /a/b is a number and has no members. Shorten it");
}

TEST_CASE("numbers written as JSON read back to the same double") {
    const double value = GENERATE(0.1, 1.0 / 3, 1e23, 5e-324, -0.0, 340.29, std::numeric_limits<double>::max());
    const std::string text = json_text(Json{{"value", value}});
    const double read = parse_json(text, "written").at("value").get<double>();
    CHECK(std::bit_cast<std::uint64_t>(read) == std::bit_cast<std::uint64_t>(value));
    CHECK(json_text(Json{{"dx", 0.1}, {"n", 3}}) == "{\n  \"dx\": 0.1,\n  \"n\": 3\n}\n");
}

TEST_CASE("the nearest name is suggested for a typo and nothing for another word") {
    const std::vector<std::string> names{"viscosity", "alpha", "kernel", "dx", "r"};
    const auto [name, expected] = GENERATE(table<std::string, std::string>({
        {"alpha", "alpha"}, {"alhpa", "alpha"}, {"aplh", ""}, {"viscsoity", "viscosity"}, {"vicosty", "viscosity"},
        {"kernels", "kernel"}, {"d", "dx"}, {"h", ""}, {"", ""}, {"integrator", ""}}));
    CHECK(nearest(name, names) == expected);
    CHECK(nearest(name, {}) == "");
}
