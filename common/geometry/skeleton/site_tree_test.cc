#include "common/geometry/skeleton/site_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "common/geometry/text_format_test.h"

namespace slicefarm::site_tree_test {
namespace {

double SquaredDistance(const Site& site, const Vector2& p) {
  const double along = std::clamp(site.Along(p), 0.0, site.length);
  const Vector2 away = p - (site.from + along * site.direction);
  return Dot(away, away);
}

/// Returns a square with n x n square holes.
PolygonWithHoles Lattice(int n) {
  const Coord pitch = FromMm(1), wall = FromMm(0.4);
  const Coord size = n * pitch + wall;
  PolygonWithHoles region{{{0, 0}, {size, 0}, {size, size}, {0, size}}, {}};
  for (int i = 0; i < n * n; ++i) {
    const Coord x = i % n * pitch + wall, y = i / n * pitch + wall, side = pitch - wall;
    region.holes.push_back({{x, y}, {x, y + side}, {x + side, y + side}, {x + side, y}});
  }
  return region;
}

struct TreeCase {
  std::string name;
  PolygonWithHoles region;
};

class SiteTreeOf : public testing::TestWithParam<TreeCase> {};

TEST_P(SiteTreeOf, FindsEveryEdgeWithinADistance) {
  const auto boundary = MakeBoundary(GetParam().region);
  ASSERT_TRUE(boundary.has_value());
  const SiteTree tree(*boundary);
  const int edges = static_cast<int>(boundary->edges.size());
  size_t found = 0;
  for (int i = 0; i < 200; ++i) {
    // Places in and around the region, and distances from 0 to its size.
    const Vector2 p = tree.Diagonal() * Vector2(i % 14 / 10.0 - 0.7, i / 14 / 10.0 - 0.7);
    const double distance = tree.Diagonal() * (i % 7) * (i % 7) / 40;
    std::set<int> visited;
    const double limit = distance * distance;
    tree.ForEachWithin(
        p, limit, [&](int edge) { EXPECT_TRUE(visited.insert(edge).second) << "visited twice"; });
    found += visited.size();
    for (int edge = 0; edge < edges; ++edge) {
      if (SquaredDistance(tree[edge], p) > limit) continue;
      EXPECT_TRUE(visited.contains(edge)) << edge;
    }
  }
  EXPECT_GT(found, 0u);
  // The tree leaves out most edges.
  if (edges > 100) {
    EXPECT_LT(found, 200u * edges / 2);
  }
}

TEST_P(SiteTreeOf, ASmallerLimitEndsTheSearch) {
  const auto boundary = MakeBoundary(GetParam().region);
  ASSERT_TRUE(boundary.has_value());
  const SiteTree tree(*boundary);
  double limit = 1e30;
  int visits = 0;
  tree.ForEachWithin(Vector2::Zero(), limit, [&](int) {
    ++visits;
    limit = -1;
  });
  EXPECT_GT(visits, 0);
  // Only leaves that were already open are visited.
  EXPECT_LE(visits, 16);
}

INSTANTIATE_TEST_SUITE_P(
    SiteTree, SiteTreeOf,
    testing::Values(TreeCase{"Triangle", MakePolygonsOrDie("(0 0, 4 0, 1 3)")[0]},
                    TreeCase{"FiveCorners", MakePolygonsOrDie("(0 0, 4 0, 5 2, 3 3, 0 3)")[0]},
                    TreeCase{"Lattice", Lattice(9)}),
    [](const auto& info) { return info.param.name; });

TEST(SiteTree, SitesAreTheEdgesInNm) {
  const auto boundary = MakeBoundary(MakePolygonsOrDie("(0 0, 4 0, 4 3, 2 1, 0 3)")[0]);
  ASSERT_TRUE(boundary.has_value());
  const SiteTree tree(*boundary);
  const std::vector<BoundaryEdge> edges = boundary->EdgesInNm();
  for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
    EXPECT_EQ(RoundedPoint(tree[i].from), edges[i].from);
    EXPECT_EQ(RoundedPoint(tree[i].To()), edges[i].to);
    EXPECT_EQ(tree[i].starts_reflex, boundary->StartsReflex(i));
    EXPECT_EQ(tree[i].SideOf(ToVector(edges[i].from)), 0);
  }
}

}  // namespace
}  // namespace slicefarm::site_tree_test
