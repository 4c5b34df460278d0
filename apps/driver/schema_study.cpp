#include <sphonic/study.hpp>

#include "schema_parts.hpp"

namespace sphonic::driver::schemas {
namespace {

const Json text = object({{"type", "string"}, {"minLength", 1}});
const Json flag = object({{"type", "boolean"}, {"default", false}});
const Json label = object({{"type", {"number", "string", "boolean"}}});
const Json above_zero = object({{"type", "number"}, {"exclusiveMinimum", 0}});

Json some(const Json& items) { return with(list_of(items), "minItems", 1); }
Json pointer() { return object({{"type", "string"}, {"pattern", "^(/([^/~]|~[01])+)+$"}}); }
/// What a dimension may be called.
Json dimension_name() {
    Names taken = measure_names();
    taken.push_back("family");
    return object({{"type", "string"}, {"pattern", "^[^/]"}, {"not", object({{"enum", taken}})}});
}

Json one_measure() { return object({{"enum", measure_names()}}); }

/// One value of a dimension that changes more than one place.
Json labelled_value() {
    return closed(object({{"label", described(label, "its name in tables and charts")},
                          {"family", described(string, "of its points in cost charts and readings")},
                          {"case", described(string, "another case, beside the study")},
                          {"remove", described(some(pointer()), "members taken out of the case, before any is set")},
                          {"set", described(object({{"type", "object"}, {"propertyNames", pointer()}}), "values by the JSON pointers of their members")}}),
                  {"label"});
}

/// Plain values need a pointer, and the others stand for themselves.
Json dimension_schema() {
    const Json one = object({{"if", object({{"type", "object"}})}, {"then", labelled_value()}, {"else", label}});
    const Json pointers = object({{"anyOf", Json::array({pointer(), some(pointer())})}});
    Json schema = closed(object({{"name", described(dimension_name(), "of the dimension, none of the measures")},
                                 {"pointer", described(pointers, "the member, or several, that each plain value is given to")},
                                 {"values", described(some(one), "plain, or with what each does to the case")},
                                 {"family", described(flag, "each value is a family of its own, where it names none")}}),
                         {"name", "values"});
    schema["anyOf"] = Json::array({requiring({"pointer"}), object({{"properties", object({{"values", object({{"items", object({{"type", "object"}})}})}})}})});
    return schema;
}

/// The keys of every chart; `rest` are of its type.
Json chart_of(const char* type, const char* what, Json rest, Names needed) {
    rest.update(object({{"type", described(object({{"const", type}}), what)},
                        {"name", with(described(string, "of its files"), "pattern", "^[A-Za-z0-9_-]+$")},
                        {"title", described(string, "the study's if not given")},
                        {"x_label", described(string, "of the axis; made from what is drawn if not given")},
                        {"y_label", described(string, "the same along y")}}));
    needed.insert(needed.end(), {"type", "name"});
    return closed(rest, needed);
}

Json cost_chart() {
    return chart_of("cost", "error against CPU time, with the front and the predictions",
                    object({{"y", described(one_measure(), "drawn against CPU time; the study's measure if not given")},
                            {"family", with(described(text, "the place whose values are joined: a dimension, \"family\" or a JSON pointer"), "default", "family")},
                            {"y_floor", object({{"type", "number"}, {"minimum", 0}, {"default", 0}, {"description", "what lies below is drawn here, its value beside it"}})}}),
                    {});
}

/// A slope shows on logarithmic axes only.
Json value_chart() {
    const Json real = object({{"type", "number"}, {"minimum", -20}, {"maximum", 20}, {"default", 0}});
    Json schema = chart_of("value", "a measure against a number",
                           object({{"x", described(text, "the place drawn along x: a dimension or a JSON pointer to a number")},
                                   {"y", described(one_measure(), "the study's if not given")},
                                   {"series", described(string, "the place that names the curves; if not given, all dimensions but x")},
                                   {"x_log", described(flag, "a logarithmic axis")},
                                   {"y_log", described(flag, "a logarithmic axis")},
                                   {"order", described(real, "slope of a triangle beside the curves; 0: none")},
                                   {"slopes", described(flag, "the legend tells the power of x with which each curve goes")}}),
                           {"x"});
    const Json yes = object({{"const", true}}), sloped = object({{"not", object({{"const", 0}})}});
    schema["if"] = object({{"anyOf", Json::array({where("order", sloped), where("slopes", yes)})}});
    schema["then"] = object({{"properties", object({{"x_log", yes}, {"y_log", yes}})}, {"required", Names{"x_log", "y_log"}}});
    return schema;
}

Json map_chart() {
    return chart_of("map", "cells over two dimensions with numbers",
                    object({{"x", described(dimension_name(), "a dimension of numbers")},
                            {"y", described(dimension_name(), "another")},
                            {"measure", described(one_measure(), "of the cells, beside a map of CPU time; the study's if not given")},
                            {"x_log", described(flag, "a logarithmic axis")},
                            {"y_log", described(flag, "a logarithmic axis")}}),
                    {"x", "y"});
}

Json chart_schema() {
    Json types = Json::array(), rules = Json::array();
    for (const Json& chart : {cost_chart(), value_chart(), map_chart()}) {
        const Json& type = chart["properties"]["type"];
        types.push_back(type["const"]);
        rules.push_back(rule(where("type", type), chart));
    }
    Json schema = where("type", object({{"enum", types}}));
    schema["type"] = "object";
    schema["allOf"] = rules;
    return schema;
}

Json printed_schema() {
    const Json columns = described(some(string), "dimensions, \"family\" or JSON pointers, and once the measure");
    return closed(object({{"source", described(string, "of the values")},
                          {"columns", columns},
                          {"rows", described(some(some(Json::object())), "one entry for each column; the measure's is not 0")}}),
                  {"columns", "rows"});
}

/// The study names a case, or every value of one of its dimensions does.
Json some_case() {
    const Json named = where("case", text), values = object({{"values", object({{"items", with(named, "type", "object")}})}});
    const Json dimension = object({{"contains", object({{"type", "object"}, {"properties", values}, {"required", Names{"values"}}})}});
    return object({{"anyOf", Json::array({named, object({{"properties", object({{"vary", dimension}})}})})}});
}

}    // namespace

Json study_schema() {
    const Json several = with(some(one_measure()), "uniqueItems", true);
    const Json measure = object({{"anyOf", Json::array({one_measure(), several})}, {"default", "errors.l2"}, {"description", "one, or several of the same runs: the first is ranked"}});
    Json members = object({
        {"$schema", described(string, "where editors find this schema")},
        {"case", described(string, "the case that is varied, beside the study")},
        {"title", described(string, "the file's name if not given")},
        {"description", described(string, "what pages tell below the title")},
        {"vary", described(some(dimension_schema()), "dimensions, crossed; the first varies slowest")},
        {"measure", measure},
        {"worst_over", described(string, "a dimension: points that differ in it alone count as one, by the worst")},
        {"repeat", object({{"type", "integer"}, {"minimum", 1}, {"maximum", 1000}, {"default", 1}, {"description", "runs of each point"}})},
        {"cutoff", described(above_zero, "[s] CPU time of stepping after which a run is given up")},
        {"targets", described(some(above_zero), "of the measure: what is the cheapest point of each family that meets each?")},
        {"printed", described(printed_schema(), "published values of the measure")},
        {"charts", described(some(chart_schema()), "pictures of the results")},
    });
    Json schema = closed(members, {"vary"});
    schema.update(some_case());
    return schema;
}

}    // namespace sphonic::driver::schemas
