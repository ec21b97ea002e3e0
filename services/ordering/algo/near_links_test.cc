#include "services/ordering/algo/near_links.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <utility>

#include "common/model/bead_section.h"

namespace slicefarm::ordering::near_links_test {
namespace {

constexpr Coord kHeight = 200'000;
constexpr Coord kWidth = 450'000;

/// Walls: the horizontal line y = 0.1 mm, or nothing.
class Line : public Barrier {
 public:
  explicit Line(bool is_there) : is_there_(is_there) {}
  bool Parts(Point a, Point b) const override {
    return is_there_ && (a.y < 100'000) != (b.y < 100'000);
  }

 private:
  bool is_there_;
};

/// Returns a square loop that starts at its lower left corner.
Path Loop(Feature feature, Coord low, Coord high) {
  Path path;
  path.feature = feature;
  path.inset = feature == Feature::kExternalPerimeter ? 0 : 1;
  path.closed = true;
  path.points = {{low, low}, {high, low}, {high, high}, {low, high}};
  path.widths_nm = {kWidth};
  return path;
}

Path Stroke(Feature feature, Point from, Point to) {
  Path path;
  path.feature = feature;
  path.inset = 1;
  path.points = {from, to};
  path.widths_nm = {kWidth};
  return path;
}

double VolumeMm3(const Path& path) {  // REQUIRES: one width
  return SectionMm2(path.widths_nm[0], kHeight) * ToMm(PathLength(path));
}

struct Case {
  std::string name;
  Path last;
  Path next;
  bool is_parted = false;
  bool is_linked = true;
};

class LinkBetweenTest : public testing::TestWithParam<Case> {};

TEST_P(LinkBetweenTest, IsThereOrNot) {
  Case c = GetParam();
  const auto link = LinkBetween({c.last, c.last.closed}, c.next, kHeight, Line(c.is_parted));
  ASSERT_EQ(link.has_value(), c.is_linked);
  if (!link) {
    EXPECT_EQ(c.last, GetParam().last);
    EXPECT_EQ(c.next, GetParam().next);
    return;
  }
  EXPECT_TRUE(WellFormed(*link));
  EXPECT_EQ(StartOf(*link), EndOf(c.last));
  EXPECT_EQ(EndOf(*link), StartOf(c.next));
  EXPECT_EQ(StartOf(c.next), StartOf(GetParam().next));
  EXPECT_NE(link->feature, Feature::kExternalPerimeter);
}

const Path kOuter = Loop(Feature::kExternalPerimeter, 0, 20'000'000);
const Path kInner = Loop(Feature::kPerimeter, 400'000, 19'600'000);
const Path kPiece = Stroke(Feature::kPerimeter, {0, 0}, {5'000'000, 0});

Path OfTool(Path path, int32_t tool) {
  path.tool = tool;
  return path;
}

INSTANTIATE_TEST_SUITE_P(
    Paths, LinkBetweenTest,
    testing::Values(
        Case{"InnerToOuter", kInner, kOuter}, Case{"OuterToInner", kOuter, kInner},
        Case{"PieceToPiece", kPiece, Stroke(Feature::kGapFill, {5'200'000, 0}, {9'000'000, 0})},
        Case{"InfillToInfill", Stroke(Feature::kSolidInfill, {0, 0}, {5'000'000, 0}),
             Stroke(Feature::kInternalInfill, {5'200'000, 0}, {9'000'000, 0})},
        Case{"OuterToOuter", kOuter, Loop(Feature::kExternalPerimeter, -400'000, -200'000)},
        Case{"EndToStart", kPiece, Stroke(Feature::kPerimeter, {5'000'000, 0}, {9'000'000, 0}),
             false, false},
        Case{"TooFar", kPiece, Stroke(Feature::kPerimeter, {6'000'000, 0}, {9'000'000, 0}), false,
             false},
        Case{"WallBetween", kPiece,
             Stroke(Feature::kPerimeter, {5'000'000, 200'000}, {9'000'000, 0}), true, false},
        Case{"Seen", kPiece, Stroke(Feature::kTopSolidInfill, {5'200'000, 0}, {9'000'000, 0}),
             false, false},
        Case{"OverAir", kPiece, Stroke(Feature::kBridgeInfill, {5'200'000, 0}, {9'000'000, 0}),
             false, false},
        Case{"Support", Stroke(Feature::kSupport, {0, 0}, {5'000'000, 0}),
             Stroke(Feature::kSupport, {5'200'000, 0}, {9'000'000, 0}), false, false},
        Case{"SupportLoops", Loop(Feature::kSupport, 400'000, 4'000'000),
             Loop(Feature::kSupport, 0, 4'400'000)},
        Case{"SupportLoopAndLine", Loop(Feature::kSupport, 400'000, 4'000'000),
             Stroke(Feature::kSupport, {0, 0}, {5'000'000, 0}), false, false},
        Case{"OtherTool", kPiece,
             OfTool(Stroke(Feature::kPerimeter, {5'200'000, 0}, {9'000'000, 0}), 1), false, false}),
    [](const auto& info) { return info.param.name; });

TEST(LinkBetween, LoopGivesWhatTheLinkTakes) {
  for (const bool inner_first : {true, false}) {
    Path last = inner_first ? kInner : kOuter, next = inner_first ? kOuter : kInner;
    const double before = VolumeMm3(last) + VolumeMm3(next);
    const auto link = LinkBetween({last, true}, next, kHeight, Line(false));
    ASSERT_TRUE(link.has_value());
    EXPECT_NEAR(VolumeMm3(last) + VolumeMm3(next) + VolumeMm3(*link), before, 1e-6);
    const Path& outer = inner_first ? next : last;
    const Path& inner = inner_first ? last : next;
    EXPECT_EQ(outer, kOuter);
    EXPECT_FALSE(inner.closed);
    EXPECT_NEAR(ToMm(Distance(StartOf(inner), EndOf(inner))), kLinkFlow * 0.4 * std::numbers::sqrt2,
                1e-6);
  }
}

TEST(LinkBetween, LinesOfSparseInfillAreLinkedByABeadOfTheirWidth) {
  Path line = Stroke(Feature::kInternalInfill, {0, 0}, {9'000'000, 0});
  Path next = Stroke(Feature::kInternalInfill, {9'000'000, 800'000}, {0, 800'000});
  const auto link = LinkBetween({line}, next, kHeight, Line(false));
  ASSERT_TRUE(link.has_value());
  EXPECT_EQ(link->widths_nm, std::vector<Coord>{kWidth});
  Path loop = Loop(Feature::kInternalInfill, 0, 20'000'000);
  Path inner = Loop(Feature::kInternalInfill, 600'000, 19'400'000);
  const auto step = LinkBetween({loop, true}, inner, kHeight, Line(false));
  ASSERT_TRUE(step.has_value());
  EXPECT_EQ(step->widths_nm, std::vector<Coord>{kWidth});
  EXPECT_NEAR(PathLength(loop), 80e6 - 600'000 * std::numbers::sqrt2, 10);
}

TEST(LinkBetween, LoopOfVaryingWidthKeepsItsWidths) {
  Path last = kInner, next = kOuter;
  last.widths_nm = {400'000, 420'000, 440'000, 460'000};
  ASSERT_TRUE(LinkBetween({last, true}, next, kHeight, Line(false)).has_value());
  ASSERT_TRUE(WellFormed(last));
  EXPECT_THAT(std::vector<Coord>(last.widths_nm.begin(), last.widths_nm.end() - 1),
              testing::ElementsAre(400'000, 420'000, 440'000, 460'000));
  EXPECT_GT(last.widths_nm.back(), 400'000);
  EXPECT_LT(last.widths_nm.back(), 402'000);
}

TEST(LinkBetween, CutsThroughShortEdges) {
  Path last = kInner, next = kOuter;
  last.points.push_back({400'000, 450'000});
  ASSERT_TRUE(LinkBetween({last, true}, next, kHeight, Line(false)).has_value());
  EXPECT_EQ(last.points.size(), 5);
  EXPECT_NEAR(ToMm(PathLength(last)), 4 * 19.2 - kLinkFlow * 0.4 * std::numbers::sqrt2, 1e-6);
}

TEST(LinkBetween, SmallLoopStaysWhole) {
  Path last = Loop(Feature::kPerimeter, 400'000, 700'000), next = kOuter;
  const auto link = LinkBetween({last, true}, next, kHeight, Line(false));
  ASSERT_TRUE(link.has_value());
  EXPECT_TRUE(last.closed);
}

}  // namespace
}  // namespace slicefarm::ordering::near_links_test
