#include "services/motion/algo/toolpath/scarf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "common/geometry/measure.h"
#include "common/model/paths_test.h"

namespace slicefarm::motion::scarf_test {
namespace {

/// Returns a loop of 100 mm that starts in the middle of an edge.
Path Loop(std::string_view points = "(15 0, 30 0, 30 20, 0 20, 0 0)") {
  Path path = MakePathOrDie(points, true);
  path.feature = Feature::kExternalPerimeter;
  return path;
}

ScarfOptions Everywhere() {
  ScarfOptions options;
  options.placement = ScarfPlacement::kEverywhere;
  return options;
}

/// Returns the amount printed at each tenth of a millimetre of the loop: the sum over both passes.
std::vector<double> FlowAlong(const Path& path, const std::vector<ScarfPiece>& pieces) {
  const auto length = static_cast<size_t>(PathLength(path) / 1e5 + 0.5);
  std::vector<double> flow(length, 0);
  double at = 0;
  Point from = path.points[0];
  for (const ScarfPiece& piece : pieces) {
    const double to = at + Distance(from, piece.to) / 1e5;
    for (double i = std::ceil(at - 0.5); i + 0.5 < to; ++i)
      flow[static_cast<size_t>(i) % length] += piece.flow;
    at = to;
    from = piece.to;
  }
  return flow;
}

TEST(Scarf, BothPassesAreOneBeadTogether) {
  const Path path = Loop();
  for (const double start : {0.0, 0.25}) {
    ScarfOptions options = Everywhere();
    options.start_height_ratio = start;
    const std::vector<ScarfPiece> pieces = ScarfedLoop(path, options);
    const std::vector<double> flows = FlowAlong(path, pieces);
    ASSERT_FALSE(flows.empty());
    for (const double flow : flows) EXPECT_NEAR(flow, 1, 1e-9);
  }
}

TEST(Scarf, RisesEvenlyAndStaysUp) {
  ScarfOptions options = Everywhere();
  options.start_height_ratio = 0.2;
  const std::vector<ScarfPiece> pieces = ScarfedLoop(Loop(), options);
  double last = 0.2;
  double length_mm = 0;
  Point from = Loop().points[0];
  for (const ScarfPiece& piece : pieces) {
    EXPECT_GE(piece.rise, last);
    const double piece_mm = ToMm(Distance(from, piece.to));
    if (length_mm < 20) {
      EXPECT_LE(piece_mm, 1 + 1e-9);
      EXPECT_NEAR(piece.rise, 0.2 + 0.8 * (length_mm + piece_mm) / 20, 1e-6);
      EXPECT_NEAR(piece.flow, (last + piece.rise) / 2, 1e-6) << "the height of its middle";
    }
    last = piece.rise;
    length_mm += piece_mm;
    from = piece.to;
  }
  EXPECT_EQ(last, 1);
  EXPECT_NEAR(length_mm, 120, 1e-6);
}

TEST(Scarf, IsNoLongerThanItsLoopAndAsLongIfAsked) {
  Path small = Loop("(2 0, 4 0, 4 4, 0 4, 0 0)");
  const auto length_mm = [](const Path& path, const ScarfOptions& options) {
    double length = 0;
    Point from = path.points[0];
    for (const ScarfPiece& piece : ScarfedLoop(path, options)) {
      length += ToMm(Distance(from, piece.to));
      from = piece.to;
    }
    return length;
  };
  EXPECT_NEAR(length_mm(small, Everywhere()), 32, 1e-6);
  ScarfOptions entire = Everywhere();
  entire.entire_loop = true;
  EXPECT_NEAR(length_mm(Loop(), entire), 200, 1e-6);
  for (const double flow : FlowAlong(Loop(), ScarfedLoop(Loop(), entire)))
    EXPECT_NEAR(flow, 1, 0.02) << "pieces need not divide the loop";
}

TEST(Scarf, WidthsGoAlong) {
  Path path = Loop();
  path.widths_nm = {400'000, 400'000, 400'000, 600'000, 600'000};
  const std::vector<ScarfPiece> pieces = ScarfedLoop(path, Everywhere());
  EXPECT_EQ(pieces.front().width_nm, 400'000);
  EXPECT_EQ(std::ranges::max(pieces, {}, &ScarfPiece::width_nm).width_nm, 600'000);
}

TEST(Scarf, OnlyLoopsThatAreAskedForHaveOne) {
  const ScarfOptions options = Everywhere();
  EXPECT_TRUE(HasScarf(Loop(), options));
  EXPECT_FALSE(HasScarf(Loop(), {}));
  Path open = Loop();
  open.closed = false;
  EXPECT_FALSE(HasScarf(open, options));
  Path inner = Loop();
  inner.feature = Feature::kPerimeter;
  EXPECT_FALSE(HasScarf(inner, options));
  ScarfOptions on_inner = options;
  on_inner.on_inner = true;
  EXPECT_TRUE(HasScarf(inner, on_inner));
  Path fill = inner;
  fill.feature = Feature::kSolidInfill;
  EXPECT_FALSE(HasScarf(fill, on_inner));
}

TEST(Scarf, ContoursAreNotHoles) {
  ScarfOptions options = Everywhere();
  options.placement = ScarfPlacement::kContours;
  EXPECT_TRUE(HasScarf(Loop(), options));
  Path hole = Loop();
  std::reverse(hole.points.begin() + 1, hole.points.end());
  EXPECT_FALSE(HasScarf(hole, options));
  EXPECT_TRUE(HasScarf(hole, Everywhere()));
}

TEST(Scarf, CornersNeedNone) {
  const Path corner = Loop("(0 0, 30 0, 30 20, 0 20)");
  EXPECT_FALSE(HasScarf(corner, Everywhere()));
  ScarfOptions options = Everywhere();
  options.only_on_smooth = false;
  EXPECT_TRUE(HasScarf(corner, options));
}

TEST(Scarf, HasItsLeastNumberOfSegments) {
  ScarfOptions options = Everywhere();
  options.length_mm = 5;
  const auto segments = [&] {
    const auto pieces = ScarfedLoop(Loop(), options);
    return std::ranges::count_if(pieces, [](const ScarfPiece& piece) { return piece.rise < 1; });
  };
  const auto few = segments();
  options.least_segments = 20;
  EXPECT_LT(few, 19);
  EXPECT_GE(segments(), 19) << "the last one ends at the top";
}

TEST(HasScarf, CornersByTheAngleOfTheSettings) {
  ScarfOptions options = Everywhere();
  // A turn of 20 degrees: the edges form an angle of 160 degrees.
  const Path bent = Loop("(0 0, 9.397 3.420, 0 30, -20 0)");
  EXPECT_TRUE(HasScarf(bent, options));
  options.smooth_angle_deg = 165;
  EXPECT_FALSE(HasScarf(bent, options));
  options.smooth_angle_deg = 155;
  EXPECT_TRUE(HasScarf(bent, options));
  EXPECT_FALSE(LimitsOverhang(options));
  options.most_overhang = 0.4;
  EXPECT_TRUE(LimitsOverhang(options));
}

}  // namespace
}  // namespace slicefarm::motion::scarf_test
