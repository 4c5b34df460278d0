#include <sphonic/plugin/source.hpp>

#include <stdexcept>

/// p and u of the case's reference, set on the particles of its region at every step: an inflow without error of its own.
struct ExactSource final : abi::Source {
    abi::Action action() const override {
        return {.sets_pressure = true, .sets_velocity = true, .sets_velocity_at_start = true};
    }
    void prepare(const abi::SourceScene& scene) override {
        reference = scene.reference;
        if (!reference) throw std::invalid_argument("there is no reference to take the field from: add a reference to the case");
    }
    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        reference->evaluate(t, points, out);
    }

private:
    const abi::Reference* reference = nullptr;
};

SPHONIC_SOURCE("exact", ExactSource, "The reference's pressure and velocity, imposed on the particles of its region")
