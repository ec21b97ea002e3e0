#include "services/infill/algo/linking/near_ends.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/geometry/text_format_test.h"
#include "services/infill/algo/lines/straight_pieces.h"

namespace slicefarm::infill::near_ends_test {
namespace {

constexpr double kFar = 1e12;

struct Case {
  const char* name;
  const char* region;  ///< coordinates in mm
  double angle_rad;
};

const Case kCases[] = {
    {"four holes",
     "(0 0, 60 0, 60 60, 0 60) (10 10, 10 18, 18 18, 18 10) (42 10, 42 18, 50 18, 50 10) "
     "(10 42, 10 50, 18 50, 18 42) (42 42, 42 50, 50 50, 50 42)",
     std::numbers::pi / 4},
    {"ring", "(0 0, 50 0, 50 50, 0 50) (5 5, 5 45, 45 45, 45 5)", 0.3},
    {"comb", "(0 0, 50 0, 50 5, 40 5, 40 30, 30 30, 30 5, 20 5, 20 30, 10 30, 10 5, 0 5)", 0.2},
};

int32_t LooseEnds(const EdgeEnds& ends, const Links& links) {
  int32_t loose = 0;
  for (int32_t end = 0; end < ends.size(); ++end)
    loose += LinkedTo(ends, links, end) == kNoEnd ? 1 : 0;
  return loose;
}

/// Checks that no end is in two links, no end is linked to itself, and no link is longer than
/// allowed.
void ExpectLinks(const EdgeEnds& ends, const Links& links, double max_link_nm) {
  for (const int32_t end : ends.OnEdge()) {
    if (!links[static_cast<size_t>(end)]) continue;
    EXPECT_NE(ends.Next(end), end);
    EXPECT_FALSE(links[static_cast<size_t>(ends.Next(end))]);
    EXPECT_LE(ends.SpanLength(end), max_link_nm);
  }
}

TEST(PathsBetween, IsTheShortestTreeBetweenEnds) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 10 0, 10 30, 0 30)");
  const LineFamily lines{0, 5e6, 10e6};  // at y = 5, 15 and 25
  const auto pieces = StraightPieces(region, {&lines, 1});
  const EdgeEnds ends(region, *pieces);
  Links links(static_cast<size_t>(ends.size()), false);
  EXPECT_NEAR(*PathsBetween(ends, links), 20e6, 10);
  links = ChooseLinks(ends, kFar);
  EXPECT_EQ(*PathsBetween(ends, links), 0) << "one path";
}

TEST(PathsBetween, KnowsNoRings) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 10 0, 10 20, 0 20)");
  const LineFamily lines{0, 5e6, 10e6};
  const auto pieces = StraightPieces(region, {&lines, 1});
  const EdgeEnds ends(region, *pieces);
  Links links(static_cast<size_t>(ends.size()), false);
  links[static_cast<size_t>(ends.OnEdge()[0])] = links[static_cast<size_t>(ends.OnEdge()[2])] =
      true;
  EXPECT_FALSE(PathsBetween(ends, links).has_value());
}

TEST(BringEndsTogether, ShortensTheWaysBetweenAsManyPaths) {
  double before = 0, after = 0;
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const MultiPolygon region = MakePolygonsOrDie(c.region);
    for (const double max_link_nm : {kFar, 8e6}) {
      const LineFamily lines{c.angle_rad, 0, 2e6};
      const auto pieces = StraightPieces(region, {&lines, 1});
      const EdgeEnds ends(region, *pieces);
      const Links chosen = ChooseLinks(ends, max_link_nm);
      const Links moved = BringEndsTogether(ends, chosen, max_link_nm);
      ExpectLinks(ends, moved, max_link_nm);
      EXPECT_EQ(LooseEnds(ends, moved), LooseEnds(ends, chosen));
      ASSERT_TRUE(PathsBetween(ends, moved).has_value()) << "a ring";
      EXPECT_EQ(BringEndsTogether(ends, chosen, max_link_nm), moved) << "the same each time";
      before += *PathsBetween(ends, chosen);
      after += *PathsBetween(ends, moved);
    }
  }
  EXPECT_LT(after, 0.9 * before);
}

TEST(BringEndsTogether, OnePathStays) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 40 0, 40 40, 0 40)");
  const LineFamily lines{0.5, 0, 2e6};
  const auto pieces = StraightPieces(region, {&lines, 1});
  const EdgeEnds ends(region, *pieces);
  const Links chosen = ChooseLinks(ends, kFar);
  EXPECT_EQ(BringEndsTogether(ends, chosen, kFar), chosen);
}

}  // namespace
}  // namespace slicefarm::infill::near_ends_test
