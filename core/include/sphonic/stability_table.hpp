#pragma once
#include <optional>
#include <string>
#include <vector>

#include <sphonic/stability_report.hpp>

namespace sphonic {

/// Predicted beside measured limits of small sets of c0 dt/dx, by groups:
///   lattice    periodic boxes over their own wave vectors: every kernel found, at h/dx = 1, 1.3, 2 and 3.25, with every integrator that
///              has a limit, in every dimension, up to 500 neighbours;
///   viscosity  the same in 1-D and 2-D with leapfrog and Monaghan's viscosity, by theory at half strength;
///   disorder   displaced particles in 2-D, with adjoint forms and with dissipation;
///   walls      faces that mirror, that end, and that remember, by the map of a whole step.
class LimitTable {
public:
    struct Row {
        std::string group, set, kernel, integrator;
        int dimension, side;        ///< particles a side
        double h_over_dx;
        double allowed;             ///< of |measured/predicted - 1|
        /// c0 dt/dx; of viscous sets also what bounds it.
        double predicted = 0, measured = 0;
        std::optional<double> inviscid{}, always_on{};

        double deviation() const { return measured / predicted - 1; }
        bool holds() const;    ///< within what is allowed, and between the bounds
    };
    struct Worst {
        std::string group;
        int rows;
        double deviation, allowed;    ///< the largest |deviation|
    };

    /// Lists the rows; nothing is measured yet.
    explicit LimitTable(Registry& registry);

    const std::vector<Row>& rows() const { return rows_; }
    /// Measures row i. `report` may throw to end it.
    const Row& find(std::size_t i, const StabilityTrial::Report& report = {});
    /// Of rows that were measured.
    std::vector<Worst> worst() const;
    std::string csv() const;
    Json json() const;

private:
    Registry& registry_;
    std::vector<Row> rows_;
    std::vector<std::string> documents_;

    void add(Row row, const std::string& forms, const std::string& face, const Json& more);
    void list_lattices();
    void list_viscosity();
    void list_disorder();
    void list_walls();
};

/// Such as "1-D h/dx 1.3 cubic_spline rk4, lattice".
std::string name_of(const LimitTable::Row& row);

}    // namespace sphonic
