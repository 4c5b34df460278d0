#include "progress.hpp"

#include <cstdio>

#include <unistd.h>

namespace sphonic::driver {

ProgressBar::ProgressBar(std::string label) : label_(std::move(label)), terminal_(isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(const Progress& p) {
    if (!terminal_ || (p.wall_s - last_ < 0.1 && p.step < p.steps)) return;
    last_ = p.wall_s;
    drawn_ = true;
    constexpr int width = 30;
    const double fraction = double(p.step) / double(p.steps);
    const int filled = int(fraction * width);
    std::string bar(std::size_t(filled), '#');
    bar.resize(width, '.');
    std::fprintf(stderr, "\r\033[K%s [%s] %3.0f %%  %ld/%ld steps  %.1f s left", label_.c_str(), bar.c_str(), 100 * fraction, p.step,
                 p.steps, p.wall_s * (1 - fraction) / fraction);
    std::fflush(stderr);
}

}    // namespace sphonic::driver
