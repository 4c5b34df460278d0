#pragma once
/// A folder with a study of a small case, a tone in one dimension.
#include <sphonic/error.hpp>
#include <sphonic/study.hpp>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace sphonic::testing {

struct StudyBench {
    std::filesystem::path folder = std::filesystem::temp_directory_path() / ("sphonic_study_" + std::to_string(getpid())), out = folder / "out";
    Registry registry{Registry::search_path()};

    StudyBench() {
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "tone.json") << R"json({ "dimension": 1, "medium": { "c0": 340, "rho0": 1 },
            "particles": { "type": "lattice", "dx": 0.1, "lower": [-2], "upper": [8], "motion": "frozen" },
            "kernel": { "type": "cubic_spline", "h_over_dx": 1 }, "equations": "linear_acoustics",
            "sources": [ { "type": "plane_wave", "region": "x < 0", "amplitude": 1, "omega": 500, "direction": [1] } ],
            "integrator": { "type": "symplectic_euler", "courant": 0.5 }, "until": 0.01,
            "reference": { "type": "plane_wave_front", "region": "0 <= x <= 8", "scale": 1 } })json";
    }
    StudyBench(const StudyBench&) = delete;
    StudyBench& operator=(const StudyBench&) = delete;
    ~StudyBench() { std::filesystem::remove_all(folder); }

    /// `vary` is the list of dimensions, `more` further members.
    Study study_of(const std::string& vary, const std::string& more) const {
        std::ofstream(folder / "study.json") << R"({ "case": "tone.json", "vary": [ )" << vary << " ], " << more << "}";
        return load_study(folder / "study.json");
    }
    /// A chart as it was drawn, or the script for it where gnuplot is not installed.
    std::string picture(const std::string& name) const {
        const std::filesystem::path drawn = out / (name + ".svg"), script = out / (name + ".gp");
        std::ifstream in(std::filesystem::exists(drawn) ? drawn : script);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

}    // namespace sphonic::testing
