#include <sphonic/json.hpp>
#include <sphonic/simulation.hpp>
#include <sphonic/version.hpp>

namespace sphonic {

Json to_json(const Summary& s) {
    Json errors = nullptr;
    if (s.errors)
        errors = {{"eps", s.errors->eps}, {"rms", s.errors->rms}, {"l2", s.errors->l2}, {"max", s.errors->max},
                  {"n", s.errors->n}, {"scale", s.errors->scale}};
    const double nominal = double(s.particles) * double(s.steps), ideal = s.ideal_particle_steps;
    const Json active{{"share", nominal > 0 ? s.particle_steps / nominal : 1}, {"ideal_share", ideal >= 0 ? ideal / nominal : 1},
                      {"error_bound", s.asleep_error}, {"all_because", s.all_because}};
    const double per_step = s.particle_steps > 0 ? 1e9 * s.wall_s / s.particle_steps : 0;
    return {{"title", s.title}, {"method", s.method}, {"integrator", s.integrator}, {"steps", s.steps}, {"dt", s.dt},
            {"dt_limit", s.dt_limit}, {"weakly_unstable", s.weak}, {"dt_mild", s.dt_mild}, {"growth_exponent", s.growth}, {"growth_rate", s.growth_rate}, {"particles", s.particles}, {"neighbours_mean", s.neighbours_mean}, {"tier", s.tier},
            {"threads", s.threads}, {"wall_s", s.wall_s}, {"cpu_s", s.cpu_s}, {"setup_s", s.setup_s},
            {"ns_per_particle_step", per_step}, {"particle_steps", s.particle_steps},
            {"nominal_particle_steps", nominal}, {"active", active}, {"memory_bytes", s.memory_bytes},
            {"t", s.t}, {"last_good_t", s.last_good_t}, {"errors", errors}, {"energy", {{"initial", s.energy_initial}, {"final", s.energy_final}}},
            {"diverged", s.diverged}, {"diverged_how", s.diverged_how}, {"warnings", s.warnings}, {"git", commit()},
            {"version", version()}};
}

}    // namespace sphonic
