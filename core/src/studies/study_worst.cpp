#include <algorithm>

#include <sphonic/nearest.hpp>

#include "study_parts.hpp"
#include "study_reader.hpp"

namespace sphonic {
namespace {

/// The points of a group, which follow each other at a stride.
struct Group {
    std::size_t first, stride, count;
    std::size_t operator[](std::size_t i) const { return first + i * stride; }
};

/// By the dimensions before the `d`-th, then those after it: the order of points without it.
std::vector<Group> groups_over(const Study& study, std::size_t d) {
    std::size_t stride = 1;
    for (std::size_t k = d + 1; k < study.vary.size(); ++k) stride *= study.vary[k].values.size();
    const std::size_t count = study.vary[d].values.size();
    std::vector<Group> groups;
    for (std::size_t first = 0; first < study.points.size(); first += stride * count)
        for (std::size_t inner = 0; inner < stride; ++inner) groups.push_back({first + inner, stride, count});
    return groups;
}

/// The first that failed, or else the one with the largest measure.
std::size_t worst_of(const Study& study, const std::vector<StudyResult>& results, const Group& group) {
    std::size_t worst = group[0];
    for (std::size_t i = 0; i < group.count; ++i) {
        if (results[group[i]].status != StudyResult::Status::done) return group[i];
        if (measured(results[group[i]], study.measure) > measured(results[worst], study.measure)) worst = group[i];
    }
    return worst;
}

StudyResult merged(const Study& study, const std::vector<StudyResult>& results, const Group& group) {
    StudyResult result = results[worst_of(study, results, group)];
    if (result.status != StudyResult::Status::done) return result;
    const double share = 1 / double(group.count);
    result.summary.cpu_s = result.timing.low = result.timing.high = 0;
    std::optional<double> l2 = 0, cpu_s = 0;
    for (std::size_t i = 0; i < group.count; ++i) {
        const StudyResult& one = results[group[i]];
        result.summary.cpu_s += share * one.summary.cpu_s;
        result.timing.low += share * one.timing.low;
        result.timing.high += share * one.timing.high;
        if (result.timing.doubt.empty()) result.timing.doubt = one.timing.doubt;
        l2 = l2 && one.predicted_l2 ? std::optional(std::max(*l2, *one.predicted_l2)) : std::nullopt;
        cpu_s = cpu_s && one.predicted_cpu_s ? std::optional(*cpu_s + share * *one.predicted_cpu_s) : std::nullopt;
    }
    result.predicted_l2 = l2;
    result.predicted_cpu_s = cpu_s;
    return result;
}

}    // namespace

void read_worst_over(Study& study, Section& section) {
    study.worst_over = section.text("worst_over", "");
    if (study.worst_over.empty() || std::ranges::count(study.vary, study.worst_over, &StudyDimension::name)) return;
    std::vector<std::string> names;
    for (const StudyDimension& dimension : study.vary) names.push_back(dimension.name);
    const std::string near = nearest(study.worst_over, names);
    section.fail("worst_over", "\"" + study.worst_over + "\" is no dimension of this study", near.empty() ? "Known here: " + join(names) : "Did you mean \"" + near + "\"?");
}

StudyView worst_view(const Study& study, const std::vector<StudyResult>& results) {
    StudyView view{study, results};
    if (study.worst_over.empty()) return view;
    const auto d = std::ranges::find(study.vary, study.worst_over, &StudyDimension::name) - study.vary.begin();
    view.study.vary.erase(view.study.vary.begin() + d);
    view.study.points.clear();
    view.results.clear();
    for (const Group& group : groups_over(study, std::size_t(d))) {
        StudyPoint point = study.points[worst_of(study, results, group)];
        point.labels.erase(point.labels.begin() + d);
        point.name = joined_labels(view.study, point.labels);
        view.study.points.push_back(std::move(point));
        view.results.push_back(merged(study, results, group));
    }
    return view;
}

}    // namespace sphonic
