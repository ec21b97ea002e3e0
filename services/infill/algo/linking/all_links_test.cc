#include "services/infill/algo/linking/all_links.h"

#include <gtest/gtest.h>

#include <string_view>

#include "common/geometry/text_format_test.h"
#include "services/infill/algo/lines/straight_pieces.h"

namespace slicefarm::infill::all_links_test {
namespace {

struct Linked {
  int32_t loose = 0;
  int32_t links = 0;
  double length_nm = 0;
};

Linked LinkAll(std::string_view text, const LineFamily& family, double max_link_nm) {
  const MultiPolygon region = MakePolygonsOrDie(text);
  const auto pieces = StraightPieces(region, {&family, 1});
  const EdgeEnds ends(region, *pieces);
  const Links links = LinkAllEnds(ends, max_link_nm);
  Linked linked;
  for (int32_t end = 0; end < ends.size(); ++end) {
    if (LinkedTo(ends, links, end) == kNoEnd) ++linked.loose;
    if (!links[static_cast<size_t>(end)]) continue;
    EXPECT_FALSE(links[static_cast<size_t>(ends.Next(end))]);
    ++linked.links;
    linked.length_nm += ends.SpanLength(end);
    EXPECT_LE(ends.SpanLength(end), max_link_nm);
  }
  return linked;
}

TEST(LinkAllEnds, LeavesNoneLoose) {
  const Linked linked =
      LinkAll("(0 0, 10 0, 10 10, 0 10) (4 4, 4 6, 6 6, 6 4)", {0, 0.5e6, 1e6}, 50e6);
  EXPECT_EQ(linked.loose, 0);
  EXPECT_EQ(linked.links, 12);  // 8 whole lines, and two lines in two pieces each
}

TEST(LinkAllEnds, TakesTheShorterHalf) {
  // Lines are at 1, 3, 5 and 7 of 10. Links along the sides have 2 + 2 between pairs, or 2 plus the
  // two long ones.
  const Linked linked = LinkAll("(0 0, 10 0, 10 8, 0 8)", {0, 1e6, 2e6}, 50e6);
  EXPECT_EQ(linked.loose, 0);
  EXPECT_NEAR(linked.length_nm, 8e6, 10);
}

TEST(LinkAllEnds, LongStretchesStayOut) {
  EXPECT_EQ(LinkAll("(0 0, 10 0, 10 8, 0 8)", {0, 1e6, 2e6}, 1e6).loose, 8);
  // With one line, the two paths from end to end are 20 and 16 mm long.
  EXPECT_EQ(LinkAll("(0 0, 10 0, 10 8, 0 8)", {0, 3e6, 20e6}, 15e6).loose, 2);
  EXPECT_EQ(LinkAll("(0 0, 10 0, 10 8, 0 8)", {0, 3e6, 20e6}, 17e6).loose, 0);
}

}  // namespace
}  // namespace slicefarm::infill::all_links_test
