#include "services/infill/algo/linking/solid_beads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/text_format.h"

namespace slicefarm::infill::solid_beads_test {
namespace {

constexpr double kPitch = 400'000;
constexpr Coord kInset = 190'000, kFree = 20'000;

/// The beads of a region's lines, in one place with all that they refer to.
struct Filled {
  explicit Filled(std::string_view text, double angle_rad = 0, bool fitted = true)
      : region(MakePolygonsOrDie(text)[0]),
        area(FastOffset({region}, -kInset)),
        lines(*CutLines(area, {angle_rad, 200'000, kPitch})),
        paths(Serpentine(lines, {.max_link_nm = 8 * kPitch})) {
    const SolidBeads maker(region, lines, paths,
                           {.fitted = fitted, .linked_nm = kInset, .free_nm = kFree});
    for (const SerpentinePath& path : paths) beads.push_back(maker.BeadOf(path));
  }

  PolygonWithHoles region;
  MultiPolygon area;
  ScanLines lines;
  std::vector<SerpentinePath> paths;
  std::vector<std::vector<StripPoint>> beads;
};

// Edges along and square to the lines: nothing but beads of one width.
TEST(SolidBeads, TurnsAreAsWideAsLines) {
  const Filled square("(0 0, 10 0, 10 10, 0 10)");
  ASSERT_EQ(square.beads.size(), 1u);
  for (const StripPoint& p : square.beads[0]) EXPECT_NEAR(p.strip_nm, kPitch, 0.03 * kPitch);
}

// Ends that no link leads on from come nearer to the edge than links do.
TEST(SolidBeads, FreeEndsReachTheEdge) {
  const Filled square("(0 0, 10 0, 10 10, 0 10)");
  for (const Point end : {square.beads[0].front().at, square.beads[0].back().at})
    EXPECT_NEAR(static_cast<double>(std::min(end.x, 10'000'000 - end.x)), kFree, 10);
}

// Lines of two sharp corners, where a step along the line would come too near to the other edge.
TEST(SolidBeads, StayInTheRegion) {
  for (const char* text : {"(0 0, 30 0, 3 2.4)", "(0 0, 12 0, 12 1, 1 1, 1 9, 0 9)",
                           "(0 0, 20 0, 20 8, 11 8, 10.7 1.1, 10.3 8, 0 8)"}) {
    for (double angle = 0; angle < 3.1; angle += 0.3) {
      const Filled filled(text, angle);
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

// Bridges: lines and links where they were cut, of one width, but for the free ends.
TEST(SolidBeads, EvenBeadsFollowTheEdge) {
  const Filled wedge("(0 0, 30 0, 3 2.4)", 0, false);
  for (size_t k = 0; k < wedge.beads.size(); ++k) {
    for (const StripPoint& p : wedge.beads[k]) EXPECT_EQ(p.strip_nm, kPitch);
    for (const Point p : wedge.paths[k].points)
      EXPECT_TRUE(
          std::ranges::any_of(wedge.beads[k], [&](const StripPoint& q) { return q.at == p; }));
  }
}

}  // namespace
}  // namespace slicefarm::infill::solid_beads_test
