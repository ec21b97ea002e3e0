#include "services/planning/algo/sequence/print_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "common/model/limits.h"

namespace slicefarm::planning::print_sequence_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Polygon Square(double x, double y, double size = 20) {
  return {{FromMm(x), FromMm(y)},
          {FromMm(x + size), FromMm(y)},
          {FromMm(x + size), FromMm(y + size)},
          {FromMm(x), FromMm(y + size)}};
}
SequenceItem Item(std::string name, double x, double y, double height_mm) {
  return {Square(x, y), FromMm(height_mm), std::move(name)};
}

/// Area that the head sweeps while an object is printed: the clearance disc moved along its hull,
/// and the gantry's bar moved over its range of y. It is computed with Clipper, unlike the
/// product's code.
struct Swept {
  MultiPolygon disc;
  MultiPolygon bar;
};

Swept SweptOver(const SequenceItem& item, const SequenceOptions& options) {
  const Polygon hull = ConvexHull(item.footprint);
  Swept swept;
  swept.disc = Offset({{hull, {}}}, options.clearance_radius_nm - 1'000,
                      {.join = Join::kRound, .arc_tolerance_nm = 100});
  const Coord far = FromMm(1'000), reach = options.gantry_reach_nm.value_or(far);
  const Box box = Bounds(hull);
  swept.bar = {{{{-far, box.min.y - reach},
                 {far, box.min.y - reach},
                 {far, box.max.y + reach},
                 {-far, box.max.y + reach}},
                {}}};
  return swept;
}

bool Meets(const MultiPolygon& swept, const SequenceItem& item) {
  return Area(Intersection(swept, {{ConvexHull(item.footprint), {}}})) > 1e6;
}

/// Returns meets[a][b]: true if the head hits the finished object a while it prints b.
std::vector<std::vector<bool>> AllMeetings(const std::vector<SequenceItem>& items,
                                           const SequenceOptions& options) {
  std::vector meets(items.size(), std::vector<bool>(items.size(), false));
  for (size_t b = 0; b < items.size(); ++b) {
    const Swept swept = SweptOver(items[b], options);
    for (size_t a = 0; a < items.size(); ++a)
      meets[a][b] =
          a != b &&
          (Meets(swept.disc, items[a]) ||
           (items[a].height_nm > options.clearance_height_nm && Meets(swept.bar, items[a])));
  }
  return meets;
}

bool IsGood(const std::vector<size_t>& order, const std::vector<std::vector<bool>>& meets) {
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t j = i + 1; j < order.size(); ++j)
      if (meets[order[i]][order[j]]) return false;
  return true;
}

bool AnyOrderIsGood(const std::vector<std::vector<bool>>& meets) {
  std::vector<size_t> order(meets.size());
  std::iota(order.begin(), order.end(), size_t{0});
  do {
    if (IsGood(order, meets)) return true;
  } while (std::next_permutation(order.begin(), order.end()));
  return false;
}

TEST(PrintSequence, PrintsTheTallOneLast) {
  const std::vector<SequenceItem> items = {Item("tall", 0, 0, 80), Item("far", 200, 0, 10),
                                           Item("near", 100, 0, 20)};
  EXPECT_THAT(*PrintSequence(items, {}), ElementsAre(1, 2, 0));
  EXPECT_THAT(*PrintSequence({}, {}), IsEmpty());
}

TEST(PrintSequence, GoesALittleWay) {
  const std::vector<SequenceItem> items = {Item("a", 150, 0, 9), Item("b", 0, 0, 9),
                                           Item("c", 50, 0, 9), Item("d", 100, 0, 9)};
  EXPECT_THAT(*PrintSequence(items, {}), ElementsAre(1, 2, 3, 0));
}

