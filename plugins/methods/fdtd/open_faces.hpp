#pragma once
#include <memory>
#include <vector>

#include "../staggered/media.hpp"

namespace fdtd {

using staggered::End;
using staggered::Field;
using staggered::Grid;
using staggered::Media;

/// Faces whose boundary works out the layer of p beyond them, once per step.
class OpenFaces {
public:
    OpenFaces(const abi::Scene& scene, const Grid& grid, const Media& media) : grid_(grid) {
        for (int a = 0; a < grid.dimension; ++a)
            for (const bool upper : {false, true})
                if (grid.ends[std::size_t(a)][upper] == End::open) faces_.emplace_back(*scene.face[a][upper], grid, media, a, upper);
    }

    bool any() const { return !faces_.empty(); }
    /// t is the time of the values, dt that since the last call; 0 in the first.
    void close(Field& p, double t, double dt) {
        for (Face& face : faces_) face.fill(p, grid_, t, dt);
    }

private:
    static constexpr int layers = 1;

    /// Rows [k][column] and what boundaries take of them.
    struct Rows {
        std::vector<std::vector<double>> values;

        Rows(std::size_t count, std::size_t columns) : values(count, std::vector<double>(columns, 0.0)) {}
        std::vector<double*> from(std::size_t column) {
            std::vector<double*> pointers;
            for (auto& row : values) pointers.push_back(row.data() + column);
            return pointers;
        }
    };

    class Face {
    public:
        Face(const abi::Boundary& boundary, const Grid& grid, const Media& media, int axis, bool upper)
            : boundary_(boundary), step_(upper ? grid.stride[axis] : -grid.stride[axis]), inner_(layers + 2, 0), memory_(layers + 1, 0), ghost_(layers + 1, 0) {
            const long depth = std::min<long>(layers + 1, grid.n[axis] - 1);
            depth_ = depth;
            grid.for_lines(axis, [&](long line) {
                last_.push_back(line + (upper ? (grid.n[axis] - 1) * grid.stride[axis] : 0));
                const abi::Medium& m = media.of(std::size_t(last_.back()));
                if (runs_.empty() || m.c0 != runs_.back().medium.c0 || m.rho0 != runs_.back().medium.rho0) runs_.push_back({last_.size() - 1, 0, m});
                ++runs_.back().n;
            });
            inner_ = Rows(layers + 2, last_.size());
            memory_ = Rows(layers + 1, last_.size());
            ghost_ = Rows(layers + 1, last_.size());
        }

        void fill(Field& p, const Grid& grid, double t, double dt) {
            for (std::size_t i = 0; i < last_.size(); ++i)
                for (long k = 0; k <= layers + 1; ++k) inner_.values[std::size_t(k)][i] = p[std::size_t(last_[i] - std::min(k, depth_) * step_)];
            for (const Run& run : runs_) {
                const auto inner = inner_.from(run.first), memory = memory_.from(run.first), ghost = ghost_.from(run.first);
                boundary_.fill({.part = abi::Part::scalar, .n = int(run.n), .layers = layers, .t = t, .dt = dt, .dx = grid.dx, .medium = run.medium,
                                .inner = inner.data(), .pressure = inner.data(), .memory = memory.data(), .ghost = ghost.data()});
            }
            for (std::size_t i = 0; i < last_.size(); ++i)
                for (long k = 0; k <= layers; ++k) p[std::size_t(last_[i] + k * step_)] = ghost_.values[std::size_t(k)][i];
        }

    private:
        /// Columns of one medium.
        struct Run {
            std::size_t first, n;
            abi::Medium medium;
        };
        const abi::Boundary& boundary_;
        long step_, depth_ = 0;
        std::vector<long> last_;    ///< the face's points
        std::vector<Run> runs_;
        Rows inner_, memory_, ghost_;
    };

    const Grid& grid_;
    std::vector<Face> faces_;
};

}    // namespace fdtd
