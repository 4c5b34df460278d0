#include "lattice_ghosts.hpp"

#include <algorithm>

#include "parallel.hpp"

namespace sphonic {

LatticeGhosts::LatticeGhosts(const Case& scene, const Components& components, const ParticleMedia& media, const Layout& layout, const LatticeTiles& tiles, int threads)
    : scene_(scene), components_(components), media_(media), layout_(layout), tiles_(tiles), threads_(threads), memory_(std::size_t(6 * components.count)) {}

std::vector<std::span<double>> LatticeGhosts::remembered() {
    std::vector<std::span<double>> all;
    for (const auto& memory : memory_)
        if (memory)
            for (auto& layer : memory->kept.values) all.emplace_back(layer);
    return all;
}

void LatticeGhosts::restart() {
    for (auto& memory : memory_) memory.reset();
}

long LatticeGhosts::columns(int axis) const {
    long product = 1;
    for (int a = 0; a < layout_.dimension; ++a)
        if (a != axis) product *= layout_.count[a] + 2 * layout_.ghosts[a];
    return product;
}

template <class Real>
void LatticeGhosts::fill(int component, Real* field, const Real* pressure, double t) {
    for (int a = 0; a < layout_.dimension; ++a) {
        if (scene_.box.periodic[a]) {
            if (reached(a, false) || reached(a, true)) wrap(field, a);
            continue;
        }
        for (const bool upper : {false, true}) {
            const abi::Closure closure = scene_.closure(a, upper);
            if (closure == abi::Closure::mirror && reached(a, upper)) mirror(field, component, a, upper);
            if (closure == abi::Closure::layers) layers(field, pressure, component, t, a, upper);
        }
    }
}

/// Does the face see anything but rest?
bool LatticeGhosts::reached(int axis, bool upper) const { return tiles_.reaches(axis, upper, layout_.ghosts[axis] + 2); }

/// Enough to share among threads?
bool LatticeGhosts::worthwhile(int axis) const { return columns(axis) * layout_.ghosts[axis] > 20 * block_length; }

/// Calls line(first particle of a line along the axis, column) for all lines, those through the ghosts of other axes too.
template <class Real, class Line>
void LatticeGhosts::for_lines(Real* field, int axis, Line line) const {
    const Layout& l = layout_;
    const int b = axis == 0 ? 1 : 0, c = axis == 2 ? 1 : 2;
    const long in_row = l.count[b] + 2 * l.ghosts[b];
    in_parallel(worthwhile(axis) ? threads_ : 1, l.count[c] + 2 * l.ghosts[c], [=, &l](long k) {
        Real* row = field + l.origin - l.ghosts[b] * l.stride[b] + (k - l.ghosts[c]) * l.stride[c];
        for (long j = 0; j < in_row; ++j) line(row + j * l.stride[b], k * in_row + j);
    });
}

template <class Real>
void LatticeGhosts::wrap(Real* field, int axis) const {
    const long n = layout_.count[axis], g = layout_.ghosts[axis], step = layout_.stride[axis];
    for_lines(field, axis, [=](Real* line, long) {
        for (long i = 1; i <= g; ++i) {
            line[-i * step] = line[(n - 1 - (i - 1) % n) * step];
            line[(n - 1 + i) * step] = line[(i - 1) % n * step];
        }
    });
}

template <class Real>
void LatticeGhosts::mirror(Real* field, int component, int axis, bool upper) const {
    const abi::Boundary& wall = *scene_.face(axis, upper);
    const Real sign = Real(wall.parity(components_.part(component, axis))), rest = Real(components_.rest(component));
    const long n = layout_.count[axis], g = layout_.ghosts[axis], own = wall.half_way() ? 1 : 0;
    const long step = upper ? layout_.stride[axis] : -layout_.stride[axis], face = upper ? (n - 1) * layout_.stride[axis] : 0;
    const bool vanishes = sign < 0 && own == 0;
    for_lines(field, axis, [=](Real* line, long) {
        Real* last = line + face;
        if (vanishes) *last = rest;
        for (long i = 1; i <= g; ++i) last[i * step] = rest + sign * (last[(own - i) * step] - rest);
    });
}

LatticeGhosts::Rows::Rows(long layers, long columns)
    : values(std::size_t(layers), std::vector<double>(std::size_t(columns), 0.0)) {
    for (auto& row : values) pointers.push_back(row.data());
}

LatticeGhosts::Memory::Memory(long layers, long columns)
    : inner(layers + 2, columns), pressure(layers + 2, columns), kept(layers + 1, columns), kept_before(layers + 1, columns), ghost(layers + 1, columns) {}

double LatticeGhosts::Memory::begin(double t) {
    const bool again = last == t;
    const Rows& from = again ? kept_before : kept;
    for (std::size_t k = 0; k < from.values.size(); ++k) std::copy(from.values[k].begin(), from.values[k].end(), (again ? kept : kept_before).pointers[k]);
    if (!again) one_before = last;
    last = t;
    return one_before ? t - *one_before : 0;
}

std::vector<double*> LatticeGhosts::Rows::from(long column) {
    std::vector<double*> shifted;
    for (double* row : pointers) shifted.push_back(row + column);
    return shifted;
}

/// In the order of for_lines; those through ghosts are of the nearest particle's medium.
std::vector<LatticeGhosts::Stretch> LatticeGhosts::stretches(int axis, bool upper) const {
    const Layout& l = layout_;
    const std::size_t a = std::size_t(axis), b = axis == 0 ? 1 : 0, c = axis == 2 ? 1 : 2;
    std::vector<Stretch> all;
    std::array<long, 3> site{};
    site[a] = upper ? l.count[axis] - 1 : 0;
    long column = 0;
    for (long k = -l.ghosts[c]; k < l.count[c] + l.ghosts[c]; ++k)
        for (long j = -l.ghosts[b]; j < l.count[b] + l.ghosts[b]; ++j, ++column) {
            site[b] = std::clamp(j, 0L, l.count[b] - 1);
            site[c] = std::clamp(k, 0L, l.count[c] - 1);
            const int medium = media_.number(site[0] + l.count[0] * (site[1] + l.count[1] * site[2]));
            if (all.empty() || all.back().medium != medium) all.push_back({medium, column, 0});
            ++all.back().n;
        }
    return all;
}

template <class Real>
void LatticeGhosts::layers(Real* field, const Real* pressure, int component, double t, int axis, bool upper) {
    const long n = layout_.count[axis], g = layout_.ghosts[axis];
    auto& kept = memory_[std::size_t(6 * component + 2 * axis + upper)];
    if (!kept) {
        kept = std::make_unique<Memory>(g, columns(axis));
        kept->stretches = stretches(axis, upper);
    }
    Memory& memory = *kept;
    const abi::Part part = components_.part(component, axis);
    const long step = upper ? layout_.stride[axis] : -layout_.stride[axis], face = upper ? (n - 1) * layout_.stride[axis] : 0;
    const double sign = part == abi::Part::normal && !upper ? -1 : 1, rest = components_.rest(component);    // outwards is positive
    for_lines(field, axis, [&](Real* line, long column) {
        for (long k = 0; k <= g + 1; ++k) {
            const Real* at = line + face - std::min(k, n - 1) * step;
            memory.inner.pointers[std::size_t(k)][column] = sign * (*at - rest);
            memory.pressure.pointers[std::size_t(k)][column] = pressure[at - field];
        }
    });
    const double dt = memory.begin(t);
    for (const Stretch& s : memory.stretches) {
        const auto inner = memory.inner.from(s.first), p = memory.pressure.from(s.first), kept = memory.kept.from(s.first),
                   ghost = memory.ghost.from(s.first);
        scene_.face(axis, upper)->fill({.part = part, .n = int(s.n), .layers = int(g), .t = t, .dt = dt,
                                        .dx = scene_.box.dx, .medium = media_.list()[std::size_t(s.medium)], .inner = inner.data(),
                                        .pressure = p.data(), .memory = kept.data(), .ghost = ghost.data()});
    }
    for_lines(field, axis, [&](Real* line, long column) {
        for (long k = 0; k <= g; ++k) line[face + k * step] = Real(rest + sign * memory.ghost.pointers[std::size_t(k)][column]);
    });
}

template void LatticeGhosts::fill<double>(int, double*, const double*, double);
template void LatticeGhosts::fill<float>(int, float*, const float*, double);

}    // namespace sphonic
