#include <algorithm>
#include <limits>

#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>

#include "study_parts.hpp"
#include "study_reader.hpp"

namespace sphonic {
namespace {

/// One line of a published table: places with the values that they have there, and the published measure.
struct PrintedRow {
    std::vector<std::pair<std::string, Json>> where;
    double value;
};

bool is_pointer(const std::string& place) { return place.starts_with('/'); }

/// A dimension, "family" or a JSON pointer.
void check_place(const Study& study, const Section& section, const std::string& key, const std::string& place) {
    std::vector<std::string> names;
    for (const StudyDimension& dimension : study.vary) names.push_back(dimension.name);
    names.emplace_back("family");
    if (std::ranges::count(names, place)) return;
    if (is_pointer(place)) {
        try {
            return void(Json::json_pointer(place));
        } catch (const Json::parse_error&) {
            section.fail(key, "\"" + place + "\" is no JSON pointer", "Write ~0 for ~ and ~1 for /");
        }
    }
    const std::string near = nearest(place, names);
    section.fail(key, "\"" + place + "\" is no dimension of this study",
                 near.empty() ? "Known here: " + join(names) + " and JSON pointers" : "Did you mean \"" + near + "\"?");
}

/// The last part of a measure's name stands for it: "eps" for "errors.eps".
bool names_measure(const std::string& column, const std::string& name) {
    return column == name || column == name.substr(name.find('.') + 1);
}

std::vector<std::string> read_columns(const Study& study, Section& section) {
    const std::string form = "Give names of dimensions and \"" + study.measure + "\"";
    std::vector<std::string> columns;
    for (const Json& column : need_list(section, "columns", form)) {
        if (!column.is_string()) section.fail("columns", shown(column) + " is not a string", form);
        columns.push_back(column);
        if (!names_measure(column, study.measure)) check_place(study, section, "columns", column);
    }
    const auto is_measure = [&](const std::string& column) { return names_measure(column, study.measure); };
    if (std::ranges::count_if(columns, is_measure) != 1)
        section.fail("columns", "one column must be the measure", form);
    return columns;
}

PrintedRow read_row(const Json& row, const std::vector<std::string>& columns, const std::string& measure,
                    const std::string& place) {
    if (!row.is_array() || row.size() != columns.size())
        throw Error(Fault::input, place, shown(row) + " does not fit the columns",
                    "Give " + std::to_string(columns.size()) + " values");
    PrintedRow read{.where = {}, .value = 0};
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (names_measure(columns[c], measure))
            read.value = finite_number(row[c], place + "/" + std::to_string(c));
        else
            read.where.emplace_back(columns[c], row[c]);
    }
    if (read.value == 0) throw Error(Fault::input, place, "the printed value is 0", "Leave out what has no ratio");
    return read;
}

/// Gives the printed value to the points that the row names.
void give(Study& study, const PrintedRow& row, const std::string& place) {
    bool found = false;
    for (StudyPoint& point : study.points) {
        const auto agrees = [&](const auto& named) { return at_place(study, point, named.first) == named.second; };
        if (!std::ranges::all_of(row.where, agrees)) continue;
        if (point.printed)
            throw Error(Fault::input, place, "the point " + point.name + " has a printed value already",
                        "Give one row per point");
        point.printed = row.value;
        found = true;
    }
    if (!found) throw Error(Fault::input, place, "no point of the study is meant", "Correct its labels or remove it");
}

/// There must be something to draw, and no curve may mix points that differ in more than x.
void check_curves(const Study& study, const StudyChart& chart, const Section& section) {
    const auto drawn = [&](const StudyPoint& point) { return at_place(study, point, chart.x).is_number(); };
    if (std::ranges::none_of(study.points, drawn))
        section.fail("x", "no point has a number at " + chart.x, "Name a dimension with numbers or a pointer to one");
    for (const StudyDimension& dimension : study.vary) {
        if (is_pointer(chart.x) || chart.group.empty() || chart.group == "family" || dimension.name == study.worst_over) continue;
        if (dimension.name != chart.x && dimension.name != chart.group && dimension.values.size() > 1)
            section.fail("series", "a curve would mix the values of \"" + dimension.name + "\"",
                         "Leave out series to have a curve for each");
    }
}

/// Two dimensions with numbers, and no others with several values.
void read_map(const Study& study, StudyChart& chart, Section& section) {
    const auto read = [&](const std::string& key) {
        const std::string name = need_text(section, key, "Name the dimension with numbers to be drawn along " + key);
        const auto dimension = std::ranges::find(study.vary, name, &StudyDimension::name);
        const auto number = [](const StudyValue& value) { return value.label.is_number(); };
        if (dimension == study.vary.end() || dimension->values.size() < 2 || !std::ranges::all_of(dimension->values, number))
            section.fail(key, "\"" + name + "\" is no dimension with two numbers or more", "Name a dimension whose values are numbers");
        return name;
    };
    chart.x = read("x"), chart.y = read("y");
    if (chart.x == chart.y) section.fail("y", "\"" + chart.y + "\" stands along x already", "Name another dimension");
    for (const StudyDimension& dimension : study.vary)
        if (dimension.name != chart.x && dimension.name != chart.y && dimension.name != study.worst_over && dimension.values.size() > 1)
            section.fail("type", "a map would mix the values of \"" + dimension.name + "\"", "Vary two dimensions in a study with a map");
    chart.measure = read_measure(section, "measure", study.measure);
    chart.x_label = section.text("x_label", chart.x);
    chart.y_label = section.text("y_label", chart.y);
    chart.x_log = read_flag(section, "x_log");
    chart.y_log = read_flag(section, "y_log");
    section.finish();
}

StudyChart::Type read_type(Section& section) {
    section.need("type", "Give \"value\", \"cost\" or \"map\"");
    const std::string type = section.choice("type", "", {"value", "cost", "map"});
    return type == "cost" ? StudyChart::Type::cost : type == "map" ? StudyChart::Type::map : StudyChart::Type::value;
}

StudyChart read_chart(const Study& study, Section section) {
    StudyChart chart{};
    chart.type = read_type(section);
    const bool cost = chart.type == StudyChart::Type::cost;
    chart.name = need_text(section, "name", "Name the files of the chart");
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; };
    if (!std::ranges::all_of(chart.name, plain))
        section.fail("name", "\"" + chart.name + "\" is no file name", "Use letters, digits, - and _");
    for (const StudyChart& other : study.charts)
        if (other.name == chart.name)
            section.fail("name", "there are two charts \"" + chart.name + "\"", "Name each differently");
    chart.title = section.text("title", study.title);
    if (chart.type == StudyChart::Type::map) {
        read_map(study, chart, section);
        return chart;
    }
    if (!cost)
        check_place(study, section, "x",
                    chart.x = need_text(section, "x", "Name the dimension or the pointer to be drawn along x"));
    chart.y = read_measure(section, "y", study.measure);
    const char* group = cost ? "family" : "series";
    chart.group = section.text(group, cost ? "family" : "");
    if (cost && chart.group.empty()) section.fail(group, "the text is empty", "Leave it out to group by family");
    if (!chart.group.empty()) check_place(study, section, group, chart.group);
    chart.x_label = section.text("x_label", cost ? measure("cpu_s").label : place_name(chart.x));
    chart.y_label = section.text("y_label", measure(chart.y).label);
    if (cost) {
        const abi::ParameterInfo floor =
            real_row("y_floor", "1", 0, std::numeric_limits<double>::max(), "least value drawn");
        chart.y_floor = section.real(floor);
    } else {
        chart.x_log = read_flag(section, "x_log");
        chart.y_log = read_flag(section, "y_log");
        chart.order = section.real(real_row("order", "1", -20, 20, "slope of the triangle beside the curves"));
        chart.slopes = read_flag(section, "slopes");
        if ((chart.order != 0 || chart.slopes) && !(chart.x_log && chart.y_log))
            section.fail(chart.slopes ? "slopes" : "order", "a slope shows on logarithmic axes only", "Set x_log and y_log too, or leave it out");
        check_curves(study, chart, section);
    }
    section.finish();
    return chart;
}

}    // namespace

void read_printed(Study& study, Section section) {
    study.source = section.text("source", "");
    const std::vector<std::string> columns = read_columns(study, section);
    const Json& rows = need_list(section, "rows", "Give a list of rows");
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const std::string place = section.place("rows") + "/" + std::to_string(r);
        give(study, read_row(rows[r], columns, study.measure, place), place);
    }
    section.finish();
}

void read_charts(Study& study, const Json& list) {
    for (std::size_t i = 0; i < list.size(); ++i)
        study.charts.push_back(read_chart(study, {list[i], study.file.string(), "/charts/" + std::to_string(i)}));
}

}    // namespace sphonic
