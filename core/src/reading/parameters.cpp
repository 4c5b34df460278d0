#include <sphonic/parameters.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include <sphonic/json.hpp>

namespace sphonic {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double positive = std::numeric_limits<double>::min();
constexpr double none = std::numeric_limits<double>::quiet_NaN();    ///< no default: optional, or worked out by the reader

using Type = abi::ParameterType;

abi::ParameterInfo number(const char* name, const char* unit, double lower, double upper, const char* doc, double initial = none) {
    return {name, unit, lower, upper, doc, "", {.type = Type::real, .real = initial}};
}
abi::ParameterInfo text(const char* name, const char* choices, const char* doc, const char* initial = "") {
    return {name, "1", 0, 0, doc, choices, {.type = Type::text, .text = initial}};
}
abi::ParameterInfo flag(const char* name, const char* doc, bool initial) {
    return {name, "1", 0, 0, doc, "", {.type = Type::boolean, .boolean = initial}};
}
abi::ParameterInfo integer(const char* name, double lower, double upper, const char* doc, std::int64_t initial) {
    return {name, "1", lower, upper, doc, "", {.type = Type::integer, .integer = initial}};
}
abi::ParameterInfo point(const char* name, const char* doc) {
    return {name, "m", -infinite, infinite, doc, "", {.type = Type::vector}};
}

using Tables = std::map<std::string, std::vector<abi::ParameterInfo>>;

const Tables& tables() {
    static const Tables all{
        {"kernel",
         {number("h", "m", positive, infinite, "smoothing length; this or h_over_dx"),
          number("h_over_dx", "1", positive, 1000, "smoothing length over particle spacing; this or h")}},
        {"dissipation", {number("alpha", "1", 0, 10, "strength; by the plugin's law for the set's disorder if not given")}},
        {"source", {text("region", "", "condition on x, y, z, r: the particles it acts on, by their initial positions")}},
        {"reference",
         {text("region", "", "condition on x, y, z, r: the particles that errors are taken over; all if not given"),
          number("scale", "Pa", positive, infinite, "pressure P that eps and rms are divided by; the largest exact one if not given")}},
        {"integrator",
         {number("dt", "s", positive, infinite, "time step; this, courant or safety"),
          number("courant", "1", positive, infinite, "c0 dt / courant_length, c0 that of the fastest medium"),
          text("courant_length", "dx|h", "length in the Courant number", "dx"),
          number("safety", "1", positive, 2, "fraction of the computed stable step; above 1 it needs unstable allow", 0.9),
          text("unstable", "refuse|allow", "what to do with a step beyond the limit", "refuse")}},
        {"case",
         {number("until", "s", positive, infinite, "end of the run"),
          text("active", "auto|all", "which particles are stepped: auto leaves out what no sound has reached and what can no longer matter", "auto"),
          text("precision", "double|single", "of the fields of a lattice; single takes half the time and memory, and errors stay above some 1e-7 sqrt(steps)", "double")}},
        {"medium", {number("c0", "m/s", positive, infinite, "sound speed"), number("rho0", "kg/m^3", positive, infinite, "density at rest"),
          text("region", "", "of a list of media: condition on x, y, z, r; the first medium fills the box"),
          number("dx", "m", positive, infinite, "of a list in one dimension: spacing of the particles in this medium, h in proportion; that of the first if not given")}},
        {"output", {number("every", "s", 0, infinite, "interval of probe samples; 0 is every step", 0),
          flag("fields", "the whole set at the end; without it, only probes and the reference's region", true)}},
        {"boundary", {text("face", "", "x_min ... z_max, an axis x, y, z, or all")}},
        {"shape",
         {text("wall", "rigid|soft|free", "what the surface does: u.n = 0, p = 0, or nothing, with only the particles cut out", "rigid"),
          text("keep", "outside|inside", "where the fluid is; the other side is solid", "outside")}},
        {"arrangement",
         {number("dx", "m", positive, infinite, "particle spacing"), point("lower", "lower corner of the box"),
          point("upper", "upper corner of the box"),
          number("jitter", "dx", 0, 0.5, "largest random displacement along each axis; faces of the box keep their particles", 0),
          integer("seed", 0, 2147483647, "of what is random: the jitter, and arrangements by chance", 1), text("motion", "auto|frozen|lagrangian", "whether particles move; auto is frozen", "auto"),
          text("neighbours", "auto|lattice|frozen|moving", "how neighbours are found", "auto"),
          text("velocity", "", "the variable that moves the particles", "u")}}};
    return all;
}

const std::map<std::string, std::vector<KeyRule>>& rules() {
    using enum KeyRule::How;
    static const std::map<std::string, std::vector<KeyRule>> all{
        {"kernel", {{exactly_one, {"h", "h_over_dx"}, "the smoothing length", "Give one of h [m] and h_over_dx"}}},
        {"source", {{required_to_impose, {"region"}, "", "Say which particles it acts on, such as \"x < 0\""}}},
        {"boundary", {{required, {"face"}, "", "Give x_min, x_max, ..., an axis such as \"x\", or \"all\""}}},
        {"arrangement", {{required, {"dx", "lower", "upper"}, "", ""}}},
        {"integrator", {{at_most_one, {"dt", "courant", "safety"}, "the step", "Give one of dt, courant and safety"}}}};
    return all;
}

}    // namespace

