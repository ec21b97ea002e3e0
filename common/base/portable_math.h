#pragma once

#include <cmath>

namespace slicefarm {

/// Transcendental functions whose bits are the same on every machine with IEEE 754 doubles. libm's
/// are not: glibc picks variants by what the CPU offers (FMA, AVX2), and they differ in the last
/// bit. These are made of + - * / and sqrt, which IEEE 754 defines to the bit, and are compiled
/// without contraction of a * b + c. What makes G-code uses these and not libm's.
///
/// Errors:  below 2 ulp (Sinh beyond 700: 3); Sin, Cos, Tan and Acos below 1. NaN gives NaN.
/// Source:  the algorithms and coefficients of fdlibm 5.3 (Sun Microsystems, 1993, "Permission to
///          use, copy, modify, and distribute this software is freely granted"): k_sin, k_cos,
///          k_tan, e_rem_pio2 (the medium case), s_atan, e_atan2, e_acos, e_exp, s_log1p.

/// REQUIRES of Sin, Cos and Tan: |angle_rad| <= kMaxAngleRad. NaN beyond.
inline constexpr double kMaxAngleRad = 8e5;
double Sin(double angle_rad);
double Cos(double angle_rad);
double Tan(double angle_rad);

/// Signs of zeros and the four infinite corners as in C's atan2.
double Atan2(double y, double x);
double Acos(double cosine);  ///< NaN outside [-1, 1]

double Sinh(double x);
double Asinh(double x);
double Log1p(double x);  ///< log(1 + x); -infinity at -1, NaN below

/// REQUIRES: |x| and |y| in [1e-140, 1e150], or 0: the squares neither overflow nor lose bits.
inline double Hypot(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace slicefarm
