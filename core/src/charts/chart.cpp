#include "sphonic/chart.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "chart_script.hpp"
#include "sphonic/error.hpp"

extern char** environ;

namespace sphonic {

namespace {

namespace fs = std::filesystem;

fs::path with_ending(const fs::path& stem, const std::string& ending) { return stem.string() + ending; }

void check(const Chart& chart) {
    const std::string place = "chart \"" + chart.title + "\"";
    if (chart.panels.empty()) throw Error(Fault::input, place, "it has no panels", "Add a panel");
    if (chart.width < 200 || chart.height < 150)
        throw Error(Fault::input, place,
                    "its size is " + std::to_string(chart.width) + " x " + std::to_string(chart.height) + " pixels",
                    "Use at least 200 x 150");
    for (const Panel& panel : chart.panels) {
        if (panel.raster) charting::check(panel, place);
        for (const Curve& curve : panel.curves) {
            const auto nx = curve.x.size(), ny = curve.y.size(), labels = curve.point_labels.size();
            if (nx != ny)
                throw Error(Fault::input, place + ", curve \"" + curve.label + "\"",
                            std::to_string(nx) + " x for " + std::to_string(ny) + " y", "Give one y per x");
            if (labels != 0 && labels != nx)
                throw Error(Fault::input, place + ", curve \"" + curve.label + "\"",
                            std::to_string(labels) + " labels for " + std::to_string(nx) + " points",
                            "Give one label per point or none");
        }
    }
}

bool gnuplot_installed() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (!folder.empty() && access((fs::path(folder) / "gnuplot").c_str(), X_OK) == 0) return true;
    return false;
}

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text << std::flush;
    if (!out) throw Error(Fault::io, file.string(), "cannot be written", "Check the folder's permissions and space");
}

/// Exit status of gnuplot without the user's settings; what it says goes to `log`.
int run_gnuplot(const fs::path& script, const fs::path& log) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    std::string program = "gnuplot", defaults = "-d", file = script.string();
    char* arguments[] = {program.data(), defaults.data(), file.data(), nullptr};
    pid_t child = 0;
    const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) return failed;
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return status;
}

/// gnuplot's SVG names one font, without which viewers would fall back to serif, and takes its style for its name.
std::string with_fallback_fonts(std::string svg) {
    const std::string sans = "font-family=\"DejaVu Sans, Verdana, sans-serif\"";
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"font-family=\"DejaVu Sans:Bold\"",
                                                                       sans + " font-weight=\"bold\""},
                                   {"font-family=\"DejaVu Sans\"", sans}})
        for (std::size_t at = 0; (at = svg.find(from, at)) != std::string::npos; at += to.size())
            svg.replace(at, from.size(), to);
    return svg;
}

void rename_over(const fs::path& from, const fs::path& to) {
    std::error_code failed;
    fs::rename(from, to, failed);
    if (failed)
        throw Error(Fault::io, to.string(), failed.message(), "Remove what stands there or name another file");
}

}    // namespace

bool draw(const Chart& chart, const fs::path& stem) {
    check(chart);
    const fs::path full = fs::absolute(stem), left = with_ending(full, ".gp");
    std::error_code failed;
    fs::create_directories(full.parent_path(), failed);
    if (!gnuplot_installed()) {
        const fs::path name = stem.filename();
        write(left, charting::script(chart, with_ending(name, ".png"), with_ending(name, ".svg")));
        return false;
    }
    const std::string unique = std::string(".tmp").append(std::to_string(getpid()));
    const fs::path png = with_ending(full, unique + ".png"), svg = with_ending(full, unique + ".svg");
    const fs::path source = with_ending(full, unique + ".gp"), log = with_ending(full, unique + ".log");
    write(source, charting::script(chart, png, svg));
    const int status = run_gnuplot(source, log);
    const std::string said = content(log), picture = content(svg);
    fs::remove(log, failed);
    if (status != 0 || picture.empty() || content(png).empty()) {
        fs::remove(png, failed);
        fs::remove(svg, failed);
        rename_over(source, left);
        throw Error(Fault::io, stem.string(), "gnuplot failed (status " + std::to_string(status) + "): " + said,
                    "Its script is " + left.string() + "; gnuplot needs the terminals pngcairo and svg");
    }
    write(svg, with_fallback_fonts(picture));
    rename_over(png, with_ending(full, ".png"));
    rename_over(svg, with_ending(full, ".svg"));
    fs::remove(source, failed);
    return true;
}

}    // namespace sphonic
