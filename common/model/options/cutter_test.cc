#include "common/model/options/cutter.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "common/base/error.h"
#include "common/model/options/sample_cutters_test.h"

namespace slicefarm::cutter_test {
namespace {

struct WidthCase {
  const char* cutter;
  double height;
  double width;
};

TEST(Cutter, IsAsWideAsItsKindSays) {
  const double root = std::sqrt(0.5);
  for (const WidthCase& c : {
           WidthCase{"cyl:6", 0, 3},
           WidthCase{"cyl:6", 9, 3},
           WidthCase{"ball:4", 0, 0},
           WidthCase{"ball:4", 2 - 2 * root, 2 * root},
           WidthCase{"ball:4", 2, 2},
           WidthCase{"ball:4", 7, 2},
           WidthCase{"bull:4:0.5", 0, 1.5},
           WidthCase{"bull:4:0.5", 0.5 - 0.5 * root, 1.5 + 0.5 * root},
           WidthCase{"bull:4:0.5", 1, 2},
           WidthCase{"cone:4:45", 1, 1},
           WidthCase{"cone:4:45", 3, 2},
           // A ball of radius 1 up to 45 degrees, then a cone.
           WidthCase{"ballcone:2:45:4", 1 - root, root},
           WidthCase{"ballcone:2:45:4", 1 - root + 0.5, root + 0.5},
           WidthCase{"ballcone:2:45:4", 9, 2},
           WidthCase{"bullcone:2:0.5:45:4", 0, 0.5},
           WidthCase{"bullcone:2:0.5:45:4", 0.5 - 0.5 * root + 0.25, 0.5 + 0.5 * root + 0.25},
           WidthCase{"conecone:2:60:45:4", 1 / std::sqrt(3) + 0.5, 1.5},
       }) {
    EXPECT_NEAR(CutterOf(c.cutter).Width(c.height), c.width, 1e-12) << c.cutter << " " << c.height;
  }
}

TEST(Cutter, IsConvexAndHeightAtTurnsWidthRound) {
  for (const std::string_view text : kAllCutters) {
    const Cutter cutter = CutterOf(text);
    double before = cutter.Width(0), growth = std::numeric_limits<double>::infinity();
    for (int i = 1; i <= 1000; ++i) {
      const double height = 0.012 * i, width = cutter.Width(height);
      EXPECT_GE(width, before) << text;
      EXPECT_LE(width - before, growth + 1e-12) << text;
      growth = width - before;
      before = width;
    }
    for (int i = 0; i <= 100; ++i) {
      const double distance = cutter.radius_mm() * i / 100;
      const double height = cutter.HeightAt(distance);
      EXPECT_GE(cutter.Width(height), distance - 1e-12) << text;
      EXPECT_LE(cutter.Width(std::max(0.0, height - 1e-6)), std::max(distance, cutter.Width(0)))
          << text;
    }
    EXPECT_DOUBLE_EQ(cutter.Width(cutter.full_height_mm() + 1), cutter.radius_mm());
  }
}

/// The plane touches the cutter at the point of the cutter that is nearest to the plane.
TEST(Cutter, TouchesAPlaneWhereItIsNearest) {
  for (const std::string_view text : kAllCutters) {
    const Cutter cutter = CutterOf(text);
    for (const double rise : {0.05, 0.3, 0.7, 1.0, 1.5, 4.0, 50.0}) {
      const auto gap = [&](double height) { return height - rise * cutter.Width(height); };
      const double touch = gap(cutter.TouchHeight(rise, 1));
      for (int i = 0; i <= 2000; ++i) EXPECT_LE(touch, gap(0.006 * i) + 1e-12) << text << rise;
    }
  }
}

/// Parsing a cutter's name gives the same cutter.
TEST(Cutter, IsNamedAsItIsRead) {
  for (const std::string_view text : kAllCutters) {
    EXPECT_EQ(CutterOf(text).name(), text);
    EXPECT_EQ(CutterOf(CutterOf(text).name()), CutterOf(text)) << text;
  }
  EXPECT_EQ(CutterOf("bull:6.0:1.50").name(), "bull:6:1.5");
  EXPECT_EQ(Cutter(), CutterOf("ball:4"));
}

TEST(Cutter, RefusesWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& cutter :
       {Cutter::Cylinder(0), Cutter::Cylinder(-1), Cutter::Cylinder(nan), Cutter::Ball(1e9),
        Cutter::Bull(4, 2.1), Cutter::Bull(4, 0), Cutter::Cone(4, 90), Cutter::Cone(4, nan),
        Cutter::BallCone(4, 20, 4), Cutter::BullCone(2, 1.5, 20, 4), Cutter::ConeCone(2, 20, 60, 4),
        Cutter::ConeCone(5, 60, 20, 4)}) {
    ASSERT_FALSE(cutter.ok());
    EXPECT_EQ(DetailOf(cutter.status()).reason, Reason::kSettingOutOfRange);
  }
}

/// The surface of a grown cutter has the distance `by_mm` from the cutter. For a negative `by_mm`
/// the cutter's surface has that distance from the reduced cutter.
TEST(Cutter, GrowsEvenly) {
  for (const std::string_view text : kAllCutters) {
    const Cutter cutter = CutterOf(text);
    for (const double by : {0.3, 0.05, -0.04}) {
      const GrownCutter grown = cutter.Grown(by);
      const Cutter& outer = by > 0 ? grown.cutter : cutter;
      const Cutter& inner = by > 0 ? cutter : grown.cutter;
      const double lift = by > 0 ? -grown.tip_mm : grown.tip_mm;  // of the inner one's tip
      EXPECT_NEAR(grown.cutter.radius_mm(), cutter.radius_mm() + by, 1e-12) << text;
      double mitre = 0;
      for (double h = 0.013; h < cutter.full_height_mm() + 2; h += 0.0371) {
        const Eigen::Vector2d p(outer.Width(h), h);
        double least = 1e9;  // to the inner outline, whose bottom is flat up to its width
        least =
            std::min(least, (p - Eigen::Vector2d(std::min(p.x(), inner.Width(0)), lift)).norm());
        for (double g = 0; g < inner.full_height_mm() + 3; g += 0.0007)
          least = std::min(least, (p - Eigen::Vector2d(inner.Width(g), g + lift)).norm());
        EXPECT_GT(least, std::abs(by) - 1e-3) << text << by << " at " << h;
        mitre = std::max(mitre, least - std::abs(by));
      }
      if (by > 0) {
        EXPECT_LT(mitre, 0.5 * by) << text << by;
      }
    }
  }
}

}  // namespace
}  // namespace slicefarm::cutter_test
