#include "times.hpp"

#include <cctype>
#include <charconv>
#include <cmath>

#include "case_reader.hpp"

namespace sphonic {
namespace {

constexpr const char* finite_remedy = "Choose constants whose product is finite";

struct Operand {
    std::string text;
    bool divides;
};

/// A + or - at the top level that is neither a leading sign, nor one of an exponent (2^-1, 1e-3).
bool is_sum(const std::string& text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += (text[i] == '(') - (text[i] == ')');
        if (depth > 0 || i == 0 || (text[i] != '+' && text[i] != '-')) continue;
        const bool number = text[i - 1] == 'e' && i > 1 && std::isdigit(static_cast<unsigned char>(text[i - 2]));
        if (text[i - 1] != '^' && !number) return true;
    }
    return false;
}

/// Operands of a product at the top level.
std::vector<Operand> split_product(const std::string& text, const Section& section) {
    std::vector<Operand> operands{{"", false}};
    int depth = 0;
    for (const char c : text) {
        std::string& operand = operands.back().text;
        depth += (c == '(') - (c == ')');
        if (depth == 0 && (c == '*' || c == '/'))
            operands.push_back({"", c == '/'});
        else if (c != ' ' || !operand.empty())
            operand += c;
    }
    for (Operand& operand : operands) {
        operand.text.erase(operand.text.find_last_not_of(' ') + 1);
        if (operand.text.empty() || operand.text == "-" || is_sum(operand.text))
            section.fail("times", "\"" + text + "\" is not a product", "Write factors joined by * and /");
    }
    return operands;
}

/// The power of "rho^-2", 1 without a hat.
int read_power(const std::string& text, std::size_t hat, const Section& section) {
    constexpr int largest = 8;
    if (hat == std::string::npos) return 1;
    int power = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + hat + 1, end, power);
    if (read.ptr != end || read.ec != std::errc{} || std::abs(power) > largest)
        section.fail("times", "\"" + text + "\" is not an integer power", "Powers of variables are integers");
    return power;
}

double constant_value(const std::string& text, const Case& scene, const abi::Medium& medium, const Section& section) {
    const std::string remedy = "Coefficients are constants times powers of variables";
    for (const std::string name : {"x", "y", "z", "r"})
        if (text == name) section.fail("times", "\"" + text + "\": \"" + name + "\" is a coordinate", remedy);
    const Expression expression(text, constants(scene, medium), scene.box.dimension, section.place("times"));
    const double here[3] = {0.3, 0.7, 1.1}, there[3] = {1.7, -0.4, 0.2};
    const double value = expression(here), elsewhere = expression(there);
    if (value != elsewhere && std::isfinite(value) && std::isfinite(elsewhere)) section.fail("times", "\"" + text + "\" depends on a coordinate", remedy);
    return value;
}

void apply(Operand operand, Term& term, const Case& scene, const Section& section) {
    if (operand.text[0] == '-') {
        for (double& coefficient : term.coefficient) coefficient = -coefficient;
        operand.text.erase(0, 1);
    }
    const auto hat = operand.text.find('^');
    const int variable = scene.equations.find(operand.text.substr(0, hat));
    if (variable >= 0) {
        const int power = read_power(operand.text, hat, section);
        if (scene.equations.variables[std::size_t(variable)].is_vector)
            section.fail("times", "\"" + operand.text + "\" is a vector", "Multiply by scalars");
        term.factors.push_back({variable, operand.divides ? -power : power});
        return;
    }
    for (std::size_t m = 0; m < term.coefficient.size(); ++m) {
        const double value = constant_value(operand.text, scene, scene.media->list()[m], section);
        if (operand.divides && value == 0) section.fail("times", "\"" + operand.text + "\" is zero and divides", finite_remedy);
        term.coefficient[m] *= operand.divides ? 1 / value : value;
        if (!std::isfinite(term.coefficient[m])) section.fail("times", "the product is not finite at \"" + operand.text + "\"", finite_remedy);
    }
}

}    // namespace

void read_times(Term& term, const Case& scene, Section& section) {
    term.coefficient.assign(scene.media->list().size(), 1);
    for (const Operand& operand : split_product(section.text("times", "1"), section)) apply(operand, term, scene, section);
}

}    // namespace sphonic
