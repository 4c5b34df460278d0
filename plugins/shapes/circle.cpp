#include <sphonic/plugin/shape.hpp>

#include <stdexcept>

/// |x - centre| = radius: a circle in two dimensions, a sphere in three.
struct Circle final : abi::Shape {
    Vector centre;
    double radius = 0;

    static constexpr auto parameters() {
        return std::array{vector("centre", &Circle::centre, "m", -infinite, infinite, "one component per dimension; the origin if not given"),
                          real("radius", &Circle::radius, "m", positive, infinite, "ten spacings and more make a smooth wall")};
    }

    void prepare(const abi::ShapeScene& scene) override {
        if (scene.box.dimension == 1) throw std::invalid_argument("a circle needs two or three dimensions: in one, close the box by boundaries");
        if (centre.size != 0 && centre.size != scene.box.dimension) throw std::invalid_argument("centre needs one component per dimension");
    }

    void measure(const abi::Points& points, double* distance, double* const normal[3]) const override {
        for (int i = 0; i < points.n; ++i) {
            double r[3] = {}, r2 = 0;
            for (int a = 0; a < points.dimension; ++a) {
                r[a] = points.x[a][i] - centre.v[a];
                r2 += r[a] * r[a];
            }
            const double length = std::sqrt(r2);
            distance[i] = length - radius;
            for (int a = 0; a < points.dimension; ++a) normal[a][i] = length > 0 ? r[a] / length : a == 0;
        }
    }
};

SPHONIC_SHAPE("circle", Circle, "A circle; in three dimensions a sphere")