std::string number_text(double x) {
    const std::string text = Json(x).dump();
    return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
}

Json to_json(const abi::Value& value) {
    switch (value.type) {
        case Type::real: return value.real;
        case Type::integer: return value.integer;
        case Type::boolean: return value.boolean;
        case Type::text: return value.text;
        case Type::vector: break;
    }
    Json list = Json::array();
    for (int a = 0; a < value.size; ++a) list.push_back(value.vector[a]);
    return list;
}

bool is_required(const abi::ParameterInfo& row) {
    const double initial = row.initial.type == Type::real ? row.initial.real : double(row.initial.integer);
    const bool numeric = row.initial.type == Type::real || row.initial.type == Type::integer;
    return numeric && !(initial >= row.lower && initial <= row.upper);
}

std::string range_sentence(const abi::ParameterInfo& row) {
    const std::string unit = std::string(row.unit) == "1" ? "" : std::string(" [") + row.unit + "]";
    std::string range;
    if (row.lower == positive) range = "greater than 0";
    if (row.lower != positive && row.lower > -infinite) range = "at least " + number_text(row.lower);
    if (row.upper < infinite) range += (range.empty() ? "" : " and ") + ("at most " + number_text(row.upper));
    return std::string(row.name) + unit + " must be " + (range.empty() ? "a finite number" : range);
}

std::string range_short(const abi::ParameterInfo& row) {
    if (row.choices[0]) return row.choices;
    if (row.initial.type != Type::real && row.initial.type != Type::integer) return "";
    const std::string low = row.lower == positive ? "> 0" : row.lower > -infinite ? ">= " + number_text(row.lower) : "";
    const std::string high = row.upper < infinite ? "<= " + number_text(row.upper) : "";
    return low + (low.empty() || high.empty() ? "" : ", ") + high;
}

const char* type_name(Type type) {
    constexpr const char* names[] = {"number", "integer", "boolean", "string", "list of numbers"};
    return names[int(type)];
}

std::span<const abi::ParameterInfo> common_keys(const std::string& kind) {
    const auto found = tables().find(kind);
    return found == tables().end() ? std::span<const abi::ParameterInfo>{} : found->second;
}

const abi::ParameterInfo& common_key(const std::string& kind, const std::string& name) {
    for (const abi::ParameterInfo& row : common_keys(kind))
        if (row.name == name) return row;
    throw std::logic_error("no common key " + name + " of kind " + kind);
}

std::span<const KeyRule> key_rules(const std::string& kind) {
    const auto found = rules().find(kind);
    return found == rules().end() ? std::span<const KeyRule>{} : found->second;
}

std::span<const std::string> planned_places() {
    static const std::vector<std::string> all{"/method", "/equations", "/kernel", "/integrator", "/integrator/type", "/integrator/dt", "/integrator/courant",
                                              "/integrator/safety", "/particles/dx", "/medium/*/dx", "/boundaries/*/attenuation", "/precision"};
    return all;
}

std::span<const std::string> reserved_names() {
    static const std::vector<std::string> names{"x", "y", "z", "r", "pi", "c0", "rho0", "K", "dx", "h"};
    return names;
}

}    // namespace sphonic
