#include "mode_system.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sphonic {
namespace {

/// Of an n x n and an n x m matrix, row-major.
std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b, int n, int m) {
    std::vector<double> c(std::size_t(n * m), 0.0);
    for (int r = 0; r < n; ++r)
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < m; ++k) c[std::size_t(r * m + k)] += a[std::size_t(r * n + i)] * b[std::size_t(i * m + k)];
    return c;
}

}    // namespace

ModeSystem::ModeSystem(const Case& scene, const Symbol& symbol, std::optional<Forcing> forcing) : A_(symbol), forcing_(forcing) {
    int count = 0;
    for (const Variable& v : scene.equations.variables) {
        first_.push_back(count);
        if (v.evolved()) count += v.components(scene.box.dimension);
    }
    for (const auto& group : scene.equations.order) {
        order_.emplace_back();
        for (const int v : group)
            for (int c = 0; c < scene.equations.variables[std::size_t(v)].components(scene.box.dimension); ++c)
                order_.back().push_back(first_[std::size_t(v)] + c);
    }
    all_.resize(std::size_t(symbol.n));
    std::iota(all_.begin(), all_.end(), 0);
    slots_.resize(1);
    unit_slots();
}

/// Slot s becomes the rows s n ... of the identity over all slots. Two more columns begin at zero and feel the forcing.
void ModeSystem::unit_slots() {
    const std::size_t n = std::size_t(A_.n), size = n * slots_.size();
    for (std::size_t s = 0; s < slots_.size(); ++s) {
        slots_[s].assign(n, std::vector<double>(size + 2, 0.0));
        for (std::size_t r = 0; r < n; ++r) slots_[s][r][s * n + r] = 1;
    }
}

const std::vector<int>& ModeSystem::rows(abi::Group group) const {
    if (group >= 0) return order_[std::size_t(group)];
    return group == abi::positions ? none_ : all_;
}

abi::Slot ModeSystem::history(const char* name) {
    const auto known = std::find(names_.begin(), names_.end(), name);
    if (known != names_.end()) return int(known - names_.begin());
    names_.emplace_back(name);
    slots_.emplace_back(std::size_t(A_.n), std::vector<double>(slots_[0][0].size(), 0.0));
    return int(slots_.size()) - 1;
}

std::vector<double> ModeSystem::rate_of(int row, double t) const {
    std::vector<double> rate(slots_[0][0].size(), 0.0);
    for (int c = 0; c < A_.n; ++c) {
        const double a = A_.a[std::size_t(row * A_.n + c)];
        for (std::size_t k = 0; k < rate.size(); ++k) rate[k] += a * slots_[0][std::size_t(c)][k];
    }
    if (forcing_ && row == first_[std::size_t(forcing_->variable)]) {
        rate[rate.size() - 2] += std::cos(forcing_->omega * t);
        rate[rate.size() - 1] += std::sin(forcing_->omega * t);
    }
    return rate;
}

void ModeSystem::count(abi::Group group) {
    if (rows(group).empty()) return;
    ++rate_calls_;
    evaluations_ += double(rows(group).size()) / double(A_.n);
}

void ModeSystem::rate(abi::Group group, double t, abi::Slot out) {
    count(group);
    for (const int r : rows(group)) slots_[std::size_t(out)][std::size_t(r)] = rate_of(r, t);
}

void ModeSystem::advance(abi::Group group, double t, double dt) {
    count(group);
    std::vector<std::vector<double>> rates;
    for (const int r : rows(group)) rates.push_back(rate_of(r, t));
    for (std::size_t i = 0; i < rates.size(); ++i) {
        auto& row = slots_[0][std::size_t(rows(group)[i])];
        for (std::size_t k = 0; k < row.size(); ++k) row[k] += dt * rates[i][k];
    }
}

void ModeSystem::copy(abi::Group group, abi::Slot from, abi::Slot to) {
    for (const int r : rows(group)) slots_[std::size_t(to)][std::size_t(r)] = slots_[std::size_t(from)][std::size_t(r)];
}

void ModeSystem::axpy(abi::Group group, double a, abi::Slot x, abi::Slot y) {
    for (const int r : rows(group)) {
        const auto& from = slots_[std::size_t(x)][std::size_t(r)];
        auto& to = slots_[std::size_t(y)][std::size_t(r)];
        for (std::size_t k = 0; k < to.size(); ++k) to[k] += a * from[k];
    }
}

Symbol ModeSystem::one_step_map(const abi::Integrator& integrator, double dt) {
    integrator.step(*this, {0, 0, dt});    // names the histories
    unit_slots();
    rate_calls_ = 0;
    evaluations_ = 0;
    integrator.step(*this, {1, dt, dt});
    const std::size_t n = std::size_t(A_.n), size = n * slots_.size();
    kept_.clear();    // scratch arrays influence nothing: their columns are zero
    for (std::size_t c = 0; c < size; ++c) {
        bool used = c < n;
        for (const Rows& slot : slots_)
            for (const auto& row : slot) used = used || row[c] != 0;
        if (used) kept_.push_back(c);
    }
    forced_.clear();
    for (const std::size_t r : kept_) {
        const auto& row = slots_[r / n][r % n];
        const std::complex<double> gained(row[size], row[size + 1]);
        forced_.push_back(forcing_ ? gained * std::polar(1.0, -forcing_->omega * dt) : gained);
    }
    Symbol map{.n = int(kept_.size()), .a = {}};
    for (const std::size_t r : kept_)
        for (const std::size_t c : kept_) map.a.push_back(slots_[r / n][r % n][c]);
    return map;
}

Symbol ModeSystem::run_map(const abi::Integrator& integrator, double dt, long steps) {
    integrator.begin(*this, dt);    // may name histories of its own
    Symbol power = one_step_map(integrator, dt);
    unit_slots();
    integrator.begin(*this, dt);
    integrator.step(*this, {0, 0, dt});
    Symbol state{.n = A_.n, .a = {}};    // of all that the map acts on, by what was given
    for (const std::size_t r : kept_) {
        const auto& row = slots_[r / std::size_t(A_.n)][r % std::size_t(A_.n)];
        state.a.insert(state.a.end(), row.begin(), row.begin() + A_.n);
    }
    for (long left = steps - 1; left > 0; left /= 2) {
        if (left % 2 == 1) state.a = product(power.a, state.a, power.n, A_.n);
        power.a = product(power.a, power.a, power.n, power.n);
    }
    state.a.resize(std::size_t(A_.n * A_.n));    // the state's own rows come first
    return state;
}

}    // namespace sphonic
