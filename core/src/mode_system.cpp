#include "mode_system.hpp"

#include <algorithm>
#include <numeric>

namespace sphonic {

ModeSystem::ModeSystem(const Case& scene, const Symbol& symbol)
    : A_(Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(symbol.a.data(), symbol.n, symbol.n)) {
    std::vector<int> first;
    int count = 0;
    for (const Variable& v : scene.equations.variables) {
        first.push_back(count);
        if (v.evolved()) count += v.components(scene.box.dimension);
    }
    for (const auto& group : scene.equations.order) {
        order_.emplace_back();
        for (const int v : group)
            for (int c = 0; c < scene.equations.variables[std::size_t(v)].components(scene.box.dimension); ++c)
                order_.back().push_back(first[std::size_t(v)] + c);
    }
    all_.resize(std::size_t(symbol.n));
    std::iota(all_.begin(), all_.end(), 0);
    slots_.emplace_back(Eigen::MatrixXd::Identity(symbol.n, symbol.n));
}

const std::vector<int>& ModeSystem::rows(abi::Group group) const {
    if (group >= 0) return order_[std::size_t(group)];
    return group == abi::positions ? none_ : all_;
}

abi::Slot ModeSystem::history(const char* name) {
    const auto known = std::find(names_.begin(), names_.end(), name);
    if (known != names_.end()) return int(known - names_.begin());
    names_.emplace_back(name);
    slots_.emplace_back(Eigen::MatrixXd::Zero(slots_[0].rows(), slots_[0].cols()));
    return int(slots_.size()) - 1;
}

void ModeSystem::rate(abi::Group group, double, abi::Slot out) {
    for (const int r : rows(group)) slots_[std::size_t(out)].row(r) = A_.row(r) * slots_[0];
}

void ModeSystem::advance(abi::Group group, double, double dt) {
    const Eigen::MatrixXd rate = A_ * slots_[0];
    for (const int r : rows(group)) slots_[0].row(r) += dt * rate.row(r);
}

void ModeSystem::copy(abi::Group group, abi::Slot from, abi::Slot to) {
    for (const int r : rows(group)) slots_[std::size_t(to)].row(r) = slots_[std::size_t(from)].row(r);
}

void ModeSystem::axpy(abi::Group group, double a, abi::Slot x, abi::Slot y) {
    for (const int r : rows(group)) slots_[std::size_t(y)].row(r) += a * slots_[std::size_t(x)].row(r);
}

Eigen::MatrixXd ModeSystem::one_step_map(const abi::Integrator& integrator, double dt) {
    const Eigen::Index n = A_.rows();
    integrator.step(*this, {0, 0, dt});    // names the histories
    const Eigen::Index slots = Eigen::Index(slots_.size()), size = n * slots;
    for (Eigen::Index s = 0; s < slots; ++s) {
        slots_[std::size_t(s)] = Eigen::MatrixXd::Zero(n, size);
        slots_[std::size_t(s)].middleCols(s * n, n).setIdentity();
    }
    integrator.step(*this, {1, dt, dt});
    Eigen::MatrixXd map(size, size);
    for (Eigen::Index s = 0; s < slots; ++s) map.middleRows(s * n, n) = slots_[std::size_t(s)];
    std::vector<Eigen::Index> kept;    // scratch arrays influence nothing: their columns are zero
    for (Eigen::Index c = 0; c < size; ++c)
        if (c < n || !map.col(c).isZero(0)) kept.push_back(c);
    return map(kept, kept).eval();
}

}    // namespace sphonic
