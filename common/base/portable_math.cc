#include "common/base/portable_math.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

namespace slicefarm {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Constant that rounds a small double to a whole number when it is added and subtracted. Ties
/// round to even.
constexpr double kToWhole = 0x1.8p52;

/// Returns c[0] + c[1] x + c[2] x^2 ...
template <size_t kCount>
double Polynomial(const std::array<double, kCount>& c, double x) {
  double sum = c.back();
  for (size_t i = kCount - 1; i > 0; --i) sum = c[i - 1] + x * sum;
  return sum;
}

/// Returns the value with its lower half of bits set to 0. The product of the result with itself,
/// or with an integer of 21 bits, is exact.
double UpperHalf(double x) {
  return std::bit_cast<double>(std::bit_cast<uint64_t>(x) & 0xffffffff00000000);
}

/// Returns 2^power. REQUIRES: the result is a normal number.
double PowerOfTwo(int power) {
  return std::bit_cast<double>(static_cast<uint64_t>(power + 1023) << 52);
}

// --- sine, cosine, tangent ---------------------------------------------------------------------

/// Reduced angle: angle = quarters * pi / 2 + rest + low. |rest| is at most slightly above pi / 4,
/// and |low| is below the ulp of rest.
struct Reduced {
  int64_t quarters = 0;
  double rest = 0;
  double low = 0;
};

/// Reduces an angle by the method of Cody and Waite: pi / 2 is split into pieces of 33 bits, so
/// that the products with `quarters` are exact.
Reduced ByQuarterTurns(double angle) {
  constexpr double kTwoOverPi = 6.36619772367581382433e-01;
  constexpr std::array kPiece = {1.57079632673412561417e+00, 6.07710050630396597660e-11,
                                 2.02226624871116645580e-21};
  constexpr std::array kTail = {6.07710050650619224932e-11, 2.02226624879595063154e-21,
                                8.47842766036889956997e-32};  // pi / 2 less the pieces so far
  // Ratios of rest to angle. Below ratio i, piece i + 1 of pi / 2 is needed.
  constexpr std::array kEnough = {0x1p-16, 0x1p-49, 0.0};
  if (std::abs(angle) <= std::numbers::pi / 4) return {0, angle, 0};
  const double quarters = (angle * kTwoOverPi + kToWhole) - kToWhole;
  double left = angle - quarters * kPiece[0];
  double tail = quarters * kTail[0];
  for (size_t i = 1; i < kPiece.size(); ++i) {
    if (std::abs(left - tail) >= kEnough[i - 1] * std::abs(angle)) break;
    const double before = left, piece = quarters * kPiece[i];
    left = before - piece;
    tail = quarters * kTail[i] - ((before - left) - piece);
  }
  const double rest = left - tail;
  return {static_cast<int64_t>(quarters), rest, (left - rest) - tail};
}

double SinOfRest(const Reduced& angle) {
  constexpr std::array kS = {8.33333333332248946124e-03, -1.98412698298579493134e-04,
                             2.75573137070700676789e-06, -2.50507602534068634195e-08,
                             1.58969099521155010221e-10};
  constexpr double kCube = -1.66666666666666324348e-01;
  const double x = angle.rest, square = x * x, cube = square * x;
  const double r = Polynomial(kS, square);
  return x - ((square * (0.5 * angle.low - cube * r) - angle.low) - cube * kCube);
}

double CosOfRest(const Reduced& angle) {
  constexpr std::array kC = {4.16666666666666019037e-02, -1.38888888888741095749e-03,
                             2.48015872894767294178e-05, -2.75573143513906633035e-07,
                             2.08757232129817482790e-09, -1.13596475577881948265e-11};
  const double square = angle.rest * angle.rest, half = 0.5 * square, most = 1 - half;
  const double r = square * Polynomial(kC, square);
  return most + (((1 - most) - half) + (square * r - angle.rest * angle.low));
}

/// Returns tan, or -1 / tan for `inverse`.
double TanOfRest(const Reduced& angle, bool inverse) {
  constexpr std::array kOdd = {1.33333333333201242699e-01, 2.18694882948595424599e-02,
                               3.59207910759131235356e-03, 5.88041240820264096874e-04,
                               7.81794442939557092300e-05, -1.85586374855275456654e-05};
  constexpr std::array kEven = {5.39682539762260521377e-02, 8.86323982359930005737e-03,
                                1.45620945432529025516e-03, 2.46463134818469906812e-04,
                                7.14072491382608190305e-05, 2.59073051863633712884e-05};
  constexpr double kThird = 3.33333333333334091986e-01;
  constexpr double kQuarterPi = 7.85398163397448278999e-01,
                   kQuarterPiLow = 3.06161699786838301793e-17;
  double x = angle.rest, low = angle.low;
  const bool near_one = std::abs(x) >= 0.6744;  // tan x = (1 - tan z) / (1 + tan z), z = pi / 4 - x
  const double sign = x < 0 ? -1 : 1;
  if (near_one) {
    x = (kQuarterPi - sign * x) + (kQuarterPiLow - sign * low);
    low = 0;
  }
  const double square = x * x, fourth = square * square, cube = square * x;
  const double sum = Polynomial(kOdd, fourth) + square * Polynomial(kEven, fourth);
  const double rest = low + square * (cube * sum + low) + kThird * cube;
  const double tangent = x + rest;
  if (near_one) {
    const double one = inverse ? -1 : 1;
    return sign * (one - 2 * (x - (tangent * tangent / (tangent + one) - rest)));
  }
  if (!inverse) return tangent;
  // Computes -1 / (x + rest) and corrects the error of the division.
  const double upper = UpperHalf(tangent), lower = rest - (upper - x);
  const double quotient = -1 / tangent, rough = UpperHalf(quotient);
  return rough + quotient * ((1 + rough * upper) + rough * lower);
}

/// Returns the sine of the angle plus `turned` quarter turns: 0 gives the sine, 1 the cosine.
double Wave(double angle_rad, int64_t turned) {
  if (!(std::abs(angle_rad) <= kMaxAngleRad)) return kNan;
  const Reduced angle = ByQuarterTurns(angle_rad);
  const int64_t quarters = (angle.quarters + turned) & 3;
  const double value = quarters % 2 == 0 ? SinOfRest(angle) : CosOfRest(angle);
  return quarters < 2 ? value : -value;
}

// --- arcs --------------------------------------------------------------------------------------

/// Returns the arc tangent of a ratio >= 0.
double AtanOfRatio(double ratio) {
  constexpr std::array kOdd = {3.33333333333329318027e-01, 1.42857142725034663711e-01,
                               9.09088713343650656196e-02, 6.66107313738753120669e-02,
                               4.97687799461593236017e-02, 1.62858201153657823623e-02};
  constexpr std::array kEven = {-1.99999999998764832476e-01, -1.11111104054623557880e-01,
                                -7.69187620504482999495e-02, -5.83357013379057348645e-02,
                                -3.65315727442169155270e-02};
  struct Base {
    double arc, low;  ///< atan(base) = arc + low
  };
  constexpr std::array<Base, 5> kBases = {
      {{0, 0},
       {4.63647609000806093515e-01, 2.26987774529616870924e-17},
       {7.85398163397448278999e-01, 3.06161699786838301793e-17},
       {9.82793723247329054082e-01, 1.39033110312309984516e-17},
       {1.57079632679489655800e+00, 6.12323399573676603587e-17}}};
  size_t base = 0;
  double x = ratio;
  if (ratio >= 2.4375) {
    base = 4, x = -1 / ratio;
  } else if (ratio >= 1.1875) {
    base = 3, x = (ratio - 1.5) / (1 + 1.5 * ratio);
  } else if (ratio >= 0.6875) {
    base = 2, x = (ratio - 1) / (ratio + 1);
  } else if (ratio >= 0.4375) {
    base = 1, x = (2 * ratio - 1) / (2 + ratio);
  }
  const double square = x * x, fourth = square * square;
  const double sum = square * Polynomial(kOdd, fourth) + fourth * Polynomial(kEven, fourth);
  return kBases[base].arc - ((x * sum - kBases[base].low) - x);
}

/// Returns (asin(x) - x) / x, where `square` is x^2 <= 1/4.
double ArcExcess(double square) {
  constexpr std::array kP = {1.66666666666666657415e-01, -3.25565818622400915405e-01,
                             2.01212532134862925881e-01, -4.00555345006794114027e-02,
                             7.91534994289814532176e-04, 3.47933107596021167570e-05};
  constexpr std::array kQ = {1.0, -2.40339491173441421878e+00, 2.02094576023350569471e+00,
                             -6.88283971605453293030e-01, 7.70381505559019352791e-02};
  return square * Polynomial(kP, square) / Polynomial(kQ, square);
}

constexpr double kPi = std::numbers::pi, kHalfPi = kPi / 2;
constexpr double kHalfPiLow = 6.12323399573676603587e-17;

// --- exponential -------------------------------------------------------------------------------

constexpr double kLn2 = 6.93147180369123816490e-01, kLn2Low = 1.90821492927058770002e-10;

/// Returns e^x. REQUIRES: 0 <= x < 709.
double Exp(double x) {
  constexpr std::array kP = {1.66666666666666019037e-01, -2.77777777770155933842e-03,
                             6.61375632143793436117e-05, -1.65339022054652515390e-06,
                             4.13813679705723846039e-08};
  const double power = (x * std::numbers::log2e + kToWhole) - kToWhole;
  const double high = x - power * kLn2, low = power * kLn2Low, rest = high - low;
  const double square = rest * rest, c = rest - square * Polynomial(kP, square);
  const double value = 1 - ((low - rest * c / (2 - c)) - high);
  return value * PowerOfTwo(static_cast<int>(power));
}

/// Returns sinh x for |x| <= 1 by its series: x + x^3 / 3! + ... x^21 / 21!
double SinhSeries(double x) {
  const double square = x * x;
  double sum = 0;
  for (int k = 20; k >= 2; k -= 2) sum = square / (k * (k + 1)) * (1 + sum);
  return x + x * sum;
}

}  // namespace