TEST(PrintSequence, NamesTwoThatStandTooNear) {
  const std::vector<SequenceItem> items = {Item("cup", 0, 0, 9), Item("lid", 200, 0, 9),
                                           Item("saucer", 39.9, 0, 9)};
  const absl::Status status = PrintSequence(items, {}).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  const ErrorDetail detail = DetailOf(status);
  EXPECT_EQ(detail.reason, Reason::kObjectsCollide);
  EXPECT_EQ(detail.metadata.at("first"), "cup");
  EXPECT_EQ(detail.metadata.at("second"), "saucer");
  EXPECT_EQ(detail.metadata.at("rule"), "clearance");
}

TEST(PrintSequence, AcceptsWhatStandsExactlyFarEnough) {
  EXPECT_TRUE(PrintSequence(std::vector{Item("a", 0, 0, 9), Item("b", 40, 0, 9)}, {}).ok());
  const SequenceOptions none = {.clearance_radius_nm = 0};
  EXPECT_TRUE(PrintSequence(std::vector{Item("a", 0, 0, 9), Item("b", 20, 0, 9)}, none).ok());
  EXPECT_FALSE(PrintSequence(std::vector{Item("a", 0, 0, 9), Item("b", 19, 0, 9)}, none).ok());
}

TEST(PrintSequence, NamesTwoTallOnesUnlessTheGantryPassesBetween) {
  const std::vector<SequenceItem> items = {Item("a", 0, 0, 80), Item("b", 0, 100, 90)};
  const ErrorDetail detail = DetailOf(PrintSequence(items, {}).status());
  EXPECT_EQ(detail.reason, Reason::kObjectsCollide);
  EXPECT_EQ(detail.metadata.at("rule"), "gantry");
  EXPECT_TRUE(PrintSequence(items, {.gantry_reach_nm = FromMm(80)}).ok());
  EXPECT_FALSE(PrintSequence(items, {.gantry_reach_nm = FromMm(80.1)}).ok());
}

TEST(PrintSequence, OnlyTheLastOneReachesTheLid) {
  const SequenceOptions options = {.gantry_reach_nm = 0, .lid_height_nm = FromMm(100)};
  const std::vector<SequenceItem> items = {Item("tower", 0, 0, 120), Item("a", 0, 100, 90),
                                           Item("b", 0, 200, 90)};
  EXPECT_EQ(PrintSequence(items, options)->back(), 0u);
  std::vector<SequenceItem> two = items;
  two[2].height_nm = FromMm(101);
  EXPECT_EQ(DetailOf(PrintSequence(two, options).status()).metadata.at("rule"), "lid");
}

TEST(PrintSequence, TheHeadPassesOverWhatIsLowerThanTheNozzle) {
  const SequenceOptions options = {.nozzle_height_nm = FromMm(4)};
  const auto rule = [&](double gap_mm, double first_mm, double second_mm) -> std::string {
    const std::vector<SequenceItem> items = {Item("a", 0, 0, first_mm),
                                             Item("b", 20 + gap_mm, 0, second_mm)};
    const auto order = PrintSequence(items, options);
    return order.ok() ? std::to_string(order->front())
                      : DetailOf(order.status()).metadata.at("rule");
  };
  EXPECT_EQ(rule(5, 4, 4), "0");
  EXPECT_EQ(rule(5, 9, 4), "1") << "the low one first";
  EXPECT_EQ(rule(5, 9, 9), "clearance");
  EXPECT_EQ(rule(1.9, 4, 4), "clearance") << "the nozzle itself";
}

TEST(PrintSequence, RefusesWhatCannotBe) {
  const auto reason = [](const std::vector<SequenceItem>& items, const SequenceOptions& options) {
    return DetailOf(PrintSequence(items, options).status()).reason;
  };
  EXPECT_EQ(reason({{{}, 1, "x"}}, {}), Reason::kRequestMalformed);
  EXPECT_EQ(reason({{Square(0, 0), -1, "x"}}, {}), Reason::kRequestMalformed);
  EXPECT_EQ(reason({{{{INT64_MAX, 0}}, 1, "x"}}, {}), Reason::kOutOfRange);
  EXPECT_EQ(reason({}, {.clearance_radius_nm = -1}), Reason::kSettingOutOfRange);
  EXPECT_EQ(reason({}, {.clearance_height_nm = -1}), Reason::kSettingOutOfRange);
  EXPECT_EQ(reason({}, {.gantry_reach_nm = -1}), Reason::kSettingOutOfRange);
  EXPECT_EQ(reason(std::vector<SequenceItem>(limits::kMaxObjects + 1), {}),
            Reason::kRequestTooLarge);
}

