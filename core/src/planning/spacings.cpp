#include "spacings.hpp"

#include <algorithm>
#include <cmath>

namespace sphonic {
namespace {

/// Next to which spacing the next is tried: closer where theory judges, for runs cost more than a coarser spacing saves.
double next_spacing(const OpenCase& open) { return displaced(open) || several_media(open) ? 1.1 : 1.05; }

/// Whole numbers of spacings are counted along it.
int shortest_axis(const OpenCase& open) {
    int first = 0;
    for (int a = 1; a < open.dimension(); ++a)
        if (open.length(a) < open.length(first)) first = a;
    return first;
}

/// The next whole number from n on that parts every closed axis into whole spacings; 0 if there is none near.
long fitting(const OpenCase& open, int first, long n) {
    for (long tried = n; tried < n + 3000; ++tried) {
        bool fits = true;
        for (int a = 0; a < open.dimension(); ++a) {
            const double spacings = open.length(a) / open.length(first) * double(tried);
            fits = fits && (!open.whole(a) || std::abs(spacings - std::round(spacings)) < 1e-7);
        }
        if (fits) return tried;
    }
    return 0;
}

/// The spacing next to `wanted` with which the first stratum of a medium has its ends on particles where they are the box's, and half
/// a spacing from them where it meets another medium. `wanted` if there is none.
double fitting_stratum(const std::vector<Stratum>& strata, int medium, double wanted) {
    for (std::size_t k = 0; k < strata.size(); ++k) {
        if (strata[k].medium != medium) continue;
        const double halves = 0.5 * double((k > 0) + (k + 1 < strata.size())), length = strata[k].end - strata[k].begin;
        return length / std::max(1.0, std::round(length / wanted - halves) + halves);
    }
    return wanted;
}

}    // namespace

double spread(const OpenCase& open, double dx, Json& document) {
    Json& media = document["medium"];
    const double first = open.spacing ? fitting_stratum(open.strata, 0, dx) : dx;
    for (std::size_t m = 1; m < media.size(); ++m) media[m]["dx"] = fitting_stratum(open.strata, int(m), first * speed(media[m]) / speed(media[0]));
    return first;
}

std::vector<double> spacings(const OpenCase& open, double coarsest, double most_particles) {
    if (!open.spacing) return {open.document["particles"]["dx"].get<double>()};
    const int first = shortest_axis(open);
    double volume = 1;
    for (int a = 0; a < open.dimension(); ++a) volume *= open.length(a);
    std::vector<double> list;
    double wanted = std::max(4.0, std::ceil(open.length(first) / coarsest));
    for (long n = fitting(open, first, long(wanted)); n > 0; n = fitting(open, first, std::max(n + 1, long(std::round(wanted))))) {
        const double dx = open.length(first) / double(n);
        if (volume / std::pow(dx, open.dimension()) > most_particles) break;
        for (long more = 0; more < (several_media(open) ? 4 : 1); ++more)
            if (fitting(open, first, n + more) == n + more) list.push_back(open.length(first) / double(n + more));
        wanted = next_spacing(open) * double(n);
    }
    return list;
}

std::vector<double> spacings_between(const OpenCase& open, double coarser, double finer) {
    constexpr std::size_t most = 3;
    if (!open.spacing) return {};
    const int first = shortest_axis(open);
    std::vector<double> all, few;
    const long end = std::lround(open.length(first) / finer);
    for (long n = fitting(open, first, std::lround(open.length(first) / coarser) + 1); n > 0 && n < end; n = fitting(open, first, n + 1)) all.push_back(open.length(first) / double(n));
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i) few.push_back(all[i * all.size() / std::min(most, all.size())]);
    return few;
}

}    // namespace sphonic
