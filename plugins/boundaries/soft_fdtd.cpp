#include <sphonic/plugin/boundary.hpp>

/// p = 0 as in Zhang, Li and Zhang (2017): p by odd mirror images, the velocity of the virtual particles by central differences of
/// the momentum equation,
///   u_{N+k} += -dt / (2 rho0 dx) (p_{N+k+1} - p_{N+k-1})   across the face;   along it, odd images.
/// On the face's particles.
struct SoftFdtd final : abi::Boundary {
    abi::Closure closure() const override { return abi::Closure::layers; }
    bool pressure_suffices() const override { return true; }

    void fill(const abi::GhostLayers& g) const override {
        if (g.part == abi::Part::normal)
            accelerate(g);
        else
            mirror(g);
    }

private:
    static void mirror(const abi::GhostLayers& g) {
        std::fill_n(g.ghost[0], g.n, 0.0);
        for (int k = 1; k <= g.layers; ++k)
            for (int i = 0; i < g.n; ++i) g.ghost[k][i] = -g.inner[k][i];
    }
    /// u across the face counts as positive outwards; p is odd, so p_{N+k} = -p_{N-k} with p_N = 0.
    static void accelerate(const abi::GhostLayers& g) {
        const double kick = -g.dt / (2 * g.medium.rho0 * g.dx);
        std::copy_n(g.inner[0], g.n, g.ghost[0]);
        for (int k = 1; k <= g.layers; ++k)
            for (int i = 0; i < g.n; ++i) {
                const double nearer = k == 1 ? 0 : g.pressure[k - 1][i];
                g.ghost[k][i] = g.dt > 0 ? g.memory[k][i] + kick * (nearer - g.pressure[k + 1][i]) : g.inner[k][i];
            }
        for (int k = 1; k <= g.layers; ++k) std::copy_n(g.ghost[k], g.n, g.memory[k]);
    }
};

SPHONIC_BOUNDARY("soft_fdtd", SoftFdtd, "A pressure-release surface with the virtual particles' velocity by finite differences")