double Sin(double angle_rad) { return angle_rad == 0 ? angle_rad : Wave(angle_rad, 0); }

double Cos(double angle_rad) { return Wave(angle_rad, 1); }

double Tan(double angle_rad) {
  if (angle_rad == 0) return angle_rad;
  if (!(std::abs(angle_rad) <= kMaxAngleRad)) return kNan;
  const Reduced angle = ByQuarterTurns(angle_rad);
  return TanOfRest(angle, angle.quarters % 2 != 0);
}

double Atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNan;
  if (y == 0) return std::copysign(std::signbit(x) ? kPi : 0.0, y);
  if (x == 0) return std::copysign(kHalfPi, y);
  const double height = std::abs(y), width = std::abs(x);
  if (height / width >= 0x1p64) return std::copysign(kHalfPi, y);
  double arc = std::isinf(x) && std::isinf(y) ? kHalfPi / 2 : AtanOfRatio(height / width);
  if (x < 0) arc = kPi - (arc - 2 * kHalfPiLow);
  return std::copysign(arc, y);
}

double Acos(double cosine) {
  if (!(std::abs(cosine) <= 1)) return kNan;
  if (std::abs(cosine) < 0.5) {
    return kHalfPi - (cosine - (kHalfPiLow - cosine * ArcExcess(cosine * cosine)));
  }
  // acos x = 2 asin(sqrt((1 - x) / 2)); for x < 0 the result is pi minus the value for -x.
  const double square = (1 - std::abs(cosine)) * 0.5, root = std::sqrt(square);
  if (cosine < 0) return kPi - 2 * (root + (ArcExcess(square) * root - kHalfPiLow));
  if (square == 0) return 0;
  const double upper = UpperHalf(root), lower = (square - upper * upper) / (root + upper);
  return 2 * (upper + (ArcExcess(square) * root + lower));
}

