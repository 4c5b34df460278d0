#include <cmath>
#include <limits>
#include <ranges>
#include <string_view>

#include <sphonic/parameters.hpp>

#include "schema_parts.hpp"

namespace sphonic::driver::schemas {
namespace {

using Type = abi::ParameterType;

constexpr double positive = std::numeric_limits<double>::min();

void bound(Json& schema, const abi::ParameterInfo& row) {
    const auto limit = [&](double x) { return row.initial.type == Type::integer ? Json(std::int64_t(x)) : Json(x); };
    if (row.lower == positive)
        schema["exclusiveMinimum"] = 0;
    else if (std::isfinite(row.lower))
        schema["minimum"] = limit(row.lower);
    if (std::isfinite(row.upper)) schema["maximum"] = limit(row.upper);
}

bool is_file(const abi::ParameterInfo& row) { return row.initial.type == Type::text && std::string_view(row.unit) == abi::file_unit; }

Json type_of(const abi::ParameterInfo& row) {
    if (row.initial.type == Type::vector) {
        Json items = object({{"type", "number"}});
        bound(items, row);
        return with(with(list_of(items), "minItems", 1), "maxItems", 3);
    }
    Json schema = object({{"type", type_name(row.initial.type)}});
    if (row.initial.type == Type::real || row.initial.type == Type::integer) bound(schema, row);
    if (row.initial.type == Type::text && row.choices[0]) {
        schema["enum"] = Json::array();
        for (const auto choice : std::views::split(std::string_view(row.choices), '|'))
            schema["enum"].push_back(std::string(choice.begin(), choice.end()));
    }
    if (is_file(row)) schema["minLength"] = 1;
    return schema;
}

}    // namespace

Json value_schema(const abi::ParameterInfo& row) {
    Json schema = type_of(row);
    const Json initial = to_json(row.initial);
    const bool none = is_required(row) || initial.empty() || initial == "";
    if (!none) schema["default"] = initial;
    const std::string unit = row.unit;
    schema["description"] = is_file(row)  ? std::string(row.doc) + "; a path, seen from the case's folder"
                            : unit == "1" ? row.doc
                                          : "[" + unit + "] " + row.doc;
    return schema;
}

void add_rows(Json& members, std::span<const abi::ParameterInfo> rows) {
    for (const abi::ParameterInfo& row : rows) members[row.name] = value_schema(row);
}

Json rows_of(const std::string& kind) {
    Json members = Json::object();
    add_rows(members, common_keys(kind));
    return members;
}

}    // namespace sphonic::driver::schemas
