#include "services/planning/algo/infill/lightning.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/planning/algo/infill/branches.h"
#include "services/planning/algo/infill/grid_points.h"
#include "services/planning/algo/infill/sparse_areas.h"
#include "services/planning/algo/infill/stacks_test.h"

namespace slicefarm::planning::lightning_test {
namespace {

constexpr double kRadius = 2e6;

double NearestLine(Point p, const std::vector<Polyline>& lines) {
  double nearest = 1e18;
  for (const Polyline& line : lines)
    for (size_t i = 1; i < line.size(); ++i)
      nearest = std::min(nearest, DistanceToSegment(p, line[i - 1], line[i]));
  return nearest;
}

struct Sample {
  ObjectStack stack;
  std::vector<MultiPolygon> areas;
  std::vector<MultiPolygon> roofs;
  std::vector<std::vector<Polyline>> lines;
};

Sample SampleOf(ObjectStack stack) {
  Sample sample{std::move(stack), {}, {}, {}};
  sample.areas = SparseAreas(sample.stack, {1'000'000, 3, 3});
  sample.roofs = RoofsOf(sample.areas);
  sample.lines = LightningLines(sample.stack, sample.areas, sample.roofs, {kRadius, 0});
  return sample;
}

/// A box, a dome, a cone that widens upwards, random islands that shrink and grow.
std::vector<Sample> Samples() {
  std::vector<Sample> samples;
  samples.push_back(SampleOf(Prism(60, "(0 0, 30 0, 30 20, 0 20) (12 8, 12 12, 18 12, 18 8)")));
  samples.push_back(SampleOf(StackOf(50, [](int i) {
    return FastOffset(MakePolygonsOrDie("(0 0, 40 0, 40 40, 0 40)"), -FromMm(0.008 * i * i));
  })));
  samples.push_back(SampleOf(StackOf(50, [](int i) {
    return FastOffset(MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)"), FromMm(0.15 * i));
  })));
  std::mt19937 random(7);
  for (int k = 0; k < 12; ++k) {
    const MultiPolygon base = RandomIsland(random, {0, 0}, 15);
    samples.push_back(SampleOf(StackOf(40, [&](int i) {
      return FastOffset(base, FromMm(0.1 * ((i / 10 % 2 == 0) ? i % 10 : 10 - i % 10)));
    })));
  }
  return samples;
}

TEST(LightningLines, EveryRoofIsCarried) {
  for (const Sample& sample : Samples()) {
    for (size_t i = 0; i < sample.stack.size(); ++i) {
      const RegionEdges edges(sample.areas[i]);
      for (const Point p : GridPoints(sample.roofs[i], 700'000)) {
        const auto edge = edges.Nearest(p);
        const double nearest = std::min(edge->distance_nm, NearestLine(p, sample.lines[i]));
        // The grid on which places are looked at is half a radius wide.
        EXPECT_LE(nearest, 1.75 * kRadius) << i;
      }
    }
  }
}

// No point of a line is farther than twice the layer's height from what is below, which carries it.
TEST(LightningLines, LinesRestOnWhatIsBelow) {
  for (const Sample& sample : Samples()) {
    for (size_t i = 1; i < sample.stack.size(); ++i) {
      if (sample.areas[i - 1].empty()) continue;  // solid
      const RegionEdges edges(sample.areas[i - 1]);
      for (const Polyline& line : sample.lines[i]) {
        for (size_t k = 1; k < line.size(); ++k) {
          for (const double share : {0.0, 0.3, 0.7, 1.0}) {
            const Point way = line[k] - line[k - 1];
            const Point p = line[k - 1] + Point{std::llround(share * static_cast<double>(way.x)),
                                                std::llround(share * static_cast<double>(way.y))};
            const bool inside = Inside(p, sample.areas[i - 1]);
            const auto edge = edges.Nearest(p);
            const double nearest = std::min(edge->distance_nm, NearestLine(p, sample.lines[i - 1]));
            if (!inside) continue;
            EXPECT_LE(nearest, 2 * kStackHeight + 50'000) << i;
          }
        }
      }
    }
  }
}

TEST(LightningLines, LieInsideAndVanishDownwards) {
  for (const Sample& sample : Samples()) {
    for (size_t i = 0; i < sample.stack.size(); ++i) {
      const MultiPolygon grown = FastOffset(sample.areas[i], 2'000);
      for (const Polyline& line : sample.lines[i])
        for (const Point p : line) EXPECT_TRUE(Inside(p, grown)) << i;
    }
  }
  const Sample box = SampleOf(Prism(150, "(0 0, 30 0, 30 30, 0 30)"));
  double top = 0, bottom = 0;
  for (const Polyline& line : box.lines[146]) top += Length(line);
  for (const Polyline& line : box.lines[10]) bottom += Length(line);
  EXPECT_GT(top, 100e6);
  EXPECT_EQ(bottom, 0);  // 27 mm below a roof of 28 mm
}

TEST(LightningLines, AreTheSameEachTime) {
  const Sample a = SampleOf(Prism(60, "(0 0, 30 0, 30 20, 0 20)"));
  EXPECT_EQ(a.lines, LightningLines(a.stack, a.areas, a.roofs, {kRadius, 0}));
}

}  // namespace
}  // namespace slicefarm::planning::lightning_test
