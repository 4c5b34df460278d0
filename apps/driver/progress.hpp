#pragma once
#include <string>

#include <sphonic/simulation.hpp>

namespace sphonic::driver {

/// A bar with the time left, redrawn in place on a terminal and silent elsewhere.
class ProgressBar {
public:
    explicit ProgressBar(std::string label);
    ~ProgressBar();
    void show(const Progress& progress);

private:
    std::string label_;
    bool terminal_;
    bool drawn_ = false;
    double last_ = -1;
};

}    // namespace sphonic::driver
