#pragma once
#include <cstddef>
#include <vector>

#include <sphonic/plugin/abi/method.hpp>

namespace sphonic {

/// Points where a method keeps a field, their places in it, and room for values there.
struct PointSet {
    int dimension = 1;
    std::vector<std::size_t> at;
    std::vector<double> x[3], value;

    abi::Points points() const {
        abi::Points list{.dimension = dimension, .n = int(at.size())};
        for (int a = 0; a < dimension; ++a) list.x[a] = x[a].data();
        return list;
    }
    /// Those that a source acts on.
    PointSet members(const abi::PlacedSource& placed) const {
        std::vector<unsigned char> inside(at.size());
        placed.inside(placed.host, points(), inside.data());
        return kept(inside);
    }
    /// Those that are marked.
    PointSet kept(const std::vector<unsigned char>& marked) const {
        PointSet kept{.dimension = dimension, .at = {}, .x = {}, .value = {}};
        for (std::size_t i = 0; i < at.size(); ++i) {
            if (!marked[i]) continue;
            kept.at.push_back(at[i]);
            for (int a = 0; a < dimension; ++a) kept.x[a].push_back(x[a][i]);
        }
        kept.value.resize(kept.at.size());
        return kept;
    }
    /// The values replace the field's.
    template <class Field>
    void put(Field& field) const {
        for (std::size_t i = 0; i < at.size(); ++i) field[at[i]] = value[i];
    }
};

}    // namespace sphonic