double Sinh(double x) {
  const double size = std::abs(x);
  if (std::isnan(x) || size <= 1) return SinhSeries(x);
  if (size >= 1418) return std::copysign(kInfinity, x);
  if (size >= 700) {
    const double root = Exp(size / 2);
    return std::copysign(root * 0.5 * root, x);
  }
  const double power = Exp(size);
  return std::copysign((power - 1 / power) * 0.5, x);
}

double Asinh(double x) {
  const double size = std::abs(x);
  if (!(size < 0x1p60)) {
    return std::isinf(x) || std::isnan(x) ? x : std::copysign(Log1p(size) + (kLn2 + kLn2Low), x);
  }
  const double square = size * size;
  return std::copysign(Log1p(size + square / (1 + std::sqrt(1 + square))), x);
}

double Log1p(double x) {
  constexpr std::array kL = {6.666666666666735130e-01, 3.999999999940941908e-01,
                             2.857142874366239149e-01, 2.222219843214978396e-01,
                             1.818357216161805012e-01, 1.531383769920937332e-01,
                             1.479819860511658591e-01};
  if (!(x > -1)) return x == -1 ? -kInfinity : kNan;
  if (std::isinf(x) || std::abs(x) < 0x1p-53) return x;
  // 1 + x = 2^power (1 + f) + lost, with 1 + f in [sqrt(1/2), sqrt(2)).
  double f = x, power = 0, correction = 0;
  if (x < std::numbers::sqrt2 / 2 - 1 || x >= std::numbers::sqrt2 - 1) {
    const double sum = 1 + x;
    const double lost = x >= 1 ? 1 - (sum - x) : x - (sum - 1);
    const auto bits = std::bit_cast<uint64_t>(sum);
    power = static_cast<double>(bits >> 52) - 1023;
    double mantissa = std::bit_cast<double>((bits & 0xfffffffffffff) | 0x3ff0000000000000);
    if (mantissa >= std::numbers::sqrt2) mantissa *= 0.5, power += 1;
    f = mantissa - 1;
    correction = lost / sum;
  }
  const double half_square = 0.5 * f * f, s = f / (2 + f), z = s * s;
  const double sum = half_square + z * Polynomial(kL, z);
  return (((s * sum + (power * kLn2Low + correction)) - half_square) + f) + power * kLn2;
}

}  // namespace slicefarm
