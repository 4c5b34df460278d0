#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <sphonic/case.hpp>

#include "tier.hpp"

namespace sphonic {

/// Where the last particles of a set lie along an axis [m]: on a lattice its last sites, else the face of the box.
double end_of_set(const Case& scene, int axis, bool upper);
/// True for a coordinate on that end.
bool on_end(const Case& scene, int axis, bool upper, double x);

/// Virtual particles behind the mirror walls of a set without structure, numbered after the n that they can be images of, its own and
/// those behind obstacles: images of all of them within reach of a wall's plane. Axes in turn, each reflecting the images in those before it too, so that edges and
/// corners are right. Own and virtual particles together are symmetric about every wall, as far as neighbourhoods reach.
///
/// A particle on a wall is its own image. With V the volume of every particle of the symmetric set, wall or not, adjoint forms
/// G and D obey the usual identity, sum_i V [u_i . (G p)_i + p_i (D u)_i] = 0 over that set, for fields of the walls' parity. Every
/// orbit of images gives 2^w equal terms, w the number of walls about, but for a particle on m of them only 2^(w - m): divided by
/// 2^w, this is the sum over own particles with the weight 2^-m. So a wall halves a particle's share of the energy, not its
/// volume as a neighbour. An odd component on the wall has the rate zero by symmetry; setting it to rest takes no energy.
/// A particle that begins on a wall remains its own image while particles move.
class MirrorParticles {
public:
    /// `x` by axis, of the n particles as they begin.
    MirrorParticles(const Case& scene, const Components& components, const double* const* x, long n, int threads);

    /// True if the case has mirror walls.
    bool needed() const { return !walls_.empty(); }
    /// Most virtual particles with this reach [m] of a set that moves: those of one of twice the density.
    long most(double reach) const;
    long count() const { return long(source_.size()); }

    /// Chooses the virtual particles anew.
    void choose(const double* const* x, double reach);
    /// Puts them where their sources' images are: x[a][n] and on.
    void place(double* const* x) const;
    /// Gives them their sources' values of a component, even or odd; an odd one vanishes on the wall.
    void fill(int component, double* field) const;
    /// The same of a component's derivative along an axis, which is of the other parity across that axis' walls.
    void fill_derivative(int component, int axis, double* field) const;

    /// The particle whose image particle j is: j itself, if it is none.
    long source(long j) const { return j < n_ ? j : source_[std::size_t(j - n_)]; }
    /// -1 where image j has axis a reversed.
    double sign(long j, int axis) const { return j < n_ || !(faces_[std::size_t(j - n_)] >> 2 * axis & 3) ? 1 : -1; }

private:
    struct Wall {
        int axis;
        bool upper;
        double plane;                    ///< [m]
        const abi::Boundary* boundary;
        std::vector<std::int32_t> on;    ///< particles

        std::uint8_t bit() const { return std::uint8_t(1 << (2 * axis + upper)); }
        /// Distance into the set [m].
        double depth(double x) const { return upper ? plane - x : x - plane; }
    };
    const Case& scene_;
    const Components& components_;
    long n_;
    int threads_;
    std::vector<Wall> walls_;             ///< by axis
    std::vector<std::uint8_t> on_;        ///< of particles: bits of the walls that they are on
    std::vector<std::int32_t> source_;    ///< of virtual particles
    std::vector<std::uint8_t> faces_;     ///< bits of the walls that they were reflected in
    std::vector<std::array<double, 64>> signs_;    ///< [component][bits]

    void reflect(const Wall& wall, const double* x, double reach, long images_before);
    void find_signs(int components);
    double parity(const Wall& wall, int component) const { return wall.boundary->parity(components_.part(component, wall.axis)); }
};

}    // namespace sphonic
