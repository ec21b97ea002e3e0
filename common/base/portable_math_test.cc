#include "common/base/portable_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace slicefarm::portable_math_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = std::numbers::pi;

/// Error of a function compared with the long double functions of libm. With 64 bits of mantissa,
/// their ulp is 1/2048 of the ulp of double.
struct Accuracy {
  std::string name;
  double (*got)(double);
  long double (*want)(long double);
  double low, high;
  double ulps;
};
class Accurate : public testing::TestWithParam<Accuracy> {};

double UlpsApart(double got, long double want) {
  const double size = std::abs(static_cast<double>(want));
  const double ulp = std::nextafter(size, kInfinity) - size;
  return static_cast<double>(std::abs((got - want) / ulp));
}

TEST_P(Accurate, ToSoManyUlps) {
  static_assert(std::numeric_limits<long double>::digits >= 64);
  const Accuracy& c = GetParam();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(c.low, c.high);
  double worst = 0, worst_at = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = any(random);
    const double apart = UlpsApart(c.got(x), c.want(x));
    if (!(apart <= worst)) worst = apart, worst_at = x;
  }
  EXPECT_LE(worst, c.ulps) << std::hexfloat << worst_at;
  EXPECT_GT(worst, 0.4);  // the nearest double is half an ulp off now and then
}

template <int kTenths>
double Atan2Of(double y) {
  return Atan2(y, kTenths / 10.0);
}
template <int kTenths>
long double WantAtan2Of(long double y) {
  return std::atan2(y, static_cast<long double>(kTenths / 10.0));
}
double HypotOf(double x) { return Hypot(x, 1.7); }
long double WantHypotOf(long double x) { return std::hypot(x, 1.7l); }

INSTANTIATE_TEST_SUITE_P(
    PortableMath, Accurate,
    testing::Values(  // name, function, judge, range, ulps; worst of 2,000,000 measured
        Accuracy{"SinSmall", Sin, std::sin, -0.01, 0.01, 0.51},            // 0.5000
        Accuracy{"SinTurn", Sin, std::sin, -7, 7, 0.8},                    // 0.781
        Accuracy{"SinFar", Sin, std::sin, -8e5, 8e5, 0.8},                 // 0.764
        Accuracy{"CosSmall", Cos, std::cos, -0.01, 0.01, 0.51},            // 0.5000
        Accuracy{"CosTurn", Cos, std::cos, -7, 7, 0.8},                    // 0.749
        Accuracy{"CosFar", Cos, std::cos, -8e5, 8e5, 0.8},                 // 0.776
        Accuracy{"TanSmall", Tan, std::tan, -0.01, 0.01, 0.51},            // 0.5005
        Accuracy{"TanTurn", Tan, std::tan, -7, 7, 0.9},                    // 0.808
        Accuracy{"TanFar", Tan, std::tan, -8e5, 8e5, 0.9},                 // 0.847
        Accuracy{"Atan2Steep", Atan2Of<1>, WantAtan2Of<1>, -2, 2, 1.6},    // 1.49
        Accuracy{"Atan2Round", Atan2Of<17>, WantAtan2Of<17>, -5, 5, 1.6},  // 1.45
        Accuracy{"Atan2Back", Atan2Of<-9>, WantAtan2Of<-9>, -5, 5, 1.6},   // 1.25
        Accuracy{"Atan2Flat", Atan2Of<-800>, WantAtan2Of<-800>, -1, 1, 1.6},
        Accuracy{"Acos", Acos, std::acos, -1, 1, 0.9},              // 0.887
        Accuracy{"AcosNearOne", Acos, std::acos, 0.999, 1, 0.51},   // 0.5005
        Accuracy{"AcosNearPi", Acos, std::acos, -1, -0.999, 0.52},  // 0.5156
        Accuracy{"SinhSmall", Sinh, std::sinh, -1, 1, 1.0},         // 0.890
        Accuracy{"Sinh", Sinh, std::sinh, -10, 10, 1.7},            // 1.593
        Accuracy{"SinhBig", Sinh, std::sinh, -700, 700, 1.7},       // 1.565
        Accuracy{"SinhHuge", Sinh, std::sinh, 700, 710, 3.0},       // 2.433
        Accuracy{"AsinhSmall", Asinh, std::asinh, -1, 1, 1.8},      // 1.695
        Accuracy{"Asinh", Asinh, std::asinh, -100, 100, 1.8},       // 1.630
        Accuracy{"AsinhBig", Asinh, std::asinh, 1e8, 1e9, 1.0},
        Accuracy{"AsinhHuge", Asinh, std::asinh, 1e17, 1e300, 1.0},  // 0.984
        Accuracy{"Log1pSmall", Log1p, std::log1p, -0.01, 0.01, 0.51},
        Accuracy{"Log1p", Log1p, std::log1p, -1, 1, 0.9},  // 0.838
        Accuracy{"Log1pBig", Log1p, std::log1p, 1, 1e9, 0.9},
        Accuracy{"Hypot", HypotOf, WantHypotOf, -5, 5, 1.3}),  // 1.21
    [](const auto& info) { return info.param.name; });

