#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include <sphonic/atlas.hpp>
#include <sphonic/error.hpp>
#include <sphonic/stability.hpp>

namespace sphonic {
namespace {

constexpr int samples = 200;        ///< of a run's loudness
constexpr double louder = 1.5;      ///< than before is growth

std::string text(const char* format, double value) {
    char buffer[120];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

double rms(const abi::Snapshot& shot) {
    const double squares = std::accumulate(shot.p, shot.p + shot.points.n, 0.0, [](double sum, double p) { return sum + p * p; });
    return std::sqrt(squares / shot.points.n);
}

/// The loudest of the second half of a run over that of the first.
double growth(const AtlasRun& run) {
    const auto middle = std::ranges::lower_bound(run.t, 0.5 * run.t.back()) - run.t.begin();
    const auto loudest = [&](long begin, long end) { return *std::max_element(run.loudness.begin() + begin, run.loudness.begin() + end); };
    return loudest(middle, long(run.t.size())) / loudest(0, std::max(1L, middle));
}

/// Mean distance of particles from their nearest neighbours, over dx; on an axis that repeats, round it.
double nearest_over_dx(const Case& scene, const Profile& now) {
    double sum = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        double least = INFINITY;
        for (std::size_t j = 0; j < now.p.size(); ++j) {
            double square = 0;
            for (int a = 0; a < scene.box.dimension; ++a) {
                double r = now.x[a][i] - now.x[a][j];
                if (const double side = scene.box.upper[a] - scene.box.lower[a]; scene.closure(a, true) == abi::Closure::periodic) r -= side * std::nearbyint(r / side);
                square += r * r;
            }
            if (i != j) least = std::min(least, square);
        }
        sum += std::sqrt(least);
    }
    return sum / double(now.p.size()) / scene.box.dx;
}

/// What came of a run, in words, and whether that is as told.
struct Verdict {
    std::string outcome;
    bool as_told;
};

/// Of a case that could be prepared.
Verdict judge(const AtlasRow& row, bool cure, const Case& scene, const Summary& summary, const AtlasRun& run) {
    if (summary.diverged) return {text("diverged at t = %.3g s", summary.t), !cure && row.fails == Failing::diverges};
    switch (row.fails) {
        case Failing::errs: {
            if (!summary.errors) return {"has no reference", false};
            const double l2 = summary.errors->l2;
            return {text("L2 error %.3g", l2), cure ? l2 <= row.good : l2 >= row.bad};
        }
        case Failing::clumps: {
            const double apart = nearest_over_dx(scene, run.last);
            return {text("nearest neighbours %.3g dx apart on average", apart), cure ? apart >= row.good : apart <= row.bad};
        }
        case Failing::warned: {
            const auto said = std::ranges::find_if(summary.warnings, [&](const std::string& w) { return w.find(row.says) != std::string::npos; });
            const bool warned = said != summary.warnings.end();
            return {warned ? "warned: " + *said : "no warning", warned != cure};
        }
        default: {
            const double grown = growth(run);
            return {text("ran to its end, %.3g times as loud in its second half", grown), cure && grown <= louder};
        }
    }
}

Case load_variant(const Atlas& atlas, const AtlasRow& row, const AtlasVariant& variant, Registry& registry) {
    Json document = read_json(row.scene);
    for (const auto& [pointer, value] : variant.set) set_at(document, pointer, value, atlas.file.string() + ": row " + row.name + ", " + variant.name);
    Case scene = load_case(std::move(document), row.scene, registry);
    scene.threads = 1;
    scene.output = {.every = scene.until / samples, .probes = {{scene.box.lower, scene.box.lower + scene.box.dimension}}};
    return scene;
}

AtlasRun run_variant(const Atlas& atlas, const AtlasRow& row, const AtlasVariant& variant, bool cure, Registry& registry, const std::function<void()>& progress) {
    AtlasRun run{.variant = &variant, .outcome = {}, .predicted = {}, .t = {}, .loudness = {}, .last = {}};
    try {
        const Case scene = load_variant(atlas, row, variant, registry);
        Simulation simulation(scene);
        const auto listen = [&] {
            run.t.push_back(simulation.solver().time());
            run.loudness.push_back(rms(simulation.solver().snapshot()));
        };
        listen();
        simulation.run([&](const Progress&) {
            if (progress) progress();
            if (simulation.solver().time() >= run.t.back() + scene.until / samples / 2) listen();
        });
        run.last = simulation.summary().diverged ? simulation.last_good() : simulation.profile();
        run.dx = scene.box.dx;
        if (const Summary& s = simulation.summary(); row.fails == Failing::diverges) run.predicted = double(s.steps) * StepTheory(scene).growth(s.dt);
        const Verdict verdict = judge(row, cure, scene, simulation.summary(), run);
        run.outcome = verdict.outcome, run.as_told = verdict.as_told;
    } catch (const Error& e) {
        if (e.fault != Fault::input) throw;
        run.outcome = std::string("refused: ") + e.what();
        run.as_told = !cure && row.fails == Failing::refused;
    }
    return run;
}

}    // namespace

bool AtlasResult::as_told() const {
    const auto told = [](const AtlasRun& run) { return run.as_told; };
    return std::ranges::all_of(failures, told) && std::ranges::all_of(cures, told);
}

AtlasResult run_row(const Atlas& atlas, const AtlasRow& row, Registry& registry, const std::function<void()>& progress) {
    AtlasResult result;
    for (const AtlasVariant& variant : row.failures) result.failures.push_back(run_variant(atlas, row, variant, false, registry, progress));
    for (const AtlasVariant& variant : row.cures) result.cures.push_back(run_variant(atlas, row, variant, true, registry, progress));
    return result;
}

Json to_json(const AtlasRow& row, const AtlasResult& result) {
    const auto listed = [](const std::vector<AtlasRun>& runs) {
        Json list = Json::array();
        for (const AtlasRun& run : runs)
            list.push_back({{"name", run.variant->name}, {"set", run.variant->overrides()}, {"outcome", run.outcome}, {"predicted_exponent", run.predicted ? Json(*run.predicted) : Json(nullptr)},
                            {"as_told", run.as_told}});
        return list;
    };
    return {{"name", row.name}, {"title", row.title}, {"case", row.scene.string()}, {"as_told", result.as_told()}, {"failures", listed(result.failures)}, {"cures", listed(result.cures)}};
}

}    // namespace sphonic
