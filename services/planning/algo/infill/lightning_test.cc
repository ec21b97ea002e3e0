#include "services/planning/algo/infill/lightning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/planning/algo/infill/grid_points.h"
#include "services/planning/algo/infill/lightning_trees.h"
#include "services/planning/algo/infill/sparse_areas.h"
#include "services/planning/algo/infill/stacks_test.h"

namespace slicefarm::planning::lightning_test {
namespace {

constexpr double kRadius = 2e6;
constexpr Coord kWalls = 1'000'000;
constexpr int kSkins = 3;

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
  const auto inner = InnerAreas(sample.stack, kWalls);
  sample.areas =
      HollowAreas(inner, SparseAreas(sample.stack, inner, {kSkins, kSkins}), std::llround(kRadius));
  sample.roofs = RoofsOf(sample.areas);
  sample.lines = LightningLines(sample.stack, sample.areas, sample.roofs, {kRadius, 0});
  return sample;
}

/// Returns a box, a dome, a cone that widens upwards, and random islands that shrink and grow.
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

/// Returns the length of all lines in mm.
double LengthOfAll(const std::vector<std::vector<Polyline>>& layers) {
  double length = 0;
  for (const std::vector<Polyline>& lines : layers)
    for (const Polyline& line : lines) length += Length(line) / 1e6;
  return length;
}

// Each angle above 45 degrees saves lines, each smaller angle adds some.
TEST(LightningLines, AnglesChangeTheLength) {
  const Sample box = SampleOf(Prism(60, "(0 0, 30 0, 30 20, 0 20)"));
  const auto length = [&](const LightningRules& rules) {
    return LengthOfAll(LightningLines(box.stack, box.areas, box.roofs, rules));
  };
  const double usual = length({kRadius});
  ASSERT_GT(usual, 100);
  EXPECT_LT(length({.radius_nm = kRadius, .overhang = 8}), 0.98 * usual);
  EXPECT_LT(length({.radius_nm = kRadius, .prune = 4}), 0.8 * usual);
  EXPECT_GT(length({.radius_nm = kRadius, .prune = 0.25}), 1.2 * usual);
  EXPECT_NE(length({.radius_nm = kRadius, .straighten = 0.1}), usual);
}

TEST(LightningLines, EveryRoofIsCarried) {
  int checked = 0;
  for (const Sample& sample : Samples()) {
    for (size_t i = 0; i < sample.stack.size(); ++i) {
      const RegionEdges edges(sample.areas[i]);
      for (const Point p : GridPoints(sample.roofs[i], 700'000)) {
        const auto edge = edges.Nearest(p);
        const double nearest = std::min(edge->distance_nm, NearestLine(p, sample.lines[i]));
        // The sampling grid has a step of half a radius.
        ++checked;
        EXPECT_LE(nearest, 1.75 * kRadius) << i;
      }
    }
  }
  EXPECT_GT(checked, 1000);
}

// The support below is within twice the layer's height of every point of a line.
TEST(LightningLines, LinesRestOnWhatIsBelow) {
  int checked = 0;
  for (const Sample& sample : Samples()) {
    for (size_t i = 1; i < sample.stack.size(); ++i) {
      if (sample.areas[i - 1].empty()) continue;  // the layer is solid
      const RegionEdges edges(sample.areas[i - 1]);
      for (const Polyline& line : sample.lines[i]) {
        for (size_t k = 1; k < line.size(); ++k) {
          for (const double share : {0.0, 0.3, 0.7, 1.0}) {
            const Point path = line[k] - line[k - 1];
            const Point p = line[k - 1] + Point{std::llround(share * static_cast<double>(path.x)),
                                                std::llround(share * static_cast<double>(path.y))};
            const bool inside = Inside(p, sample.areas[i - 1]);
            const auto edge = edges.Nearest(p);
            const double nearest = std::min(edge->distance_nm, NearestLine(p, sample.lines[i - 1]));
            if (!inside) continue;
            EXPECT_LE(nearest, 2 * kStackHeight + 50'000) << i;
            ++checked;
          }
        }
      }
    }
  }
  EXPECT_GT(checked, 1000);
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
  EXPECT_EQ(bottom, 0);  // 27 mm below a roof at 28 mm
}

/// Raster with pixels of 0.25 mm over a plate of 32 mm. It shares no code with polygons and their
/// offsets.
class Raster {
 public:
  static constexpr int kSide = 128;
  static constexpr double kPixel = 0.25e6;

  explicit Raster(const std::function<bool(Point)>& is_set) {
    for (int k = 0; k < kSide * kSide; ++k) cells_.push_back(is_set(MiddleOf(k)));
  }
  static Point MiddleOf(int k) {
    return {std::llround((k % kSide + 0.5) * kPixel) - 1'000'000,
            std::llround((k / kSide + 0.5) * kPixel) - 1'000'000};
  }
  bool operator[](int k) const { return cells_[static_cast<size_t>(k)] != 0; }

  /// Returns the distance from a pixel to the nearest pixel that is set (or not set), up to `most`.
  double Away(int k, double most, bool set = true) const {
    double nearest = most;
    const int reach = static_cast<int>(most / kPixel) + 1, x = k % kSide, y = k / kSide;
    for (int j = std::max(0, y - reach); j <= std::min(kSide - 1, y + reach); ++j)
      for (int i = std::max(0, x - reach); i <= std::min(kSide - 1, x + reach); ++i)
        if ((*this)[j * kSide + i] == set)
          nearest = std::min(nearest, kPixel * std::hypot(i - x, j - y));
    return nearest;
  }
  Raster Where(const std::function<bool(int)>& is_set) const {
    Raster result = *this;
    for (int k = 0; k < kSide * kSide; ++k) result.cells_[static_cast<size_t>(k)] = is_set(k);
    return result;
  }
  /// Returns the union of all discs of a diameter that fit in the set pixels.
  Raster Opened(double diameter) const {
    const double radius = diameter / 2;
    const Raster core =
        Where([&](int k) { return (*this)[k] && Away(k, radius, false) >= radius; });
    return Where([&](int k) { return (*this)[k] && core.Away(k, radius + kPixel) < radius; });
  }

 private:
  std::vector<char> cells_;
};

/// Returns plates of 30 mm with tops that are open along a slot. The slot widens upwards by a given
/// step per layer. The last one is a plate with a pit and a ramp into it.
std::vector<ObjectStack> Decks() {
  std::vector<ObjectStack> decks;
  for (const double widens : {0.3, 0.6, 0.9, 1.4}) {
    decks.push_back(StackOf(34, [&](int i) {
      const MultiPolygon plate = MakePolygonsOrDie("(0 0, 30 0, 30 30, 0 30)");
      if (i < 20) return plate;
      const Coord from = FromMm(9), to = from + FromMm(widens) * (i - 19);
      return Difference(
          plate,
          {{{{from, FromMm(6)}, {to, FromMm(6)}, {to, FromMm(24)}, {from, FromMm(24)}}, {}}});
    }));
  }
  return decks;
}

// Checks on pixels that solid infill over a hollow place is close to support. Close is
// the distance of docs/algorithms/planned-infill.md to a wall, a line, or solid infill as wide as
// the line distance. Narrower strips may have no support.
TEST(LightningLines, CarrySkinsOfSlopesByARastersMeasure) {
  const std::vector<ObjectStack> decks = Decks();
  ASSERT_FALSE(decks.empty());
  for (const ObjectStack& stack : decks) {
    const Sample sample = SampleOf(stack);
    const auto inner = [&](size_t i) {
      const Raster whole([&](Point p) { return Inside(p, stack[i].whole); });
      return whole.Where([&](int k) {
        return whole[k] && whole.Away(k, kWalls + Raster::kPixel, false) > kWalls;
      });
    };
    const auto solid = [&](size_t i) {
      const Raster here = inner(i);
      return here.Where([&](int k) {
        if (!here[k]) return false;
        for (size_t j = i - kSkins; j <= i + kSkins; ++j)
          if (j >= stack.size() || !Inside(Raster::MiddleOf(k), stack[j].whole)) return true;
        return false;
      });
    };
    int looked_at = 0;
    for (size_t i = 14; i + 5 < stack.size(); ++i) {
      const Raster room = inner(i), wide = solid(i).Opened(kRadius), above = solid(i + 1);
      const Raster supports = room.Where([&](int k) { return !room[k] || wide[k]; });
      for (int k = 0; k < Raster::kSide * Raster::kSide; ++k) {
        if (!above[k] || supports[k]) continue;
        ++looked_at;
        const double most = 1.75 * kRadius;
        if (supports.Away(k, most) < most) continue;
        EXPECT_LE(NearestLine(Raster::MiddleOf(k), sample.lines[i]), most + Raster::kPixel) << i;
      }
    }
    EXPECT_GT(looked_at, 500);
  }
}

TEST(LightningLines, AreTheSameEachTime) {
  const Sample a = SampleOf(Prism(60, "(0 0, 30 0, 30 20, 0 20)"));
  EXPECT_EQ(a.lines, LightningLines(a.stack, a.areas, a.roofs, {kRadius, 0}));
}

}  // namespace
}  // namespace slicefarm::planning::lightning_test
