#include "source_members.hpp"

#include "parallel.hpp"

namespace sphonic {

SourceMembers::SourceMembers(const SourceUse& use, const Case& scene, const ParticleMedia& media, const Layout& layout, const double* const* x)
    : action(use.source->action()), source_(*use.source), dimension_(scene.box.dimension) {
    const auto index = field_indices(layout);
    abi::Points all{.dimension = dimension_, .n = int(index.size())};
    std::copy_n(x, dimension_, all.x);
    std::vector<unsigned char> inside(index.size());
    use.inside(all, inside.data());
    for (std::size_t i = 0; i < index.size(); ++i) {
        if (!inside[i]) continue;
        at_.push_back(index[i]);
        media_.push_back(media.number(long(i)));
        for (int a = 0; a < dimension_; ++a) x_[a].push_back(x[a][i]);
    }
    if (at_.empty()) use.reaches_nothing();
    p_.resize(at_.size());
    abi::Points members{.dimension = dimension_, .n = int(at_.size())};
    for (int a = 0; a < dimension_; ++a) {
        u_[a].resize(at_.size());
        members.x[a] = x_[a].data();
    }
    use.source->enlist(members, scene.particle_volume());
}

void SourceMembers::follow(const double* const* x, int threads) {
    in_blocks(threads, long(at_.size()), [&](long begin, long end) {
        for (int a = 0; a < dimension_; ++a)
            for (long i = begin; i < end; ++i) x_[a][std::size_t(i)] = x[a][at_[std::size_t(i)]];
    });
}

void SourceMembers::evaluate(double t, bool pressure, bool velocity, int threads) {
    in_blocks(threads, long(at_.size()), [&](long begin, long end) {
        abi::Points points{.dimension = dimension_, .n = int(end - begin)};
        abi::AcousticField out{.p = pressure ? p_.data() + begin : nullptr};
        for (int a = 0; a < dimension_; ++a) {
            points.x[a] = x_[a].data() + begin;
            out.u[a] = velocity ? u_[a].data() + begin : nullptr;
        }
        source_.evaluate(t, points, out);
    });
}

}    // namespace sphonic
