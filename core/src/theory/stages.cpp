#include <sphonic/stability.hpp>

#include <map>

namespace sphonic {
namespace {

/// Sees how an integrator goes about a step: whether it ever puts an earlier state back, or settles one time twice,
/// and how many rates it asks for.
class Witness final : public abi::System {
public:
    explicit Witness(int groups) : groups_(groups) {}
    bool saw_stages() const { return saw_stages_; }
    int evaluations() const { return evaluations_; }

    int groups() const override { return groups_; }
    abi::Slot history(const char* name) override { return slots_.emplace(name, int(slots_.size()) + 1).first->second; }
    void rate(abi::Group group, double, abi::Slot) override { evaluations_ += group != abi::positions; }
    void advance(abi::Group group, double, double) override { evaluations_ += group != abi::positions; }
    void copy(abi::Group, abi::Slot, abi::Slot to) override { saw_stages_ = saw_stages_ || to == abi::state; }
    void axpy(abi::Group, double, abi::Slot, abi::Slot) override {}
    void settle(abi::Group group, double t) override {
        const auto [last, first] = settled_.emplace(group, t);
        saw_stages_ = saw_stages_ || (!first && t <= last->second);
        last->second = t;
    }

private:
    int groups_, evaluations_ = 0;
    bool saw_stages_ = false;
    std::map<std::string, abi::Slot> slots_;
    std::map<abi::Group, double> settled_;
};

}    // namespace

bool works_in_stages(const Case& scene) {
    const int groups = int(scene.equations.order.size());
    Witness start(groups), later(groups);    // a first step that differs does no harm
    scene.integrator->step(start, {0, 0, 1});
    for (long index = 1; index < 3; ++index) scene.integrator->step(later, {index, double(index), 1});
    return later.saw_stages();
}

int evaluations_per_step(const Case& scene, long index) {
    Witness witness(int(scene.equations.order.size()));
    scene.integrator->step(witness, {index, double(index), 1});
    return witness.evaluations();
}

}    // namespace sphonic
