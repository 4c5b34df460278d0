#include <cmath>
#include <cstdio>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/shown.hpp>
#include <sphonic/simulation.hpp>
#include <sphonic/stability_report.hpp>

namespace sphonic {
namespace {

bool is_step(const Varied& varied) { return varied.pointer == "/integrator/dt" || varied.pointer == "/integrator/courant"; }

std::string row(const std::vector<double>& values) {
    std::string text;
    char digits[32];
    for (const double value : values) {
        std::snprintf(digits, sizeof digits, "%.10g", value);
        text += (text.empty() ? "" : ",") + std::string(digits);
    }
    return text + "\n";
}

}    // namespace

Varied::Varied(const std::string& text) {
    char rest = 0;
    const auto equals = text.find('=');
    const bool read = equals != text.npos && text[0] == '/' && std::sscanf(text.c_str() + equals + 1, "%lf:%lf:%d%c", &from, &to, &count, &rest) == 3;
    if (!read) throw Error(Fault::input, "--vary " + text, "is not /pointer=a:b:n", "Write such as --vary /kernel/h_over_dx=1:3:9");
    if (count < 2 || count > 400) throw Error(Fault::input, "--vary " + text, std::to_string(count) + " values", "Ask for 2 to 400");
    if (!std::isfinite(from) || !std::isfinite(to) || !(from < to))
        throw Error(Fault::input, "--vary " + text, "the first value is not below the last", "Write /pointer=a:b:n with a < b");
    pointer = text.substr(0, equals);
}

StabilityMap::StabilityMap(Json document, std::filesystem::path file, std::vector<Varied> varied, Registry& registry, const StabilityTrial::Options& options)
    : document_(std::make_shared<const Json>(std::move(document))), file_(std::move(file)), varied_(std::move(varied)), registry_(registry), options_(options) {
    if (varied_.size() > 2) throw Error(Fault::input, "--vary " + varied_[2].pointer, "a map has two axes", "Vary one parameter or two");
    if (varied_.size() == 2 && varied_[0].pointer == varied_[1].pointer)
        throw Error(Fault::input, "--vary " + varied_[0].pointer, "is given twice", "Vary one parameter or two");
    own_step_ = varied_.size() == 2 || is_step(varied_[0]);
    const Case first = load(0);
    title_ = first.title;
    if (document_->contains("/integrator/courant_length"_json_pointer))
        courant_length_ = document_->at("/integrator/courant_length"_json_pointer).get<std::string>();
    if (own_step_ && !first.method->meshfree())
        throw Error(Fault::input, first.file + ": /method/type", "\"" + first.method_name + "\" tells its limit but not how it grows", "Vary one parameter that is not the step");
    if (own_step_ && !first.step.dt && !first.step.courant)
        throw Error(Fault::input, first.file + ": /integrator", "the step is a fraction of the limit, so that all is stable", "Give dt or courant, or vary one of them");
    points_.resize(std::size_t(points()));
}

int StabilityMap::points() const { return varied_[0].count * (varied_.size() > 1 ? varied_[1].count : 1); }

double StabilityMap::value(int point, std::size_t parameter) const {
    const int columns = varied_[0].count;
    return varied_[parameter].value(parameter == 0 ? point % columns : point / columns);
}

std::string StabilityMap::label(int point) const {
    std::string text;
    for (std::size_t p = 0; p < varied_.size(); ++p) text += (p ? ", " : "") + varied_[p].pointer + "=" + shown(value(point, p), 6);
    return text;
}

Case StabilityMap::load(int point) const {
    try {
        Json document = *document_;
        for (std::size_t p = 0; p < varied_.size(); ++p) {
            const double v = value(point, p);
            set_at(document, varied_[p].pointer, v == std::round(v) && std::abs(v) < 1e9 ? Json(long(v)) : Json(v), file_.string());
        }
        Case scene = load_case(std::move(document), file_, registry_);
        silence(scene);
        return scene;
    } catch (const Error& e) {
        throw Error(e.fault, "--vary " + label(point), e.what());
    }
}

void StabilityMap::find(int index, const StabilityTrial::Report& report) {
    const Case scene = load(index);
    Point& point = points_[std::size_t(index)];
    point.courant_per_dt = courant_dx(scene, 1);
    if (!own_step_) {
        point.finding = find_stability(scene, options_, report);
        point.predicted = point.finding.predicted.dt;
        point.dt = asked_step(scene, point.predicted);
        return;
    }
    const StepTheory theory(scene);
    const StepLimit limit = theory.limit();
    point.predicted = limit.dt;
    point.weak = limit.weak && limit.dt > 0;
    point.dt = asked_step(scene, limit.dt);
    point.predicted_growth = theory.growth(point.dt);
    StabilityTrial trial(scene, options_, report);
    point.run = trial.run(point.dt);
    point.run.growth = std::max(point.run.stable ? -1 : point.run.growth, trial.growth(point.dt, options_.steps));
    if (point.weak) point.run.stable = point.run.growth * scene.until / point.dt <= weak_exponent;
}

std::string StabilityMap::csv() const {
    std::string text;
    for (const Varied& varied : varied_) text += varied.pointer + ",";
    text += own_step_ ? "dt,courant_dx,predicted_limit_dt,predicted_limit_courant_dx,predicted_growth_per_step,measured_growth_per_step,measured_stable\n"
                      : "predicted_dt,predicted_courant_dx,measured_dt,measured_courant_dx,measured_precision\n";
    for (int i = 0; i < points(); ++i) {
        const Point& p = points_[std::size_t(i)];
        std::vector<double> values;
        for (std::size_t k = 0; k < varied_.size(); ++k) values.push_back(value(i, k));
        const double c = p.courant_per_dt, measured = p.finding.measured.dt;
        const std::vector<double> found = own_step_ ? std::vector{p.dt, c * p.dt, p.predicted, c * p.predicted, p.predicted_growth, p.run.growth, double(p.run.stable)}
                                                    : std::vector{p.predicted, c * p.predicted, measured, c * measured, p.finding.measured.precision};
        values.insert(values.end(), found.begin(), found.end());
        text += row(values);
    }
    return text;
}

}    // namespace sphonic