std::vector<SequenceItem> RandomPlate(std::mt19937& random) {
  std::vector<SequenceItem> items;
  const size_t count = 1 + random() % 7;
  for (size_t i = 0; i < count; ++i) {
    std::vector<Point> cloud;
    for (int k = 0; k < 8; ++k)
      cloud.push_back(
          {static_cast<Coord>(random() % 40'000'000), static_cast<Coord>(random() % 40'000'000)});
    const Point at = {static_cast<Coord>(random() % 260'000'000),
                      static_cast<Coord>(random() % 260'000'000)};
    items.push_back({Moved(ConvexHull(cloud), at), FromMm(random() % 5 == 0 ? 60 : random() % 21),
                     std::to_string(i)});
  }
  return items;
}

TEST(PrintSequence, FindsAnOrderExactlyIfThereIsOne) {
  std::mt19937 random(3);
  int found = 0;
  for (int round = 0; round < 1000; ++round) {
    SCOPED_TRACE(round);
    const std::vector<SequenceItem> items = RandomPlate(random);
    SequenceOptions options = {.clearance_radius_nm = FromMm(random() % 30)};
    if (random() % 2 == 0) options.gantry_reach_nm = FromMm(random() % 40);
    const auto meets = AllMeetings(items, options);
    const absl::StatusOr<std::vector<size_t>> order = PrintSequence(items, options);
    ASSERT_EQ(order.ok(), AnyOrderIsGood(meets)) << order.status();
    if (!order.ok()) {
      const ErrorDetail detail = DetailOf(order.status());
      const size_t a = std::stoul(detail.metadata.at("first_index"));
      const size_t b = std::stoul(detail.metadata.at("second_index"));
      EXPECT_TRUE(meets[a][b] && meets[b][a]);
      continue;
    }
    ++found;
    std::vector<size_t> sorted = *order, all(items.size());
    std::sort(sorted.begin(), sorted.end());
    std::iota(all.begin(), all.end(), size_t{0});
    EXPECT_EQ(sorted, all);
    EXPECT_TRUE(IsGood(*order, meets));
  }
  EXPECT_GT(found, 200);
  EXPECT_LT(found, 800);
}

TEST(PrintSequence, DoesNotDependOnTheOrderOfTheInput) {
  std::mt19937 random(5);
  std::vector<SequenceItem> items;
  for (int i = 0; i < 40; ++i)
    items.push_back(Item(std::to_string(i), 1.0 * (random() % 900), 50.0 * i, 9));
  const auto names = [&] {
    std::vector<std::string> result;
    const std::vector<size_t> order = *PrintSequence(items, {});
    for (const size_t i : order) result.push_back(items[i].name);
    return result;
  };
  const std::vector<std::string> before = names();
  std::shuffle(items.begin(), items.end(), random);
  EXPECT_EQ(names(), before);
}

TEST(PrintSequence, OrdersAThousand) {
  std::mt19937 random(6);
  std::vector<SequenceItem> items;
  for (int i = 0; i < 1000; ++i)
    items.push_back({Square(45 * (i % 40), 45 * (i / 40)), FromMm(10), ""});
  std::shuffle(items.begin(), items.end(), random);
  const std::vector<size_t> order = *PrintSequence(items, {});
  double path = 0;
  for (size_t i = 0; i + 1 < order.size(); ++i)
    path += Distance(items[order[i]].footprint[0], items[order[i + 1]].footprint[0]);
  EXPECT_LT(path, 1.1 * 999 * FromMm(45)) << "at best each goes to a neighbour";
}

}  // namespace
}  // namespace slicefarm::planning::print_sequence_test
