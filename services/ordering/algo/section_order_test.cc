#include "services/ordering/algo/section_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/ordering_options.h"
#include "services/ordering/algo/comb/curl_avoidance.h"
#include "services/ordering/algo/route.h"

namespace slicefarm::ordering::section_order_test {
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

/// Returns a square island with two walls, four infill lines, a monotonic group of three lines and
/// one gap fill.
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

FilledSection Section() {
  FilledSection section{0, 3, 200'000, {}};
  for (const Coord x : {100, 0, 60, 30}) section.islands.push_back(Island(x, x / 10));
  return section;
}

std::vector<Path> PathsOf(const FilledSection& section) {
  std::vector<Path> paths;
  for (const FilledIsland& island : section.islands) {
    paths.insert(paths.end(), island.walls.begin(), island.walls.end());
    for (const FillGroup& group : island.fills) {
      paths.insert(paths.end(), group.paths.begin(), group.paths.end());
    }
  }
  return paths;
}

std::vector<Feature> FeaturesOf(const std::vector<Path>& paths) {
  std::vector<Feature> features;
  for (const Path& path : paths) {
    if (features.empty() || features.back() != path.feature) features.push_back(path.feature);
  }
  return features;
}

std::vector<Path> Order(FilledSection section, const OrderingOptions& options = {},
                        const SectionPlan& plan = {}) {
  WorkBudget budget{options.improvement_moves};
  return OrderSection(std::move(section), plan, options, budget).paths;
}

TEST(OrderSection, NothingIsNothing) {
  FilledSection section;
  section.islands.resize(2);
  EXPECT_TRUE(Order(section).empty());
}

TEST(OrderSection, IslandsAreVisitedAlongTheWay) {
  const std::vector<Path> ordered = Order(Section());
  std::vector<Coord> columns;
  for (const Path& path : ordered) {
    if (path.feature == Feature::kExternalPerimeter) {
      columns.push_back(path.points[0].x / (10 * kNmPerMm));
    }
  }
  EXPECT_TRUE(std::is_sorted(columns.begin(), columns.end()));
  EXPECT_EQ(columns.size(), 4);
}

TEST(OrderSection, NothingIsLostOrChangedButDirectionAndStart) {
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
    EXPECT_EQ(canonical(Order(Section(), options)), canonical(PathsOf(Section())));
  }
}

TEST(OrderSection, UnsupportedWallsFollowTheFills) {
  FilledSection section = Section();
  section.islands.resize(1);
  SectionPlan plan;
  plan.air = {{{Mm(90, 0), Mm(130, 0), Mm(130, 40), Mm(90, 40)}, {}}};
  OrderingOptions options;
  EXPECT_EQ(FeaturesOf(Order(section, options, plan))[0], Feature::kPerimeter);
  for (const bool infill_first : {false, true}) {
    options.infill_first = infill_first;
    options.walls[0].unsupported_last = true;
    const std::vector<Feature> features = FeaturesOf(Order(section, options, plan));
    ASSERT_GE(features.size(), 4u);
    EXPECT_EQ(features[features.size() - 2], Feature::kPerimeter);
    EXPECT_EQ(features.back(), Feature::kExternalPerimeter);
    section.islands[0].fills.clear();
    EXPECT_EQ(Order(section, options, plan).size(), 3u) << "nothing could hold them";
    section = Section();
    section.islands.resize(1);
  }
}

TEST(OrderSection, WallsThenFills) {
  FilledSection section = Section();
  section.islands.resize(1);
  OrderingOptions options;
  EXPECT_EQ(FeaturesOf(Order(section, options))[0], Feature::kPerimeter);
  EXPECT_EQ(FeaturesOf(Order(section, options))[1], Feature::kExternalPerimeter);
  options.walls[0].external_perimeters_first = true;
  EXPECT_EQ(FeaturesOf(Order(section, options))[0], Feature::kExternalPerimeter);
  EXPECT_EQ(FeaturesOf(Order(section, options))[1], Feature::kPerimeter);
}

TEST(OrderSection, InfillFirst) {
  FilledSection section = Section();
  section.islands.resize(1);
  OrderingOptions options;
  options.infill_first = true;
  EXPECT_THAT(FeaturesOf(Order(section, options)),
              ElementsAre(Feature::kInternalInfill, Feature::kTopSolidInfill, Feature::kPerimeter,
                          Feature::kExternalPerimeter, Feature::kGapFill));
}

TEST(OrderSection, LoopsRunTheWayThatIsAskedFor) {
  FilledSection section = Section();
  Path hole = Wall(8, 3, 4, 0);  // wall of the second island
  std::ranges::reverse(hole.points);
  section.islands[1].walls.push_back(hole);
  const auto turns = [&](bool clockwise) {
    OrderingOptions options;
    options.clockwise = clockwise;
    std::vector<int> count(2, 0);
    for (const Path& path : Order(section, options))
      if (path.closed) ++count[SignedArea(path.points) > 0 ? 0 : 1];
    return count;
  };
  EXPECT_THAT(turns(false), ElementsAre(8, 1));
  EXPECT_THAT(turns(true), ElementsAre(1, 8));
}

TEST(OrderSection, IroningComesLast) {
  for (const bool infill_first : {false, true}) {
    FilledSection section = Section();
    section.islands.resize(1);
    FillGroup ironing{.keep_order = true, .paths = {}};
    for (const double dy : {15.0, 15.1, 15.2})
      ironing.paths.push_back(Line(Feature::kIroning, Mm(102, 10 + dy), Mm(115, 10 + dy)));
    section.islands[0].fills.insert(section.islands[0].fills.begin(), ironing);
    OrderingOptions options;
    options.infill_first = infill_first;
    const std::vector<Path> ordered = Order(section, options);
    const std::vector<Feature> features = FeaturesOf(ordered);
    EXPECT_EQ(features.back(), Feature::kIroning);
    EXPECT_EQ(std::ranges::count(features, Feature::kIroning), 1);
    EXPECT_EQ(ordered.back().points, ironing.paths.back().points);
  }
}

TEST(OrderSection, MonotonicLinesStayTogetherAndInOrder) {
  const std::vector<Path> ordered = Order(Section());
  for (size_t i = 0; i + 2 < ordered.size(); ++i) {
    if (ordered[i].feature != Feature::kTopSolidInfill) continue;
    const auto y = [&](size_t k) { return ordered[k].points[0].y; };
    ASSERT_EQ(ordered[i + 2].feature, Feature::kTopSolidInfill);
    EXPECT_EQ(y(i + 1) - y(i), y(i + 2) - y(i + 1));
    i += 2;
  }
}

TEST(OrderSection, SeamsOfThePlanAreThoseOfTheRing) {
  FilledSection section;
  section.islands.push_back(Island(0, 0));
  section.islands[0].walls[0].ring = 1;
  EXPECT_EQ(Order(section, {}, {0, {}, {}, {Mm(0, 20), Mm(20, 20)}})[1].points[0], Mm(20, 20));
  EXPECT_EQ(Order(section, {}, {0, {}, {}, {}})[1].points[0], Mm(0, 0)) << "none: near the nozzle";
  EXPECT_EQ(Order(section, {}, {0, {}, {}, {Mm(0, 20)}})[1].points[0], Mm(0, 0)) << "no such ring";
}

TEST(OrderSection, WallsGoByTheirRegionsOrder) {
  FilledSection section;
  section.islands = {Island(0, 0), Island(30, 0)};
  for (Path& wall : section.islands[1].walls) wall.settings = 1;
  OrderingOptions options;
  options.walls = {{false, false}, {true, false}};
  std::vector<int32_t> insets;
  for (const Path& path : Order(section, options))
    if (path.closed) insets.push_back(path.inset);
  EXPECT_THAT(insets, ElementsAre(1, 0, 0, 1));
}

TEST(OrderSection, KeepsOffWhatHasCurledUp) {
  FilledSection section{0, 3, 200'000, {}};
  section.islands = {Island(0, 0), Island(60, 0)};
  for (FilledIsland& island : section.islands) island.outline.outer = island.walls[0].points;
  SectionPlan plan;
  plan.entry = Mm(0, 0);
  WorkBudget budget{100'000};
  const PathBlock straight = OrderSection(section, plan, {}, budget);
  plan.curled = MakePolygonsOrDie("(29.5 3, 30.5 3, 30.5 19, 29.5 19)");
  OrderingOptions avoids;
  avoids.travel.avoid_curled = true;
  const PathBlock round = OrderSection(section, plan, avoids, budget);
  EXPECT_EQ(round.paths, straight.paths);
  const CurlAvoidance routes(plan.curled, {});
  int met = 0;
  for (size_t i = 1; i < round.paths.size(); ++i) {
    const Point from = EndOf(round.paths[i - 1]), to = StartOf(round.paths[i]);
    met += routes.Meets(from, straight.travels[i].corners, to) ? 1 : 0;
    EXPECT_FALSE(routes.Meets(from, round.travels[i].corners, to)) << i;
  }
  EXPECT_EQ(met, 1);
}

TEST(OrderSection, OrderOfInputDoesNotMatter) {
  const std::vector<Path> want = Order(Section());
  std::mt19937 random(5);
  for (int i = 0; i < 10; ++i) {
    FilledSection shuffled = Section();
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

TEST(OrderSection, TravelIsNotLongerThanTheInputOrder) {
  const auto travel = [](const std::vector<Path>& paths) {
    double length = 0;
    for (size_t i = 0; i + 1 < paths.size(); ++i) {
      length += Distance(EndOf(paths[i]), StartOf(paths[i + 1]));
    }
    return length;
  };
  EXPECT_LT(travel(Order(Section())), 0.6 * travel(PathsOf(Section())));
}

}  // namespace
}  // namespace slicefarm::ordering::section_order_test
