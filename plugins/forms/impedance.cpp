#include <sphonic/plugin/form.hpp>

/// The states at the middle of a pair as sound passes between two impedances Z = rho c:
///   p* = (Z_j p_i + Z_i p_j)/(Z_i + Z_j),   u* = (Z_i u_i + Z_j u_j)/(Z_i + Z_j),
/// in 2 (f* - f_i), with the corrected gradient. In one medium it is the corrected form.
struct Impedance {
    static constexpr abi::Correction correction = abi::Correction::own;
    static constexpr double other(PairSide i, PairSide j, abi::Derivative derivative) {
        return 2 * (derivative == abi::Derivative::gradient ? i.impedance : j.impedance) / (i.impedance + j.impedance);
    }
    static constexpr double own(PairSide i, PairSide j, abi::Derivative derivative) { return -other(i, j, derivative); }
};

SPHONIC_FORM("impedance", Impedance, "2 (f* - f_i) with f* between two impedances: stable at any contrast of media")
