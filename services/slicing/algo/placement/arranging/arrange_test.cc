#include "services/slicing/algo/placement/arranging/arrange.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/text_format_test.h"
#include "common/model/limits.h"

namespace slicefarm::slicing::arrange_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Polygon Rectangle(double width, double height) {
  return {{0, 0}, {FromMm(width), 0}, {FromMm(width), FromMm(height)}, {0, FromMm(height)}};
}
Polygon Round(double radius, int corners) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back({FromMm(radius * std::cos(angle)), FromMm(radius * std::sin(angle))});
  }
  return ring;
}
Polygon Bracket() { return MakeLineOrDie("(0 0, 60 0, 60 15, 15 15, 15 60, 0 60)"); }

ArrangeOptions OnBed(Polygon bed = Rectangle(250, 210)) { return {.bed = std::move(bed)}; }
std::vector<ArrangeItem> Copies(const Polygon& footprint, size_t count) {
  return std::vector<ArrangeItem>(count, ArrangeItem{.footprint = footprint});
}

Arrangement ArrangeOrDie(const std::vector<ArrangeItem>& items, const ArrangeOptions& options,
                         const std::vector<FixedFootprint>& fixed = {}) {
  absl::StatusOr<Arrangement> arrangement = Arrange(items, fixed, options, {});
  EXPECT_TRUE(arrangement.ok()) << arrangement.status();
  return *std::move(arrangement);
}

Polygon Turned(Polygon ring, double deg) {
  const double a = deg * std::numbers::pi / 180, s = std::sin(a), c = std::cos(a);
  for (Point& p : ring) p = {std::llround(c * p.x - s * p.y), std::llround(s * p.x + c * p.y)};
  return ring;
}

/// Returns the distance of two outlines by testing each edge against each; 0 if they overlap.
double OutlineDistance(const Polygon& a, const Polygon& b) {
  double least = 1e300;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Point p : *from)
      for (size_t i = 0; i < to->size(); ++i)
        least = std::min(least, DistanceToSegment(p, (*to)[i], (*to)[(i + 1) % to->size()]));
  if (a.size() < 3 || b.size() < 3) return least;
  const Polygon ring_a[] = {a}, ring_b[] = {b};
  return Area(Intersection(Union(ring_a, FillRule::kNonZero), Union(ring_b, FillRule::kNonZero))) >
                 0
             ? 0
             : least;
}

struct Standing {
  Polygon outline;
  int plate;
};

/// Checks all guarantees of a packing, by other methods than the packing uses.
void ExpectSound(const std::vector<ArrangeItem>& items, const ArrangeOptions& options,
                 const Arrangement& result, const std::vector<FixedFootprint>& fixed = {}) {
  ASSERT_EQ(result.places.size(), items.size());
  std::vector<Standing> standing;
  for (const FixedFootprint& part : fixed) standing.push_back({part.footprint, part.plate});
  std::vector<size_t> left_over;
  const Polygon bed = ConvexHull(options.bed);
  for (size_t i = 0; i < items.size(); ++i) {
    if (!result.places[i]) {
      left_over.push_back(i);
      continue;
    }
    const auto& [plate, at, deg] = *result.places[i];
    EXPECT_TRUE(plate >= 0 && plate < result.plates);
    EXPECT_TRUE(at.x % 1000 == 0 && at.y % 1000 == 0);
    Polygon outline = Moved(deg == 0 ? items[i].footprint : Turned(items[i].footprint, deg), at);
    for (const Point p : outline)
      for (size_t k = 0; k < bed.size(); ++k) {
        const Point a = bed[k], b = bed[(k + 1) % bed.size()];
        EXPECT_GE(Cross(b - a, p - a) / Distance(a, b), options.bed_margin_nm - 2.0);
      }
    for (const Standing& other : standing) {
      if (other.plate != plate ||
          !Bounds(other.outline).Grown(options.distance_nm).Intersects(Bounds(outline)))
        continue;
      EXPECT_GE(OutlineDistance(outline, other.outline), options.distance_nm - 2.0)
          << ToText(outline) << ToText(other.outline);
    }
    standing.push_back({std::move(outline), plate});
  }
  EXPECT_EQ(result.left_over, left_over);
}

/// Returns the positions of the footprints, regardless of the numbering of equal items.
std::vector<std::tuple<int, Point, double, Polygon>> PlacesOf(const std::vector<ArrangeItem>& items,
                                                              const Arrangement& result) {
  std::vector<std::tuple<int, Point, double, Polygon>> places;
  for (size_t i = 0; i < items.size(); ++i)
    if (const auto& p = result.places[i])
      places.push_back({p->plate, p->translation, p->rotation_deg, items[i].footprint});
  std::sort(places.begin(), places.end());
  return places;
}

