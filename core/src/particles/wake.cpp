#include "wake.hpp"

#include <cmath>
#include <stdexcept>

#include "distance_map.hpp"

namespace sphonic {
namespace {

/// No asked-for number changes by more, over the largest amplitude.
constexpr double promise = 1e-12;
/// Steps from one look at the amplitude of sources to the next.
constexpr long now_and_then = 8;

}    // namespace

Wake::Wake(const abi::Box& box, LatticeTiles& tiles, const Layout& layout, Plan plan, std::vector<Watched> watched)
    : tiles_(tiles), plan_(std::move(plan)), watched_(std::move(watched)), awake_(std::size_t(tiles.count()), 0) {
    const double values = double(layout.particles()) * double(watched_.size());
    threshold_ = promise / (3 * plan_.growth * double(plan_.steps) * std::sqrt(values));    // for quiet particles once, for what stands still twice
    std::vector<char> has_source(awake_);
    for (const std::ptrdiff_t place : plan_.sources) has_source[std::size_t(tiles.of(place))] = 1;
    std::vector<long> all;
    for (long t = 0; t < tiles.count(); ++t) all.push_back(t);
    const std::vector<Heard> heard = hear(all);
    still_.assign(all.size(), 0);
    for (const long t : all) {
        const double most = heard[std::size_t(t)].most;
        if (most > threshold_ * amplitude_)
            wake(t);
        else
            still_[std::size_t(t)] = most * most * double(tiles.particles(t)) * double(watched_.size());
        still_squares_ += still_[std::size_t(t)];
        if (!has_source[std::size_t(t)]) continue;
        source_tiles_.push_back(t);
        wake(t);
        wake_near(tiles.sites(t), std::max(plan_.first_reach, plan_.reach));
    }
    find_distances(box, layout);
    listen(plan_.first_reach);
    choose();
}

Wake::Heard Wake::hear(long tile, double threshold) const {
    const LatticeTiles::Sites s = tiles_.sites(tile);
    Heard heard{0, {s.last, s.first}};
    for (const Watched& w : watched_)
        for (long k = s.first[2]; k < s.last[2]; ++k)
            for (long j = s.first[1]; j < s.last[1]; ++j) {
                const double* row = w.field + tiles_.place(s.first[0], j, k);
                const long n = s.last[0] - s.first[0];
                double most = 0;
#pragma omp simd reduction(max : most)
                for (long i = 0; i < n; ++i) most = std::max(most, std::abs(row[i] - w.rest));
                heard.most = std::max(heard.most, most / w.unit);
                if (!(most > threshold * w.unit)) continue;
                long first = 0, last = n;
                while (!(std::abs(row[first] - w.rest) > threshold * w.unit)) ++first;
                while (!(std::abs(row[last - 1] - w.rest) > threshold * w.unit)) --last;
                const std::array<long, 3> low{s.first[0] + first, j, k}, high{s.first[0] + last, j + 1, k + 1};
                for (std::size_t a = 0; a < 3; ++a) {
                    heard.loud.first[a] = std::min(heard.loud.first[a], low[a]);
                    heard.loud.last[a] = std::max(heard.loud.last[a], high[a]);
                }
            }
    return heard;
}

/// By the amplitude so far, of which it then takes note.
std::vector<Wake::Heard> Wake::hear(const std::vector<long>& tiles) {
    std::vector<Heard> heard(tiles.size());
    const double threshold = threshold_ * amplitude_;
    constexpr std::size_t worthwhile = 256;
    in_parallel(tiles.size() < worthwhile ? 1 : plan_.threads, long(tiles.size()), [&](long i) { heard[std::size_t(i)] = hear(tiles[std::size_t(i)], threshold); });
    for (const Heard& h : heard) amplitude_ = std::max(amplitude_, h.most);
    return heard;
}

bool Wake::wake(long tile) {
    char& awake = awake_[std::size_t(tile)];
    if (awake) return false;
    awake = 1;
    still_squares_ = std::max(0.0, still_squares_ - still_[std::size_t(tile)]);
    front_.push_back(tile);
    return true;
}

bool Wake::wake_near(const LatticeTiles::Sites& sites, long reach) {
    bool woken = false;
    tiles_.near(sites, reach, [&](long tile) { woken = wake(tile) || woken; });
    return woken;
}

bool Wake::surrounded(long tile, long reach) const {
    bool all = true;
    tiles_.near(tiles_.sites(tile), reach, [&](long other) { all = all && awake_[std::size_t(other)]; });
    return all;
}

/// Loud particles wake what a step reaches from them. True if anything woke.
bool Wake::listen(long reach) {
    std::erase_if(front_, [&](long t) { return !asked(t); });
    const std::vector<long> listened = front_;
    const std::vector<Heard> heard = hear(listened);
    double squares = 0;
    bool woken = false;
    for (std::size_t i = 0; i < listened.size(); ++i) {
        const double quiet = std::min(heard[i].most, threshold_ * amplitude_);
        squares += quiet * quiet * double(tiles_.particles(listened[i]));
        if (heard[i].loud.first[0] < heard[i].loud.last[0]) woken = wake_near(heard[i].loud, reach) || woken;
    }
    std::erase_if(front_, [&](long t) { return surrounded(t, plan_.reach); });
    quiet_ += std::sqrt(squares * double(watched_.size()));
    return woken;
}

/// True while what a tile does in the next step can reach what is asked for.
bool Wake::asked(long tile) const {
    if (asked_distance_.empty()) return true;
    const double first = done_ == 0 ? plan_.first_radius - plan_.radius : 0, left = double(plan_.steps - done_);
    return asked_distance_[std::size_t(tile)] <= left * plan_.radius + first + 1e-9;
}

void Wake::choose() {
    std::vector<char> stepped(awake_);
    for (std::size_t t = 0; t < stepped.size() && !asked_distance_.empty(); ++t) stepped[t] = stepped[t] && asked(long(t));
    if (stepped == stepped_) return;
    tiles_.step_only(stepped);
    stepped_ = std::move(stepped);
}

void Wake::look() {
    particle_steps_ += double(tiles_.stepped());
    quiet_ += 2 * std::sqrt(still_squares_);
    if (done_ % now_and_then == 0) hear(source_tiles_);
    ++done_;
    const bool woken = !front_.empty() && listen(plan_.reach);
    if (woken || !asked_distance_.empty()) choose();
}

void Wake::wake_all() {
    if (!plan_.asked.empty()) throw std::logic_error("a step evaluates more rates than steps before it");
    for (long t = 0; t < tiles_.count(); ++t) wake(t);
    choose();
}

double Wake::error_bound() const { return amplitude_ > 0 ? plan_.growth * quiet_ / amplitude_ : 0; }

/// Of each particle from what sounds at the start, and from what is asked for.
void Wake::find_distances(const abi::Box& box, const Layout& layout) {
    std::vector<char> sounding(std::size_t(layout.size), 0);
    for (const std::ptrdiff_t place : plan_.sources) sounding[std::size_t(place)] = 1;
    for (const Watched& w : watched_)
        layout.for_rows([&](long row, long) {
            for (long i = row; i < row + layout.count[0]; ++i) sounding[std::size_t(i)] |= std::abs(w.field[i] - w.rest) > threshold_ * amplitude_ * w.unit;
        });
    const auto index = field_indices(layout);
    std::vector<char> start;
    for (const std::ptrdiff_t i : index) start.push_back(sounding[std::size_t(i)]);
    std::vector<double> from = distances(box, start);
    if (!plan_.asked.empty()) {
        asked_distance_.assign(std::size_t(tiles_.count()), std::numeric_limits<double>::infinity());
        const std::vector<double> to = distances(box, plan_.asked);
        for (std::size_t i = 0; i < to.size(); ++i) {
            double& nearest = asked_distance_[std::size_t(tiles_.of(index[i]))];
            nearest = std::min(nearest, to[i]);
            from[i] += to[i];
        }
    }
    for (const double way : from) ideal_steps_ += std::max(0.0, double(plan_.steps) - way / plan_.courant);
}

}    // namespace sphonic
