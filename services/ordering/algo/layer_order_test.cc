#include "services/ordering/algo/layer_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/geometry/text_format.h"
#include "common/base/error.h"
#include "services/ordering/algo/route.h"

namespace slicefarm::ordering {
namespace {

using ::testing::ElementsAre;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

Path Wall(Coord x, Coord y, Coord size, int32_t inset) {
  const Coord d = inset * 450'000;
  const Point low{x * kNmPerMm + d, y * kNmPerMm + d};
  const Point high{(x + size) * kNmPerMm - d, (y + size) * kNmPerMm - d};
  Path path;
  path.feature = inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter;
  path.inset = inset;
  path.closed = true;
  path.points = {low, {high.x, low.y}, high, {low.x, high.y}};
  path.widths_nm = {450'000};
  return path;
}

Path Line(Feature feature, Point from, Point to) {
  Path path;
  path.feature = feature;
  path.points = {from, to};
  path.widths_nm = {450'000};
  return path;
}

/// A square island with two walls, four infill lines, a monotonic group of three lines and a gap
/// fill.
FilledIsland Island(Coord x, Coord y) {
  FilledIsland island;
  island.walls = {Wall(x, y, 20, 0), Wall(x, y, 20, 1)};
  const auto at = [&](double dx, double dy) {
    return Mm(static_cast<double>(x) + dx, static_cast<double>(y) + dy);
  };
  island.walls.push_back(Line(Feature::kGapFill, at(18, 5), at(18, 6)));
  FillGroup lines;
  for (const double dy : {2.0, 5.0, 8.0, 11.0}) {
    lines.paths.push_back(Line(Feature::kInternalInfill, at(2, dy), at(15, dy)));
  }
  FillGroup skin{.keep_order = true, .paths = {}};
  for (const double dy : {15.0, 15.5, 16.0}) {
    skin.paths.push_back(Line(Feature::kTopSolidInfill, at(2, dy), at(15, dy)));
  }
  island.fills = {lines, skin};
  return island;
}

FilledLayer Layer() {
  FilledLayer layer;
  layer.frame = {3, 800'000, 200'000};
  for (const Coord x : {100, 0, 60, 30}) layer.islands.push_back(Island(x, x / 10));
  return layer;
}

std::vector<Path> PathsOf(const FilledLayer& layer) {
  std::vector<Path> paths;
  for (const FilledIsland& island : layer.islands) {
    paths.insert(paths.end(), island.walls.begin(), island.walls.end());
    for (const FillGroup& group : island.fills) {
      paths.insert(paths.end(), group.paths.begin(), group.paths.end());
    }
  }
  return paths;
}

std::vector<Feature> FeaturesOf(const OrderedLayer& layer) {
  std::vector<Feature> features;
  for (const Path& path : layer.paths) {
    if (features.empty() || features.back() != path.feature) features.push_back(path.feature);
  }
  return features;
}

OrderedLayer Order(FilledLayer layer, const OrderingOptions& options = {},
                   const LayerPlan& plan = {}) {
  auto ordered = OrderLayer(std::move(layer), plan, options);
  EXPECT_TRUE(ordered.ok()) << ordered.status();
  return *std::move(ordered);
}

TEST(OrderLayer, EmptyLayer) {
  FilledLayer layer;
  layer.frame = {7, 1'600'000, 200'000};
  layer.islands.resize(2);
  const OrderedLayer ordered = Order(layer);
  EXPECT_EQ(ordered.frame, layer.frame);
  EXPECT_TRUE(ordered.paths.empty());
}

TEST(OrderLayer, IslandsAreVisitedAlongTheWay) {
  const OrderedLayer ordered = Order(Layer());
  std::vector<Coord> columns;
  for (const Path& path : ordered.paths) {
    if (path.feature == Feature::kExternalPerimeter) {
      columns.push_back(path.points[0].x / (10 * kNmPerMm));
    }
  }
  EXPECT_TRUE(std::is_sorted(columns.begin(), columns.end()));
  EXPECT_EQ(columns.size(), 4);
}

TEST(OrderLayer, NothingIsLostOrChangedButDirectionAndStart) {
  const auto canonical = [](std::vector<Path> paths) {
    for (Path& path : paths) {
      std::vector<Point>& points = path.points;
      if (path.closed) {
        std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
      } else if (points.back() < points.front()) {
        std::reverse(points.begin(), points.end());
      }
    }
    std::sort(paths.begin(), paths.end(), [](const Path& a, const Path& b) {
      return std::tie(a.points, a.feature) < std::tie(b.points, b.feature);
    });
    return paths;
  };
  for (const bool infill_first : {false, true}) {
    OrderingOptions options;
    options.infill_first = infill_first;
    EXPECT_EQ(canonical(Order(Layer(), options).paths), canonical(PathsOf(Layer())));
  }
}

TEST(OrderLayer, WallsThenFills) {
  FilledLayer layer = Layer();
  layer.islands.resize(1);
  OrderingOptions options;
  EXPECT_EQ(FeaturesOf(Order(layer, options))[0], Feature::kPerimeter);
  EXPECT_EQ(FeaturesOf(Order(layer, options))[1], Feature::kExternalPerimeter);
  options.external_perimeters_first = true;
  EXPECT_EQ(FeaturesOf(Order(layer, options))[0], Feature::kExternalPerimeter);
  EXPECT_EQ(FeaturesOf(Order(layer, options))[1], Feature::kPerimeter);
}

TEST(OrderLayer, InfillFirst) {
  FilledLayer layer = Layer();
  layer.islands.resize(1);
  OrderingOptions options;
  options.infill_first = true;
  EXPECT_THAT(FeaturesOf(Order(layer, options)),
              ElementsAre(Feature::kInternalInfill, Feature::kTopSolidInfill, Feature::kPerimeter,
                          Feature::kExternalPerimeter, Feature::kGapFill));
}

TEST(OrderLayer, MonotonicLinesStayTogetherAndInOrder) {
  const OrderedLayer ordered = Order(Layer());
  for (size_t i = 0; i + 2 < ordered.paths.size(); ++i) {
    if (ordered.paths[i].feature != Feature::kTopSolidInfill) continue;
    const auto y = [&](size_t k) { return ordered.paths[k].points[0].y; };
    ASSERT_EQ(ordered.paths[i + 2].feature, Feature::kTopSolidInfill);
    EXPECT_EQ(y(i + 1) - y(i), y(i + 2) - y(i + 1));
    i += 2;
  }
}

TEST(OrderLayer, SeamsOfThePlanAreUsedUnlessNearest) {
  const LayerPlan plan{{}, {Mm(20, 20)}};
  FilledLayer layer;
  layer.islands.push_back(Island(0, 0));
  for (const SeamPosition seam : {SeamPosition::kAligned, SeamPosition::kRear}) {
    OrderingOptions options;
    options.seam = seam;
    EXPECT_EQ(Order(layer, options, plan).paths[1].points[0], Mm(20, 20));
  }
  OrderingOptions nearest;
  nearest.seam = SeamPosition::kNearest;
  EXPECT_EQ(Order(layer, nearest, plan).paths[1].points[0], Mm(0, 0));
}

TEST(OrderLayer, OrderOfInputDoesNotMatter) {
  const OrderedLayer want = Order(Layer());
  std::mt19937 random(5);
  for (int i = 0; i < 10; ++i) {
    FilledLayer shuffled = Layer();
    std::shuffle(shuffled.islands.begin(), shuffled.islands.end(), random);
    for (FilledIsland& island : shuffled.islands) {
      std::shuffle(island.walls.begin(), island.walls.end(), random);
      std::shuffle(island.fills.begin(), island.fills.end(), random);
      for (FillGroup& group : island.fills) {
        if (!group.keep_order) std::shuffle(group.paths.begin(), group.paths.end(), random);
      }
    }
    EXPECT_EQ(Order(shuffled), want);
  }
}

TEST(OrderLayer, TravelIsNotLongerThanTheInputOrder) {
  const auto travel = [](const std::vector<Path>& paths) {
    double length = 0;
    for (size_t i = 0; i + 1 < paths.size(); ++i) {
      length += Distance(EndOf(paths[i]), StartOf(paths[i + 1]));
    }
    return length;
  };
  EXPECT_LT(travel(Order(Layer()).paths), 0.6 * travel(PathsOf(Layer())));
}

TEST(OrderLayer, RefusesBrokenPaths) {
  for (const bool short_path : {false, true}) {
    FilledLayer layer = Layer();
    Path& path = layer.islands[1].fills[1].paths[2];
    if (short_path) {
      path.points.resize(1);
    } else {
      path.widths_nm.resize(3, 450'000);
    }
    const auto ordered = OrderLayer(layer, {}, {});
    ASSERT_FALSE(ordered.ok());
    EXPECT_EQ(DetailOf(ordered.status()).reason, Reason::kRequestMalformed);
    EXPECT_EQ(DetailOf(ordered.status()).metadata.at("layer"), "3");
  }
}

}  // namespace
}  // namespace slicefarm::ordering