Box BoxOfAll(const std::vector<ArrangeItem>& items, const Arrangement& result) {
  Box box;
  for (size_t i = 0; i < items.size(); ++i)
    box.Add(Bounds(Moved(items[i].footprint, result.places[i]->translation)));
  return box;
}

TEST(Arrange, PutsOnePartInTheMiddle) {
  const Arrangement one = ArrangeOrDie(Copies(Rectangle(30, 20), 1), OnBed());
  EXPECT_EQ(one.plates, 1);
  EXPECT_THAT(one.places, ElementsAre(ItemPosition{0, {FromMm(110), FromMm(95)}, 0}));
}

/// Returns the excluded areas of real printer profiles.
std::vector<std::vector<Polygon>> ExcludedAreas() {
  const Polygon cutter = MakeLineOrDie("(0 0, 18 0, 18 28, 0 28)");
  const Polygon frame =
      MakeLineOrDie("(0 0, 255 0, 255 255, 0 255, 0 0, 2 2, 2 253, 253 253, 253 2, 2 2)");
  return {{cutter},
          {cutter, MakeLineOrDie("(246 0, 256 0, 256 20, 246 20)")},
          {MakeLineOrDie("(100 90, 160 100, 150 150, 110 160)")},
          {frame}};
}

TEST(Arrange, KeepsOutOfExcludedAreas) {
  for (const std::vector<Polygon>& excluded : ExcludedAreas()) {
    ArrangeOptions options = OnBed(Rectangle(256, 256));
    options.excluded = excluded;
    const MultiPolygon areas = Union(excluded, FillRule::kNonZero);
    for (const auto& items :
         {Copies(Rectangle(20, 20), 80), Copies(Rectangle(110, 60), 3), Copies(Bracket(), 7)}) {
      const Arrangement result = ArrangeOrDie(items, options);
      ExpectSound(items, options, result);
      EXPECT_THAT(result.left_over, IsEmpty());
      for (size_t i = 0; i < items.size(); ++i) {
        const Polygon part = Moved(items[i].footprint, result.places[i]->translation);
        EXPECT_TRUE(Intersection({{part, {}}}, areas).empty()) << i;
      }
    }
  }
}

TEST(Arrange, LeavesOutWhatOnlyAnExcludedAreaHasRoomFor) {
  ArrangeOptions options = OnBed(Rectangle(256, 256));
  options.excluded = ExcludedAreas().front();
  const Arrangement result = ArrangeOrDie(Copies(Rectangle(250, 250), 1), options);
  EXPECT_THAT(result.left_over, ElementsAre(0u));
  options.bed_margin_nm = FromMm(2);
  const Arrangement apart = ArrangeOrDie(Copies(Rectangle(234, 250), 1), options);
  ASSERT_THAT(apart.left_over, IsEmpty());
  EXPECT_GE(apart.places[0]->translation.x, FromMm(20) - 1);
}

TEST(Arrange, PutsEqualPartsInAGridAroundTheMiddle) {
  const auto items = Copies(Rectangle(60, 31), 12);  // twelve benchies
  const Arrangement grid = ArrangeOrDie(items, OnBed());
  ExpectSound(items, OnBed(), grid);
  EXPECT_EQ(grid.plates, 1);
  const Box box = BoxOfAll(items, grid);
  EXPECT_EQ(box.min + box.max, (Point{FromMm(250), FromMm(210)}));
  EXPECT_EQ(box.max - box.min, (Point{FromMm(3 * 66 - 6), FromMm(4 * 37 - 6)}));
}

TEST(Arrange, FillsPlatesAsFullAsAGrid) {
  const auto items = Copies(Rectangle(30, 20), 100);
  const Arrangement full = ArrangeOrDie(items, OnBed());
  ExpectSound(items, OnBed(), full);
  EXPECT_EQ(full.plates, 2) << "56 fit on a plate";
}

TEST(Arrange, NestsBrackets) {
  const auto items = Copies(Bracket(), 12);
  const Arrangement nested = ArrangeOrDie(items, OnBed());
  ExpectSound(items, OnBed(), nested);
  EXPECT_EQ(nested.plates, 1) << "a grid of their boxes holds 9";
}

TEST(Arrange, PacksDiscsDenserThanAGrid) {
  const auto items = Copies(Round(10, 72), 80);
  const Arrangement discs = ArrangeOrDie(items, OnBed());
  ExpectSound(items, OnBed(), discs);
  EXPECT_EQ(discs.plates, 1) << "a grid holds 72";
}

