#pragma once

#include <cmath>

namespace slicefarm {

// Transcendental functions that return the same bits on every machine with IEEE 754 doubles. The
// results of libm differ between machines in the last bit, because glibc selects variants by the
// features of the CPU (FMA, AVX2). These functions consist of + - * / and sqrt, for which IEEE 754
// defines every bit. They are compiled without contraction of a * b + c. Code that makes G-code
// uses these functions instead of libm.
//
//   Errors:  below 2 ulp (Sinh beyond 700: 3); Sin, Cos, Tan and Acos below 1. NaN gives NaN.
//   Source:  the algorithms and coefficients of fdlibm 5.3 (Sun Microsystems, 1993, "Permission to
//            use, copy, modify, and distribute this software is freely granted"): k_sin, k_cos,
//            k_tan, e_rem_pio2 (the medium case), s_atan, e_atan2, e_acos, e_exp, s_log1p.

/// Largest |angle_rad| for which Sin, Cos and Tan are defined. They return NaN for larger angles.
inline constexpr double kMaxAngleRad = 8e5;
double Sin(double angle_rad);
double Cos(double angle_rad);
double Tan(double angle_rad);

/// Returns the angle of the vector (x, y) in radians. Signs of zeros and infinite arguments are
/// treated as in C's atan2.
double Atan2(double y, double x);
double Acos(double cosine);  ///< returns NaN outside [-1, 1]

double Sinh(double x);
double Asinh(double x);
double Log1p(double x);  ///< returns log(1 + x): -infinity at -1, NaN below

/// Returns sqrt(x^2 + y^2). REQUIRES: |x| and |y| in [1e-140, 1e150], or 0, so that the squares
/// neither overflow nor lose bits.
inline double Hypot(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace slicefarm
