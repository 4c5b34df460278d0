#include <cstdio>
#include <iostream>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/log.hpp>
#include <sphonic/result_folder.hpp>
#include <sphonic/stability_table.hpp>

#include "commands.hpp"
#include "interruption.hpp"

namespace sphonic::driver {
namespace {

void print(const LimitTable& table, long failed) {
    std::printf("predicted against measured limits of the step\n  %-10s %5s  %-18s %s\n", "group", "rows", "largest deviation", "allowed");
    for (const LimitTable::Worst& w : table.worst()) std::printf("  %-10s %5d  %14.2f %%   %5g %%\n", w.group.c_str(), w.rows, 100 * w.deviation, 100 * w.allowed);
    if (failed > 0) std::printf("  %ld rows are beyond what is allowed\n", failed);
}

}    // namespace

int stability_table(const StabilityOptions& options) {
    const Interruptible interruptible;
    Registry registry(Registry::search_path(options.plugin_path));
    LimitTable table(registry);
    ResultFolder folder(options.out.empty() ? ResultFolder::unused("stability-table") : options.out, options.force);
    long failed = 0;
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const std::string counted = std::to_string(i + 1) + "/" + std::to_string(table.rows().size()) + " ";
        const LimitTable::Row& row = table.find(i, [&](double, const std::string&) { interruptible.stop_if_asked("--table", "in row " + counted + "; nothing was written"); });
        char figures[120];
        std::snprintf(figures, sizeof figures, ": c0 dt/dx predicted %.4f, measured %.4f, %+.2f %%", row.predicted, row.measured, 100 * row.deviation());
        log::info(counted + name_of(row) + figures);
        failed += !row.holds();
    }
    folder.write("table.csv", table.csv());
    folder.commit();
    if (options.json)
        std::cout << json_text(table.json());
    else
        print(table, failed), std::printf("  all rows are in %s\n", (folder.target() / "table.csv").string().c_str());
    return failed == 0 ? 0 : int(Fault::diverged);
}

}    // namespace sphonic::driver
