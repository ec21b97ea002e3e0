#include "services/infill/algo/linking/least_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "common/base/perfect_matching.h"
#include "common/geometry/text_format_test.h"
#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill::least_links_test {
namespace {

struct Sum {
  int64_t count = 0;
  int64_t length_nm = 0;

  friend bool operator==(const Sum&, const Sum&) = default;
};

Sum SumOf(const EdgeEnds& ends, const Links& links) {
  Sum sum;
  for (const int32_t end : ends.OnEdge()) {
    if (!links[static_cast<size_t>(end)]) continue;
    ++sum.count;
    sum.length_nm += std::llround(ends.LinkLength(end));
  }
  return sum;
}

/// Returns the best sum by Edmonds' algorithm: a perfect matching of two copies of the graph. An
/// end that stays loose is matched with its own copy, at a price higher than any link.
Sum BestSum(const EdgeEnds& ends, double max_link_nm) {
  constexpr int64_t kPrice = 1'000'000'000'000;
  const int32_t count = ends.size();
  std::vector<WeightedEdge> edges;
  for (int32_t end = 0; end < count; ++end) {
    edges.push_back({end, count + end, kPrice});
    if (!ends.IsOnEdge(end) || ends.Next(end) == end) continue;
    if (ends.LinkLength(end) > max_link_nm) continue;
    const int64_t length = std::llround(ends.LinkLength(end));
    edges.push_back({end, ends.Next(end), length});
    edges.push_back({count + end, count + ends.Next(end), length});
  }
  const PerfectMatching matching = LightestPerfectMatching(2 * count, edges);
  Sum sum;
  for (int32_t end = 0; end < count; ++end) {
    const int32_t mate = matching.mate[static_cast<size_t>(end)];
    if (mate >= count || mate < end) continue;
    ++sum.count;
    int64_t least = kPrice;
    for (const WeightedEdge& edge : edges)
      if (std::minmax(edge.a, edge.b) == std::minmax(end, mate))
        least = std::min(least, edge.weight);
    sum.length_nm += least;
  }
  return sum;
}

TEST(LeastLinks, AreWhatEdmondsAlgorithmFinds) {
  const MultiPolygon region = MakePolygonsOrDie(
      "(0 0, 40 0, 40 30, 22 30, 20 12, 18 30, 0 30) (5 5, 5 12, 12 13, 13 4) (26 6, 27 9, 33 8)");
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Curve> curves;
    const auto coord = [&](int most_mm) {
      return static_cast<Coord>(random() % static_cast<uint32_t>(most_mm * 1'000'000));
    };
    const uint32_t count = 1 + random() % 14;
    for (uint32_t i = 0; i < count; ++i)
      curves.push_back({{{coord(60) - 10'000'000, coord(50) - 10'000'000},
                         {coord(60) - 10'000'000, coord(50) - 10'000'000}}});
    const std::vector<Piece> pieces = ClipCurves(region, curves);
    const EdgeEnds ends(region, pieces);
    const double most = static_cast<double>(coord(30));
    const Links links = LeastLinks(ends, most);
    for (const int32_t end : ends.OnEdge()) {
      if (!links[static_cast<size_t>(end)]) continue;
      EXPECT_LE(ends.LinkLength(end), most);
      EXPECT_FALSE(links[static_cast<size_t>(ends.Next(end))]);
    }
    EXPECT_EQ(SumOf(ends, links), BestSum(ends, most)) << trial;
  }
}

}  // namespace
}  // namespace slicefarm::infill::least_links_test
