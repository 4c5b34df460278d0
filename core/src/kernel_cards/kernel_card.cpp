#include <sphonic/kernel_card.hpp>

#include <algorithm>

#include <sphonic/parameters.hpp>

#include "kernel_case.hpp"
#include "kernel_laws.hpp"
#include "kernel_rows.hpp"

namespace sphonic {
namespace {

/// For kernels of support 2 h; others get those with the same radii, to the nearest tenth.
constexpr double usual_h_over_dx[] = {1, 1.3, 1.6, 2, 3.2};

}    // namespace

KernelCard kernel_card(Registry& registry, const std::string& name) {
    const Plugin& plugin = registry.find("kernel", name, "kernel");
    const Case any = kernel_case(registry, name, 1, 1, Pairing::plain);
    const abi::Kernel& kernel = *any.kernels.front().kernel;
    KernelCard card{.name = name, .doc = plugin.doc, .file = plugin.file.string(), .support = kernel.support()};
    card.laws = kernel_laws(kernel);
    const KernelRows rows(registry);
    for (int d = 1; d <= 3; ++d) {
        if (!kernel.defined(d)) continue;
        card.dimensions.push_back(d);
        card.transforms.push_back(kernel_transform(kernel, d));
        for (const double h : usual_h_over_dx)
            if (const auto row = rows.row(name, d, h)) card.rows.push_back(*row);
        if (const auto best = rows.best(name, d)) card.recommended.push_back(*best);
    }
    for (const double h : usual_h_over_dx)
        if (rows.row(name, card.dimensions.front(), h)) card.dispersion.push_back(rows.dispersion(name, card.dimensions.front(), h));
    return card;
}

std::vector<std::pair<std::string, KernelRow>> rank_kernels(Registry& registry, const std::vector<std::string>& kernels, int dimension) {
    const KernelRows rows(registry);
    std::vector<std::pair<std::string, KernelRow>> ranked;
    for (const std::string& name : kernels)
        if (const auto best = rows.best(name, dimension)) ranked.emplace_back(name, *best);
    std::sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return *a.second.work() < *b.second.work(); });
    return ranked;
}

}    // namespace sphonic
