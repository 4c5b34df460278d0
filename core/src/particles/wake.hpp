#pragma once
#include <string>
#include <vector>

#include "lattice_tiles.hpp"

namespace sphonic {

/// Decides which tiles of a lattice at rest are stepped. A particle is loud if one of its values, as a difference from rest in its
/// unit, exceeds a threshold times the largest amplitude so far. In a step, sound gets no further than the step reaches, from p
/// to u to p: tiles within that of a loud particle are awake, from then on. All else stands still as it begins, at rest or, in the
/// tails of a pulse, nearly so, up to what quiet particles next to sleeping tiles would have sent there. With q_n the norm of the latter's
/// values after step n and s_n that of what stands still, each step does wrong by no more than q_n + 2 s_n, and no error grows beyond
///   growth sum_n (q_n + 2 s_n),
/// and the threshold is such that this stays below 1e-12 of the largest amplitude. Where only some places are asked for, a tile
/// is dropped when they lie further from it than the steps that are left reach: what it then would do cannot get there.
class Wake {
public:
    /// One component of a field that is watched.
    struct Watched {
        const double* field;
        double rest, unit;
    };
    struct Plan {
        long steps;
        double courant;               ///< distance that the fastest sound travels in a step [dx]
        long first_reach, reach;      ///< of the first step and of others, along an axis [dx]
        double first_radius, radius;  ///< the same as distances [dx]
        double growth;                ///< see above, for the l2 norm of all values
        std::vector<std::ptrdiff_t> sources{};    ///< places in fields that sources act on
        std::vector<char> asked{};                ///< 1 for each particle that is asked for; empty for all
        int threads = 1;
    };

    /// The fields are those before the first step.
    Wake(const abi::Box& box, LatticeTiles& tiles, const Layout& layout, Plan plan, std::vector<Watched> watched);

    /// After every step.
    void look();
    /// To be called within a step before it reaches further than the plan says.
    void wake_all();

    double particle_steps() const { return particle_steps_; }
    /// What sound at the speed c0 takes: particles that it has reached, while it can reach what is asked for.
    double ideal_steps() const { return ideal_steps_; }
    /// Relative to the largest amplitude.
    double error_bound() const;

private:
    LatticeTiles& tiles_;
    Plan plan_;
    std::vector<Watched> watched_;
    std::vector<char> awake_, stepped_;
    std::vector<long> front_, source_tiles_;    ///< awake tiles that have sleeping ones in reach; those with sources
    std::vector<double> asked_distance_;        ///< of each tile [dx]; empty where all is asked for
    std::vector<double> still_;    ///< squares of the values that a tile begins with, for those that sleep then
    double still_squares_ = 0;     ///< of those that sleep
    double threshold_, amplitude_ = 0, quiet_ = 0, particle_steps_ = 0, ideal_steps_ = 0;
    long done_ = 0;

    /// What is heard in a tile: the largest value, and a box around the loud particles.
    struct Heard {
        double most = 0;
        LatticeTiles::Sites loud{};
    };
    Heard hear(long tile, double threshold) const;
    std::vector<Heard> hear(const std::vector<long>& tiles);
    bool wake(long tile);
    bool wake_near(const LatticeTiles::Sites& sites, long reach);
    bool listen(long reach);
    bool surrounded(long tile, long reach) const;
    bool asked(long tile) const;
    void choose();
    void find_distances(const abi::Box& box, const Layout& layout);
};

}    // namespace sphonic
