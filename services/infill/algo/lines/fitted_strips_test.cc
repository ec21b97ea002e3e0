#include "services/infill/algo/lines/fitted_strips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::fitted_strips_test {
namespace {

constexpr double kPitch = 400'000;

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

struct Strips {
  explicit Strips(const MultiPolygon& region, double angle_rad = 0, double phase_nm = 200'000,
                  double reach_nm = 0, double link_nm = 0)
      : lines(*CutLines(region, {angle_rad, phase_nm, kPitch})),
        fitted(lines, {.linked = std::vector<bool>(lines.crossings.size(), link_nm > 0),
                       .link_nm = link_nm,
                       .reach_nm = reach_nm}) {}

  /// Returns the area of all strips, in mm2.
  double AreaMm2() const {
    double area = 0;
    for (int32_t piece = 0; piece < lines.PieceCount(); ++piece) {
      const std::vector<StripPoint> strip = fitted.From(2 * piece);
      for (size_t i = 1; i < strip.size(); ++i)
        area += Distance(strip[i - 1].at, strip[i].at) *
                (strip[i - 1].strip_nm + strip[i].strip_nm) / 2;
    }
    return area / 1e12;
  }

  ScanLines lines;
  FittedStrips fitted;
};

TEST(FittedStrips, HalfAPitchToEachSideWhereTheEdgeIsSteep) {
  const Strips strips(P("(0 0, 10 0, 11 2, 10 4, 0 4)"));
  for (int32_t place = 0; place < 2 * strips.lines.PieceCount(); ++place) {
    const std::vector<StripPoint> strip = strips.fitted.From(place);
    ASSERT_EQ(strip.size(), 2u);
    const auto at = [&](int32_t p) {
      return strips.lines.PointOf(strips.lines.crossings[strips.lines.order[p]]);
    };
    EXPECT_EQ(strip.front(), (StripPoint{at(place), kPitch}));
    EXPECT_EQ(strip.back(), (StripPoint{at(place ^ 1), kPitch}));
  }
}

// The last line's strip would end 0.2 mm below the edge if the region were 0.3 mm larger. The line
// fills all of this space.
TEST(FittedStrips, TheLastLineFillsUpToAnEdgeAlongIt) {
  const Strips strips(P("(0 0, 10 0, 10 2.15, 0 2.15)"));
  const std::vector<StripPoint> last = strips.fitted.From(2 * (strips.lines.PieceCount() - 1));
  for (const StripPoint& p : last) {
    EXPECT_NEAR(p.strip_nm, 0.55e6, 1);
    EXPECT_EQ(p.at.y, 1'875'000);
  }
  EXPECT_NEAR(strips.AreaMm2(), 21.5, 1e-6);
}

// A slope of 5 degrees without links: a line is wider beside the end of the next line.
TEST(FittedStrips, WiderBesideEnds) {
  const MultiPolygon wedge = P("(0 0, 30 0, 3 2.4)");
  const Strips strips(wedge);
  for (int32_t piece = 0; piece + 1 < strips.lines.PieceCount(); ++piece) {
    double widest = 0;
    for (const StripPoint& p : strips.fitted.From(2 * piece)) {
      widest = std::max(widest, p.strip_nm);
      EXPECT_GE(p.strip_nm, 0.6 * kPitch - 1) << piece;
    }
    EXPECT_GT(widest, 1.2 * kPitch) << piece;
    EXPECT_LT(widest, 1.5 * kPitch + 1) << piece;
  }
  EXPECT_NEAR(strips.AreaMm2() / (Area(wedge) / 1e12), 1, 0.05);
}

TEST(FittedStrips, ReachIsFilledToo) {
  const MultiPolygon region = P("(0 0, 10 0, 10 2, 0 2)");
  const Strips strips(region, 0, 200'000, 45'000);
  const std::vector<StripPoint> last = strips.fitted.From(2 * (strips.lines.PieceCount() - 1));
  EXPECT_NEAR(last.front().strip_nm, kPitch + 45'000, 1);
}

// A link along the edge takes its strip only from the line beside it.
TEST(FittedStrips, LeaveRoomForLinks) {
  constexpr double kLink = 80'000;
  const MultiPolygon wedge = P("(0 0, 30 0, 3 2.4)");
  const Strips free(wedge), linked(wedge, 0, 200'000, 0, kLink);
  double most = 0;
  for (int32_t piece = 0; piece < free.lines.PieceCount(); ++piece) {
    const auto wide = free.fitted.From(2 * piece), narrow = linked.fitted.From(2 * piece);
    ASSERT_EQ(wide.size(), narrow.size()) << piece;
    for (size_t i = 0; i < wide.size(); ++i) {
      const double taken = wide[i].strip_nm - narrow[i].strip_nm;
      EXPECT_GE(taken, -1) << piece;
      most = std::max(most, taken);
    }
  }
  EXPECT_NEAR(most, kLink, 1);
}

// A hole reaches down between two lines. The line below it fills the space under the hole, although
// no end of a line is there.
TEST(FittedStrips, FillBelowAHole) {
  const MultiPolygon holed = P("(0 0, 10 0, 10 4, 0 4) (3 2.1, 7 2.1, 7 3, 3 3)");
  const Strips strips(holed);
  // Line 4, at 1.8 mm, is 0.3 mm below the hole.
  const std::vector<StripPoint> below = strips.fitted.From(2 * 4);
  ASSERT_GT(below.size(), 2u);
  double widest = 0;
  for (const StripPoint& p : below) widest = std::max(widest, p.strip_nm);
  EXPECT_NEAR(widest, kPitch + 100'000, 1);
  EXPECT_EQ(below.front().strip_nm, kPitch);
  EXPECT_EQ(below.back().strip_nm, kPitch);
  EXPECT_EQ(below.front().at.y, 1'800'000);
}

TEST(FittedStrips, BackwardsIsTheSame) {
  const Strips strips(P("(0 0, 30 0, 3 2.4)"), 0.05);
  for (int32_t piece = 0; piece < strips.lines.PieceCount(); ++piece) {
    std::vector<StripPoint> back = strips.fitted.From(2 * piece + 1);
    std::ranges::reverse(back);
    EXPECT_EQ(back, strips.fitted.From(2 * piece));
  }
}

// A rotation of the region with its lines rotates the strips.
TEST(FittedStrips, TurnWithTheLines) {
  const MultiPolygon flat = P("(0 0, 12 0, 12 3, 2 2.1)");
  const MultiPolygon upright = P("(0 0, 0 12, -3 12, -2.1 2)");
  const Strips a(flat), b(upright, std::numbers::pi / 2);
  ASSERT_EQ(a.lines.PieceCount(), b.lines.PieceCount());
  for (int32_t piece = 0; piece < a.lines.PieceCount(); ++piece) {
    const auto p = a.fitted.From(2 * piece), q = b.fitted.From(2 * piece);
    ASSERT_EQ(p.size(), q.size());
    for (size_t i = 0; i < p.size(); ++i) {
      EXPECT_NEAR(static_cast<double>(q[i].at.y), static_cast<double>(p[i].at.x), 2);
      EXPECT_NEAR(static_cast<double>(q[i].at.x), static_cast<double>(-p[i].at.y), 2);
      EXPECT_NEAR(q[i].strip_nm, p[i].strip_nm, 2);
    }
  }
}

}  // namespace
}  // namespace slicefarm::infill::fitted_strips_test