TEST(PortableMath, ReducesWhatLiesNearQuarterTurns) {
  for (const double quarter : {1.0, 2.0, 3.0, 355.0, 1e4, 5e5}) {
    double angle = quarter * kPi / 2;
    for (int step = 0; step < 5; ++step, angle = std::nextafter(angle, 0)) {
      EXPECT_LE(UlpsApart(Sin(angle), std::sin(static_cast<long double>(angle))), 1) << angle;
      EXPECT_LE(UlpsApart(Cos(angle), std::cos(static_cast<long double>(angle))), 1) << angle;
      EXPECT_LE(UlpsApart(Tan(angle), std::tan(static_cast<long double>(angle))), 1) << angle;
    }
  }
}

/// Expects equal values, including the sign of zero. All NaNs are equal.
void ExpectSame(double got, double want) {
  EXPECT_TRUE(std::isnan(want) ? std::isnan(got)
                               : std::bit_cast<uint64_t>(got) == std::bit_cast<uint64_t>(want))
      << got << " for " << want;
}

TEST(PortableMath, Edges) {
  ExpectSame(Sin(-0.0), -0.0);
  ExpectSame(Tan(-0.0), -0.0);
  ExpectSame(Cos(0), 1);
  ExpectSame(Cos(kPi), -1);
  for (const auto f : {Sin, Cos, Tan})
    for (const double x : {kInfinity, kNan, 1e6}) ExpectSame(f(x), kNan);
  ExpectSame(Acos(1), 0);
  ExpectSame(Acos(-1), kPi);
  ExpectSame(Acos(0), kPi / 2);
  for (const double x : {1.0000000000000002, -2.0, kNan}) ExpectSame(Acos(x), kNan);
  for (const double x : {0.0, -0.0, kInfinity, -kInfinity, kNan, 1e-300, 1000.0, 1500.0})
    ExpectSame(Sinh(x), std::sinh(x));
  for (const double x : {0.0, -0.0, kInfinity, -kInfinity, kNan, 1e-300})
    ExpectSame(Asinh(x), std::asinh(x));
  for (const double x : {0.0, kInfinity, kNan, -1.0, -2.0, 1e-300})
    ExpectSame(Log1p(x), std::log1p(x));
}

TEST(PortableMath, Atan2HasAllQuadrantsAndCorners) {
  for (const double y : {0.0, -0.0, 1.0, -1.0, 1e-300, 1e300, kInfinity, -kInfinity, kNan})
    for (const double x : {0.0, -0.0, 1.0, -1.0, 1e-300, -1e300, kInfinity, -kInfinity, kNan}) {
      SCOPED_TRACE(testing::Message() << "atan2(" << y << ", " << x << ")");
      ExpectSame(Atan2(y, x), std::atan2(y, x));
    }
}

/// All machines must get the same digest of the bits of many results. If the digest differs, either
/// the functions have changed (then change the number), or the compiler has used a forbidden
/// optimization.
TEST(PortableMath, HasTheBitsOfAllOtherMachines) {
  uint64_t digest = 0xcbf29ce484222325;
  const auto add = [&](double value) {
    digest = (digest ^ std::bit_cast<uint64_t>(value)) * 0x100000001b3;
  };
  std::mt19937_64 random(7);
  for (int i = 0; i < 100'000; ++i) {
    // The random distributions of the library differ between platforms.
    const double unit = static_cast<double>(random() >> 11) * 0x1p-53, wide = (unit - 0.5) * 100;
    for (const auto f : {Sin, Cos, Tan, Sinh, Asinh}) add(f(wide));
    add(Atan2(wide, unit));
    add(Acos(2 * unit - 1));
    add(Log1p(-unit));
    add(Hypot(wide, unit));
  }
  EXPECT_EQ(digest, 14132850261121523543u);
}

}  // namespace
}  // namespace slicefarm::portable_math_test
