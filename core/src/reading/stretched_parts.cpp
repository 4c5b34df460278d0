#include "stretched_parts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <sphonic/error.hpp>

namespace sphonic {
namespace {

constexpr int block = 256;    ///< points that are taken over at a time

/// Calls visit(first, points in x) for blocks of points in s.
template <class Visit>
void for_blocks(const Stretch& stretch, const abi::Points& points, Visit visit) {
    double x[block];
    for (int first = 0; first < points.n; first += block) {
        const int n = std::min(block, points.n - first);
        for (int i = 0; i < n; ++i) x[i] = stretch.place(points.x[0][first + i]);
        visit(first, abi::Points{.dimension = 1, .n = n, .x = {x}});
    }
}

/// A source of x that is asked in s. It is prepared already.
class StretchedSource final : public abi::Source {
public:
    /// `place`, of the source in its case, stands in errors.
    StretchedSource(std::unique_ptr<abi::Source> plain, const Case& scene, const std::string& place) : plain_(std::move(plain)), stretch_(scene.stretch) {
        if (plain_->action().adds) find_factor(scene, place);
        if (!plain_->wave()) return;
        wave_ = *plain_->wave();
        wave_->origin[0] = stretch_->site(wave_->origin[0]);
    }

    abi::Action action() const override { return plain_->action(); }
    void prepare(const abi::SourceScene&) override {}
    void reach(const abi::Points& points, unsigned char* inside) const override {
        for_blocks(*stretch_, points, [&](int first, const abi::Points& x) { plain_->reach(x, inside + first); });
    }
    void enlist(const abi::Points& points, double volume) override {
        std::vector<double> x(points.x[0], points.x[0] + points.n);
        for (double& s : x) s = stretch_->place(s);
        plain_->enlist({.dimension = 1, .n = points.n, .x = {x.data()}}, factor_ * volume);
    }
    double tone() const override { return plain_->tone(); }
    double highest_frequency() const override { return plain_->highest_frequency(); }
    void match(const abi::ToneResponse& response) override { plain_->match({response.wave_number / factor_, response.gain}); }
    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        for_blocks(*stretch_, points, [&](int first, const abi::Points& x) {
            plain_->evaluate(t, x, {.p = out.p ? out.p + first : nullptr, .u = {out.u[0] ? out.u[0] + first : nullptr}});
        });
    }
    const abi::PlaneWave* wave() const override { return wave_ ? &*wave_ : nullptr; }

private:
    std::unique_ptr<abi::Source> plain_;
    std::shared_ptr<const Stretch> stretch_;
    std::optional<abi::PlaneWave> wave_;
    double factor_ = 1;    ///< of the particles that a supply of sound is spread over

    void find_factor(const Case& scene, const std::string& place) {
        bool found = false;
        for (long i = 0; i < scene.box.count[0]; ++i) {
            const double s = scene.box.lower[0] + double(i) * scene.box.dx;
            unsigned char inside = 0;
            reach({.dimension = 1, .n = 1, .x = {&s}}, &inside);
            if (!inside) continue;
            if (found && stretch_->factor(s) != factor_)
                throw Error(Fault::input, place, "it is spread over particles of media with different dx", "Move it further into one medium, choose a smaller dx, or give both media one dx");
            factor_ = stretch_->factor(s);
            found = true;
        }
    }
};

/// A face of x that is asked in s: what it takes by distance is its own, the rest is the same for every spacing.
class StretchedFace final : public abi::Boundary {
public:
    StretchedFace(const abi::Boundary& plain, std::shared_ptr<const Stretch> stretch, double s, bool upper) : plain_(plain), stretch_(std::move(stretch)), s_(s), inwards_(upper ? -1 : 1) {}

    abi::Closure closure() const override { return plain_.closure(); }
    bool half_way() const override { return plain_.half_way(); }
    int parity(abi::Part part) const override { return plain_.parity(part); }
    double damping(double distance, const abi::Medium& medium) const override {
        const double s = s_ + inwards_ * distance;
        return plain_.damping(std::abs(stretch_->place(s) - stretch_->place(s_)), Stretch::seen(medium, 1 / stretch_->factor(s)));
    }
    double admittance() const override { return plain_.admittance(); }
    void fill(const abi::GhostLayers& layers) const override { plain_.fill(layers); }
    bool pressure_suffices() const override { return plain_.pressure_suffices(); }

private:
    const abi::Boundary& plain_;
    std::shared_ptr<const Stretch> stretch_;
    double s_, inwards_;
};

}    // namespace

void enter(Case& scene) {
    for (SourceUse& use : scene.sources) use.source = std::make_unique<StretchedSource>(std::move(use.source), scene, use.place);
    scene.box.upper[0] = scene.stretch->site(scene.box.upper[0]);
    for (const bool upper : {false, true})
        if (const abi::Boundary* face = scene.face(0, upper)) scene.stretched_faces[upper] = std::make_unique<StretchedFace>(*face, scene.stretch, upper ? scene.box.upper[0] : scene.box.lower[0], upper);
    scene.media = std::make_shared<MediaMap>(scene.media, scene.stretch);
    for (Variable& variable : scene.equations.variables)
        for (Term& term : variable.terms)
            for (std::size_t m = 0; term.form && m < term.coefficient.size(); ++m) term.coefficient[m] /= scene.stretch->factors()[m];
}

}    // namespace sphonic
