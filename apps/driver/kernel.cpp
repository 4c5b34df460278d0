#include <cstdio>
#include <iostream>
#include <optional>

#include <sphonic/json.hpp>
#include <sphonic/result_folder.hpp>

#include "commands.hpp"
#include "kernel_page.hpp"

namespace sphonic::driver {
namespace {

Json optional_json(const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); }

Json row_json(const KernelRow& r) {
    return {{"dimension", r.dimension}, {"h_over_dx", r.h_over_dx}, {"neighbours", r.neighbours}, {"speed_error", r.speed_error}, {"cutoff_ppw", r.cutoff_ppw},
            {"courant_dx", r.courant_dx}, {"ppw_1_percent", optional_json(r.ppw_1_percent)}, {"ppw_01_percent", optional_json(r.ppw_01_percent)}, {"work", optional_json(r.work())}};
}

Json card_json(const KernelCard& card, const Ranking& ranking) {
    Json rows = Json::array(), best = Json::array(), laws = Json::array(), ranked = Json::array(), pairing = Json::array();
    for (const KernelRow& r : card.rows) rows.push_back(row_json(r));
    for (const KernelRow& r : card.recommended) best.push_back(row_json(r));
    for (const KernelLaw& l : card.laws) laws.push_back({{"law", l.what}, {"dimension", l.dimension}, {"value", l.value}, {"holds", l.holds}});
    for (const KernelTransform& t : card.transforms) pairing.push_back({{"dimension", t.dimension}, {"least_transform", t.least}});
    for (const auto& [name, r] : ranking) ranked.push_back({{"kernel", name}, {"h_over_dx", r.h_over_dx}, {"work", *r.work()}});
    return {{"name", card.name}, {"dimensions", card.dimensions}, {"support", card.support}, {"rows", rows}, {"recommended", best}, {"laws", laws}, {"pairing", pairing},
            {"ranking", ranked}};
}

void print_rows(const std::vector<KernelRow>& rows) {
    std::printf("  %3s %6s %10s %12s %8s %8s %8s  largest stable c0 dt/dx\n", "dim", "h/dx", "neighbours", "speed error", "cut-off", "1 %", "0.1 %");
    for (const KernelRow& r : rows) {
        std::printf("  %3d %6s %10d %11.3f%% %8s %8s %8s ", r.dimension, shown(r.h_over_dx).c_str(), r.neighbours, 100 * r.speed_error, shown(r.cutoff_ppw).c_str(),
                    shown(r.ppw_1_percent).c_str(), shown(r.ppw_01_percent).c_str());
        for (const auto& [name, limit] : r.courant_dx) std::printf(" %s %.3f", name.c_str(), limit);
        std::printf("\n");
    }
}

void print(const KernelCard& card, const Ranking& ranking) {
    std::printf("%s: %s\nsupport %s h\n\nlaws\n", card.name.c_str(), card.doc.c_str(), shown(card.support).c_str());
    for (const KernelLaw& l : card.laws) std::printf("  %-28s %d-D  %s (%.2g)\n", l.what.c_str(), l.dimension, l.holds ? "yes" : "NO", l.value);
    for (const KernelTransform& t : card.transforms)
        std::printf("  %-28s %d-D  %s\n", "has no negative transform", t.dimension, t.least < 0 ? ("NO (" + shown(t.least) + "): many neighbours clump").c_str() : "yes");
    std::printf("\nsound on a lattice: speed of long waves and steps by the plain pair of forms; cut-off and points per wavelength for an error after ten\n"
                "wavelengths by corrected weights, time being exact, in the worse of axis and diagonal\n");
    print_rows(card.rows);
    std::printf("\nh/dx of least work for 1 %%\n");
    print_rows(card.recommended);
    if (ranking.empty()) return;
    std::printf("\namong the others in %d-D, by pairs for a volume of one wavelength's edges over a period at 1 %%\n", ranking.front().second.dimension);
    for (const auto& [name, r] : ranking)
        std::printf("  %-20s h/dx %-5s %4d neighbours, %s points: %.3g\n", name.c_str(), shown(r.h_over_dx).c_str(), r.neighbours, shown(r.ppw_1_percent).c_str(), *r.work());
}

Json cards_json(const std::vector<KernelCard>& cards, const Ranking& ranking) {
    Json all = Json::array();
    for (const KernelCard& card : cards) all.push_back(card_json(card, ranking));
    return cards.size() == 1 ? all[0] : all;
}

void write(ResultFolder& results, const std::vector<KernelCard>& cards, const Ranking& ranking) {
    results.write("summary.json", json_text(cards_json(cards, ranking)));
    for (const KernelCard& card : cards) {
        const auto stem = results.path() / card.name;
        draw(kernel_chart(card), stem);
        results.write(card.name + ".html", kernel_page(card, ranking, stem.string() + ".svg"));
    }
    if (cards.size() > 1) draw(kernel_comparison(cards), results.path() / "comparison");
    results.commit();
}

}    // namespace

int kernel(const KernelOptions& options) {
    Registry registry(Registry::search_path(options.plugin_path));
    std::vector<std::string> names{options.name};
    names.insert(names.end(), options.compare.begin(), options.compare.end());
    std::optional<ResultFolder> results;
    if (!options.out.empty()) results.emplace(options.out, options.force);
    std::vector<KernelCard> cards;
    for (const std::string& name : names) cards.push_back(kernel_card(registry, name));
    const int dimension = options.dimension > 0 ? options.dimension : cards.front().dimensions.back() > 1 ? 2 : 1;
    const Ranking ranking = rank_kernels(registry, options.compare.empty() ? registry.names("kernel") : names, dimension);
    if (results) write(*results, cards, ranking);
    if (options.json) {
        std::cout << json_text(cards_json(cards, ranking));
        return 0;
    }
    for (const KernelCard& card : cards) {
        print(card, &card == &cards.back() ? ranking : Ranking{});
        std::printf("\n");
    }
    if (!options.out.empty()) std::printf("results in %s\n", options.out.string().c_str());
    return 0;
}

}    // namespace sphonic::driver
