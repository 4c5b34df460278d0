/// A plugin that is right in every field but those that its target's definitions override: one source, many faults.
#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

#include <sphonic/plugin/abi/entry.hpp>
#include <sphonic/plugin/abi/state.hpp>

#ifndef MAGIC
#define MAGIC "sphonic1"
#endif
#ifndef SIZE
#define SIZE sizeof(abi::Entry)
#endif
#ifndef TAG
#define TAG SPHONIC_ABI_TAG
#endif
#ifndef KIND
#define KIND "state"
#endif
#ifndef NAME
#define NAME FILE_NAME
#endif
#ifndef ROWS
#define ROWS none
#endif
#ifndef CREATE
#define CREATE create
#endif
#ifndef RETURN
#define RETURN &entry
#endif

using namespace sphonic;

namespace {

struct Identity final : abi::State {
    void evaluate(const abi::Medium&, int n, const double* x, double* y) const override { std::copy_n(x, n, y); }
    void invert(const abi::Medium&, int n, const double* y, double* x) const override { std::copy_n(y, n, x); }
    double derivative(const abi::Medium&, double) const override { return 1; }
};

[[maybe_unused]] void* create(const abi::Value*) { return static_cast<abi::State*>(new Identity); }
[[maybe_unused]] void* throws_error(const abi::Value*) { throw std::runtime_error("no licence for this state"); }
[[maybe_unused]] void* throws_number(const abi::Value*) { throw 42; }
[[maybe_unused]] void* creates_nothing(const abi::Value*) { return nullptr; }

abi::ParameterInfo real(const char* name, double lower, double upper, double initial) {
    return {name, "1", lower, upper, "a number", "", {.type = abi::ParameterType::real, .real = initial}};
}

/// Tables of two rows: the first is always sound.
struct Table {
    int count;
    abi::ParameterInfo rows[2];
};
[[maybe_unused]] const Table none{0, {}};
[[maybe_unused]] const Table twice{2, {real("stiffness", 0, 1, 0.5), real("stiffness", 0, 1, 0.5)}};
[[maybe_unused]] const Table empty_range{2, {real("sound", 0, 1, 0.5), real("stiffness", 1, 0, 0.5)}};
[[maybe_unused]] const Table outside{2, {real("sound", 0, 1, 0.5), real("stiffness", 0, 1, 1.5)}};
[[maybe_unused]] const Table not_finite{
    2, {real("sound", 0, 1, 0.5), real("stiffness", 0, 1, std::numeric_limits<double>::infinity())}};
[[maybe_unused]] const Table nameless{2, {real("sound", 0, 1, 0.5), real("", 0, 1, 0.5)}};
[[maybe_unused]] const Table absent{-1, {}};

[[maybe_unused]] const abi::Entry* throw_error() { throw std::runtime_error("no licence for this plugin"); }
[[maybe_unused]] const abi::Entry* throw_number() { throw 42; }

}    // namespace

extern "C" __attribute__((visibility("default"))) const abi::Entry* sphonic_plugin_entry() {
    static const abi::Entry entry = [] {
        abi::Entry e{{}, SIZE, TAG, KIND, NAME, "a plugin of the loader's tests", ROWS.rows, ROWS.count, CREATE};
        std::memcpy(e.magic, MAGIC, sizeof e.magic);
        return e;
    }();
    static_cast<void>(entry);
    return RETURN;
}
