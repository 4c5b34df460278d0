#pragma once
#include <memory>
#include <stdexcept>
#include <vector>

#include <glpk.h>

namespace sphonic::band {

/// The least largest relative error e of linear conditions, with bounds on others, by GLPK's simplex method.
class Minimax {
public:
    explicit Minimax(int weights) : problem_(glp_create_prob(), glp_delete_prob), weights_(weights) {
        glp_set_obj_dir(problem_.get(), GLP_MIN);
        glp_add_cols(problem_.get(), weights + 1);
        for (int c = 1; c <= weights; ++c) glp_set_col_bnds(problem_.get(), c, GLP_FR, 0, 0);
        glp_set_col_bnds(problem_.get(), weights + 1, GLP_LO, 0, 0);
        glp_set_obj_coef(problem_.get(), weights + 1, 1);
    }
    /// |a . w - 1| <= e
    void approach(const std::vector<double>& a) {
        row(a, -1, GLP_UP, 1);
        row(a, 1, GLP_LO, 1);
    }
    /// a . w <= most
    void bound(const std::vector<double>& a, double most) { row(a, 0, GLP_UP, most); }

    std::vector<double> solve() {
        if (!simplex(GLP_DUALP)) {
            glp_std_basis(problem_.get());
            if (!simplex(GLP_PRIMAL))
                throw std::invalid_argument("no weights fit: choose more points_per_wavelength, a larger support or a smaller step");
        }
        std::vector<double> w;
        for (int c = 1; c <= weights_; ++c) w.push_back(glp_get_col_prim(problem_.get(), c));
        return w;
    }

    /// The largest relative error of the conditions taken up.
    double error() const { return glp_get_col_prim(problem_.get(), weights_ + 1) / error_scale; }

private:
    std::unique_ptr<glp_prob, void (*)(glp_prob*)> problem_;
    int weights_;

    static constexpr double error_scale = 1e4;    ///< errors of 1e-5 are digits, not tolerance

    bool simplex(int method) {
        glp_smcp options;
        glp_init_smcp(&options);
        options.msg_lev = GLP_MSG_OFF;
        options.meth = method;
        options.tol_bnd = options.tol_dj = 1e-9;
        return glp_simplex(problem_.get(), &options) == 0 && glp_get_status(problem_.get()) == GLP_OPT;
    }

    void row(const std::vector<double>& a, double of_error, int kind, double bound) {
        const int r = glp_add_rows(problem_.get(), 1);
        std::vector<int> column(1);
        std::vector<double> value(1);
        for (int c = 0; c < weights_; ++c) {
            column.push_back(c + 1);
            value.push_back(a[std::size_t(c)]);
        }
        column.push_back(weights_ + 1);
        value.push_back(of_error / error_scale);
        glp_set_mat_row(problem_.get(), r, weights_ + 1, column.data(), value.data());
        glp_set_row_bnds(problem_.get(), r, kind, bound, bound);
    }
};

}    // namespace sphonic::band
