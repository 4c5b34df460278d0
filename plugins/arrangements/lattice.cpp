#include <sphonic/plugin/arrangement.hpp>

/// x = lower + i dx, node-centred, x fastest.
struct Lattice final : abi::Arrangement {
    bool regular() const override { return true; }
    long size(const abi::Box& box) const override { return box.count[0] * box.count[1] * box.count[2]; }
    void place(const abi::Box& box, double* const x[3]) const override {
        long i = 0;
        long site[3];
        for (site[2] = 0; site[2] < box.count[2]; ++site[2])
            for (site[1] = 0; site[1] < box.count[1]; ++site[1])
                for (site[0] = 0; site[0] < box.count[0]; ++site[0], ++i)
                    for (int a = 0; a < box.dimension; ++a) x[a][i] = box.lower[a] + double(site[a]) * box.dx;
    }
};

SPHONIC_ARRANGEMENT("lattice", Lattice, "Square or cubic lattice: x = lower + i dx")