TEST(Arrange, CentersMixedPartsOnRoundBeds) {
  const std::vector<ArrangeItem> items = {{.footprint = Rectangle(70, 20)},
                                          {.footprint = Bracket()},
                                          {.footprint = Round(15, 40)},
                                          {.footprint = Rectangle(10, 40)}};
  const ArrangeOptions options = OnBed(Round(125, 72));
  const Arrangement result = ArrangeOrDie(items, options);
  ExpectSound(items, options, result);
  EXPECT_EQ(result.plates, 1);
  const Box box = BoxOfAll(items, result);
  EXPECT_LE(Norm(box.min + box.max), 4'000);
  EXPECT_LE(Norm(box.max - box.min), FromMm(190));
}

TEST(Arrange, UsesRotationsThatAreAllowed) {
  const std::vector<ArrangeItem> items = {{Rectangle(10, 230), {0, 45, 90}}};
  const Arrangement result = ArrangeOrDie(items, OnBed());
  ExpectSound(items, OnBed(), result);
  EXPECT_THAT(result.left_over, IsEmpty());
  EXPECT_NE(result.places[0]->rotation_deg, 0);
}

TEST(Arrange, PacksAroundFixedParts) {
  const std::vector<FixedFootprint> fixed = {{Rectangle(250, 100), 0},
                                             {Moved(Bracket(), {FromMm(20), FromMm(20)}), 1}};
  const auto items = Copies(Rectangle(60, 31), 16);
  const Arrangement result = ArrangeOrDie(items, OnBed(), fixed);
  ExpectSound(items, OnBed(), result, fixed);
  EXPECT_EQ(result.plates, 2);
}

TEST(Arrange, ListsEachPartWithoutAPlace) {
  std::vector<ArrangeItem> items = Copies(Rectangle(100, 100), 6);
  items[3].footprint = Rectangle(251, 10);
  ArrangeOptions options = OnBed();
  options.max_plates = 1;
  const Arrangement result = ArrangeOrDie(items, options);
  ExpectSound(items, options, result);
  EXPECT_THAT(result.left_over, ElementsAre(3, 5));
  options.max_plates = 0;
  EXPECT_THAT(ArrangeOrDie(items, options).left_over, ElementsAre(3));
  EXPECT_TRUE(ArrangeOrDie({}, options).left_over.empty());
}

TEST(Arrange, TakesFootprintsWithoutArea) {
  const std::vector<ArrangeItem> items = {{.footprint = {{5, 5}}},
                                          {.footprint = {{0, 0}, {FromMm(30), 0}}},
                                          {.footprint = Polygon(4, Point{0, 0})},
                                          {.footprint = MakeLineOrDie("(0 0, 9 9, 9 0, 0 9)")},
                                          {.footprint = MakeLineOrDie("(0 0, 9 0, 4 0)")}};
  const Arrangement result = ArrangeOrDie(items, OnBed());
  ExpectSound(items, OnBed(), result);
  EXPECT_EQ(result.plates, 1);
  EXPECT_THAT(result.left_over, IsEmpty());
}

TEST(Arrange, LeavesAllOverWhereTheMarginTakesTheBed) {
  ArrangeOptions options = OnBed();
  options.bed_margin_nm = FromMm(105);
  EXPECT_THAT(ArrangeOrDie(Copies(Rectangle(1, 1), 2), options).left_over, ElementsAre(0, 1));
  options.bed_margin_nm = FromMm(100);
  EXPECT_THAT(ArrangeOrDie(Copies(Rectangle(1, 1), 2), options).left_over, IsEmpty());
}

TEST(Arrange, TakesUnlimitedBeds) {
  const auto items = Copies(Rectangle(100, 100), 50);
  EXPECT_EQ(ArrangeOrDie(items, OnBed({})).plates, 1);
}

TEST(Arrange, RefusesWhatCannotBe) {
  const auto refused = [](const std::vector<ArrangeItem>& items, const ArrangeOptions& options,
                          const std::vector<FixedFootprint>& fixed = {}) {
    const absl::Status status = Arrange(items, fixed, options, {}).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    return DetailOf(status);
  };
  const ArrangeItem good = {.footprint = Rectangle(9, 9)};
  const ErrorDetail empty = refused({good, {}}, OnBed());
  EXPECT_EQ(empty.reason, Reason::kRequestMalformed);
  EXPECT_EQ(empty.metadata.at("item"), "1");
  EXPECT_EQ(refused({{Rectangle(9, 9), {}}}, OnBed()).reason, Reason::kRequestMalformed);
  EXPECT_EQ(refused({{Rectangle(9, 9), {NAN}}}, OnBed()).reason, Reason::kRequestMalformed);
  EXPECT_EQ(refused({{.footprint = {{INT64_MIN + 1, 0}}}}, OnBed()).reason, Reason::kOutOfRange);
  EXPECT_EQ(refused({good}, OnBed(Bracket())).metadata.at("setting"), "bed_shape");
  EXPECT_EQ(refused({good}, OnBed(Polygon(3, Point{1, 1}))).reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(refused({good}, {.bed = {}, .distance_nm = -1}).metadata.at("setting"), "distance");
  EXPECT_EQ(refused({good}, {.bed = {}, .bed_margin_nm = -1}).metadata.at("setting"), "bed_margin");
  EXPECT_EQ(refused({good}, {.bed = {}, .max_plates = -1}).metadata.at("setting"), "max_plates");
  EXPECT_EQ(refused({good}, OnBed(), {{Rectangle(1, 1), -1}}).reason, Reason::kRequestMalformed);
  EXPECT_EQ(refused({good}, OnBed(), {{{}, 0}}).reason, Reason::kRequestMalformed);
  EXPECT_EQ(refused(Copies(Rectangle(1, 1), limits::kMaxObjects + 1), OnBed()).reason,
            Reason::kRequestTooLarge);
}

TEST(Arrange, CanBeCancelled) {
  const CancelToken cancelled([] { return true; });
  EXPECT_EQ(Arrange(Copies(Bracket(), 90), {}, OnBed(), cancelled).status().code(),
            absl::StatusCode::kCancelled);
}

TEST(Arrange, TakesAThousandPartsOnManyPlates) {
  std::mt19937 random(1);
  std::vector<ArrangeItem> items;
  for (int i = 0; i < 1000; ++i)
    items.push_back({.footprint = Rectangle(10 + random() % 20, 10 + random() % 20)});
  const Arrangement result = ArrangeOrDie(items, OnBed());
  ExpectSound(items, OnBed(), result);
  EXPECT_THAT(result.left_over, IsEmpty());
  EXPECT_LE(result.plates, 14) << "libnest2d needs 15";
}

Polygon RandomFootprint(std::mt19937& random) {
  const auto coordinate = [&] { return static_cast<Coord>(random() % 80'000'000) - 20'000'000; };
  Polygon ring;
  switch (random() % 4) {
    case 0:  // round, but for dents
      ring = Round(5 + random() % 30, 3 + random() % 14);
      for (Point& p : ring)
        if (random() % 3 == 0) p = {p.x / 2, p.y / 2};
      return ring;
    case 1:
      return Rectangle(1 + random() % 90, 1 + random() % 90);
    case 2:
      for (int i = 0; i < 12; ++i) ring.push_back({coordinate(), coordinate()});
      return ConvexHull(ring);
    default:  // crosses itself as a rule
      for (size_t i = 0; i < 3 + random() % 6; ++i) ring.push_back({coordinate(), coordinate()});
      return ring;
  }
}

TEST(Arrange, KeepsItsPromisesOnAThousandRandomPlates) {
  std::mt19937 random(7);
  for (int round = 0; round < 1000; ++round) {
    SCOPED_TRACE(round);
    std::vector<ArrangeItem> items;
    while (items.size() < 1 + random() % 7) {
      const ArrangeItem item = {.footprint = RandomFootprint(random)};
      items.insert(items.end(), 1 + random() % 3, item);
    }
    ArrangeOptions options = OnBed(round % 3 == 0 ? Round(110, 60) : Rectangle(200, 180));
    options.distance_nm = random() % 4 == 0 ? 0 : random() % 20'000'000;
    options.bed_margin_nm = random() % 2 == 0 ? 0 : random() % 9'000'000;
    options.max_plates = static_cast<int>(random() % 3);
    std::vector<FixedFootprint> fixed;
    if (random() % 3 == 0)
      fixed.push_back({Moved(RandomFootprint(random), {FromMm(30), FromMm(40)}), 0});

    const Arrangement result = ArrangeOrDie(items, options, fixed);
    ExpectSound(items, options, result, fixed);
    if (HasFailure()) return;
    if (round % 10 != 0) continue;
    std::vector<ArrangeItem> shuffled = items;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    EXPECT_EQ(PlacesOf(items, result), PlacesOf(shuffled, ArrangeOrDie(shuffled, options, fixed)));
  }
}

}  // namespace
}  // namespace slicefarm::slicing::arrange_test
