#include <algorithm>

#include "study_parts.hpp"
#include "study_reader.hpp"

namespace sphonic {

std::string read_measure(Section& section, const std::string& key, const std::string& fallback) {
    return section.choice(key, fallback, measure_names());
}

void read_measures(Study& study, Section& section) {
    const Json* member = section.find("measure");
    if (!member || !member->is_array()) {
        study.measure = read_measure(section, "measure", "errors.l2");
        return;
    }
    const Json& list = need_list(section, "measure", "Name a measure or several");
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Json one{{"measure", list[i]}};
        const std::string name = Section(one, section.file(), section.pointer()).choice("measure", "", measure_names());
        if (name == study.measure || std::ranges::count(study.also, name)) section.fail("measure", "\"" + name + "\" is given twice", "Name each once");
        (i ? study.also.emplace_back() : study.measure) = name;
    }
}

bool read_flag(Section& section, const std::string& key) {
    const Json* member = section.find(key);
    if (member && !member->is_boolean()) section.fail(key, shown(*member) + " is not true or false", "Give true or false");
    return member && member->get<bool>();
}

int read_repeat(Section& section) {
    const Json* member = section.find("repeat");
    if (!member) return 1;
    const auto runs = whole_number(*member);
    if (!runs || *runs < 1 || *runs > 1000) section.fail("repeat", shown(*member) + " is no number of runs", "Give an integer from 1 to 1000");
    return int(*runs);
}

double positive(const Section& section, const std::string& key, const Json& value, const std::string& remedy) {
    const double x = finite_number(value, section.place(key));
    if (x <= 0) section.fail(key, shown(value) + " is not positive", remedy);
    return x;
}

void read_targets(Study& study, Section& section) {
    if (section.find("targets")) {
        const std::string remedy = "Give a list of positive numbers";
        for (const Json& target : need_list(section, "targets", remedy)) study.targets.push_back(positive(section, "targets", target, remedy));
    } else if (study.measure == "errors.l2" || study.measure == "errors.rms") {
        study.targets = {0.01, 0.001};
    }
}

}    // namespace sphonic
