#include "services/infill/algo/linking/solid_beads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::solid_beads_test {
namespace {

constexpr double kPitch = 400'000;
constexpr Coord kInset = 30'000;
constexpr double kLinkShare = 0.15;

/// Beads of a region's lines, together with all data that they refer to.
struct Filled {
  explicit Filled(std::string_view text, double angle_rad = 0, bool fitted = true)
      : region(MakePolygonsOrDie(text)[0]),
        area(FastOffset({region}, -kInset)),
        lines(*CutLines(area, {angle_rad, 200'000, kPitch})),
        paths(Serpentine(lines, {.max_link_nm = 8 * kPitch})) {
    const SolidBeads maker(
        region, lines, paths,
        {.fitted = fitted, .reach_nm = kInset, .link_share = fitted ? kLinkShare : 1});
    for (const SerpentinePath& path : paths) beads.push_back(maker.BeadOf(path));
  }

  PolygonWithHoles region;
  MultiPolygon area;
  ScanLines lines;
  std::vector<SerpentinePath> paths;
  std::vector<std::vector<StripPoint>> beads;
};

// With edges along and perpendicular to the lines, lines have one width. The links between them
// fill the space that the lines' ends leave empty. The width steps between them.
TEST(SolidBeads, LinksHoldWhatTheEndsOfLinesLack) {
  const Filled square("(0 0, 10 0, 10 10, 0 10)");
  ASSERT_EQ(square.beads.size(), 1u);
  const auto& bead = square.beads[0];
  double area = 0;
  int links = 0;
  for (size_t i = 1; i < bead.size(); ++i) {
    const double length = Distance(bead[i - 1].at, bead[i].at);
    if (length == 0) continue;
    ASSERT_EQ(bead[i - 1].strip_nm, bead[i].strip_nm);
    const bool link = bead[i].strip_nm < 0.5 * kPitch;
    links += link ? 1 : 0;
    EXPECT_NEAR(bead[i].strip_nm, link ? kLinkShare * kPitch : kPitch, 0.03 * kPitch);
    area += length * bead[i].strip_nm;
  }
  EXPECT_EQ(links, std::ssize(square.paths[0].pieces) - 1);
  EXPECT_NEAR(area / 1e14, 1, 0.001);
}

// Lines of two sharp corners, where a step along the line would be too near to the other edge.
TEST(SolidBeads, StayInTheRegion) {
  for (const char* text : {"(0 0, 30 0, 3 2.4)", "(0 0, 12 0, 12 1, 1 1, 1 9, 0 9)",
                           "(0 0, 20 0, 20 8, 11 8, 10.7 1.1, 10.3 8, 0 8)"}) {
    for (double angle = 0; angle < 3.1; angle += 0.3) {
      const Filled filled(text, angle);
      ASSERT_FALSE(filled.beads.empty());
      const MultiPolygon grown = FastOffset({filled.region}, 100);
      for (const auto& bead : filled.beads) {
        for (size_t i = 1; i < bead.size(); ++i) {
          const Point middle{(bead[i - 1].at.x + bead[i].at.x) / 2,
                             (bead[i - 1].at.y + bead[i].at.y) / 2};
          EXPECT_TRUE(Inside(bead[i].at, grown) && Inside(middle, grown))
              << text << " " << angle << " " << ToText(bead[i].at);
        }
      }
    }
  }
}

// Bridges have lines and links at their cut positions, with one width, except at the free ends.
TEST(SolidBeads, EvenBeadsFollowTheEdge) {
  const Filled wedge("(0 0, 30 0, 3 2.4)", 0, false);
  ASSERT_FALSE(wedge.beads.empty());
  for (size_t k = 0; k < wedge.beads.size(); ++k) {
    for (const StripPoint& p : wedge.beads[k]) EXPECT_EQ(p.strip_nm, kPitch);
    for (const Point p : wedge.paths[k].points)
      EXPECT_TRUE(
          std::ranges::any_of(wedge.beads[k], [&](const StripPoint& q) { return q.at == p; }));
  }
}

}  // namespace
}  // namespace slicefarm::infill::solid_beads_test
