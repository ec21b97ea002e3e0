#include "services/ordering/algo/layer_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/ordering_options.h"
#include "common/model/paths_test.h"

namespace slicefarm::ordering::layer_order_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

FilledSection SectionOf(Stack stack, std::string_view wall) {
  FilledIsland island;
  island.walls = {MakePathOrDie(wall, /*closed=*/true)};
  return {stack, 3, 200'000, {island}};
}

FilledLayer LayerOf(std::vector<FilledSection> sections) {
  return {{3, 800'000, 200'000}, std::move(sections)};
}

constexpr std::string_view kSquare = "(-5 -5, 5 -5, 5 5, -5 5)";

OrderedLayer Order(FilledLayer layer, const std::vector<Copy>& copies, const LayerPlan& plan = {}) {
  auto ordered = OrderLayer(std::move(layer), plan, copies, {});
  EXPECT_TRUE(ordered.ok()) << ordered.status();
  return *std::move(ordered);
}

std::vector<int32_t> CopiesOf(const OrderedLayer& layer) {
  std::vector<int32_t> copies;
  for (const BlockVisit& visit : layer.visits) copies.push_back(visit.copy);
  return copies;
}

TEST(OrderLayer, EmptyLayer) {
  const OrderedLayer ordered = Order(LayerOf({{0, 3, 200'000, {}}}), {{0, {}, 0}});
  EXPECT_EQ(ordered.frame, (LayerFrame{3, 800'000, 200'000}));
  EXPECT_THAT(ordered.blocks, IsEmpty());
  EXPECT_THAT(ordered.visits, IsEmpty());
}

TEST(OrderLayer, CopiesAreOneBlockAndAreVisitedAlongTheWay) {
  const std::vector<Copy> copies = {
      {0, Mm(90, 0), 0}, {0, Mm(30, 0), 0}, {0, Mm(120, 0), 0}, {0, Mm(60, 0), 0}};
  LayerPlan plan;
  plan.entry = Mm(0, 0);
  const OrderedLayer ordered = Order(LayerOf({SectionOf(0, kSquare)}), copies, plan);
  ASSERT_THAT(ordered.blocks, SizeIs(1));
  EXPECT_THAT(CopiesOf(ordered), ElementsAre(1, 3, 0, 2));
  EXPECT_EQ(ordered.visits[0].shift, Mm(30, 0));
  plan.entry = Mm(200, 0);
  EXPECT_THAT(CopiesOf(Order(LayerOf({SectionOf(0, kSquare)}), copies, plan)),
              ElementsAre(2, 0, 3, 1));
}

TEST(OrderLayer, CopiesAreVisitedInTheirOrderIfAsked) {
  const std::vector<Copy> copies = {{0, Mm(90, 0), 0}, {0, Mm(30, 0), 0}, {0, Mm(120, 0), 0}};
  OrderingOptions options;
  options.as_listed = true;
  const auto ordered = OrderLayer(LayerOf({SectionOf(0, kSquare)}), {}, copies, options);
  ASSERT_TRUE(ordered.ok()) << ordered.status();
  EXPECT_THAT(CopiesOf(*ordered), ElementsAre(0, 1, 2));
}

// A block is the same at every position and with any neighbours.
TEST(OrderLayer, ABlockDoesNotDependOnThePlate) {
  const OrderedLayer alone = Order(LayerOf({SectionOf(1, kSquare)}), {{1, Mm(7, 9), 0}});
  const OrderedLayer among =
      Order(LayerOf({SectionOf(0, "(0 0, 9 0, 9 9)"), SectionOf(1, kSquare)}),
            {{0, Mm(50, 50), 0}, {1, Mm(150, 20), 0}, {1, Mm(20, 120), 0}});
  EXPECT_EQ(among.blocks[1], alone.blocks[0]);
}

TEST(OrderLayer, ObjectsWithoutPathsAreNotVisited) {
  const OrderedLayer ordered = Order(LayerOf({{0, 3, 200'000, {}}, SectionOf(1, kSquare)}),
                                     {{0, Mm(9, 9), 0}, {1, Mm(50, 0), 0}});
  EXPECT_THAT(CopiesOf(ordered), ElementsAre(1));
}

TEST(OrderLayer, PassesComeOneAfterTheOther) {
  const std::vector<Copy> copies = {{0, Mm(10, 0), 1}, {0, Mm(20, 0), 0}, {0, Mm(30, 0), 1}};
  const OrderedLayer ordered = Order(LayerOf({SectionOf(0, kSquare)}), copies);
  EXPECT_THAT(CopiesOf(ordered), ElementsAre(1, 0, 2));
  EXPECT_EQ(ordered.visits[0].pass, 0);
  EXPECT_EQ(ordered.visits[2].pass, 1);
}

TEST(OrderLayer, ThePlateComesFirst) {
  LayerPlan plan;
  plan.paths = {MakePathOrDie("(1 1, 2 2)"), MakePathOrDie("(3 3, 4 4)")};
  const std::vector<Copy> copies = {{0, Mm(50, 0), 0}};
  const OrderedLayer skirt = Order(LayerOf({SectionOf(0, kSquare)}), copies, plan);
  ASSERT_THAT(skirt.blocks, SizeIs(2));
  EXPECT_EQ(skirt.blocks[0].stack, kSkirtStack);
  EXPECT_EQ(skirt.blocks[0].paths, plan.paths);
  EXPECT_THAT(CopiesOf(skirt), ElementsAre(-1, 0));
  const Stack raft(3, kPlateObject, StackKind::kRaft);
  const OrderedLayer both =
      Order(LayerOf({SectionOf(0, kSquare), SectionOf(raft, "(0 0, 90 0, 90 90)")}), copies, plan);
  ASSERT_THAT(both.blocks, SizeIs(3));
  EXPECT_EQ(both.blocks[0].paths, plan.paths);
  EXPECT_EQ(both.blocks[1].stack, raft);
  EXPECT_THAT(both.blocks[1].paths, SizeIs(1));
  EXPECT_THAT(CopiesOf(both), ElementsAre(-1, -1, 0));
  EXPECT_EQ(both.visits[1].block, 1);
}

TEST(OrderLayer, AnObjectsStacksAreVisitedTogetherByTheirKinds) {
  const Stack support(5, 0, StackKind::kSupport), brim(7, 0, StackKind::kBrim);
  const std::vector<Copy> copies = {{0, Mm(50, 0), 0}, {0, Mm(100, 0), 0}};
  const OrderedLayer ordered =
      Order(LayerOf({SectionOf(0, kSquare), SectionOf(support, "(8 0, 9 0, 9 1, 8 1)"),
                     SectionOf(brim, "(-2 -2, 9 -2, 9 9, -2 9)")}),
            copies);
  ASSERT_THAT(ordered.blocks, SizeIs(3));
  EXPECT_EQ(ordered.blocks[0].stack, brim);
  EXPECT_EQ(ordered.blocks[1].stack, support);
  EXPECT_EQ(ordered.blocks[2].stack, Stack(0));
  EXPECT_THAT(CopiesOf(ordered), ElementsAre(0, 0, 0, 1, 1, 1));
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(ordered.visits[i].block, static_cast<int32_t>(i % 3));
    EXPECT_EQ(ordered.visits[i].shift, copies[i / 3].shift);
  }
}

TEST(OrderLayer, MeetsOtherLayersReadyUnlessTheSettingsForbidIt) {
  LayerPlan plan;
  plan.begins_ready = true;
  FilledLayer layer = LayerOf({SectionOf(0, kSquare)});
  layer.sections[0].islands[0].outline = MakePolygonsOrDie(kSquare).front();
  plan.sections = {{0, Mm(-5, -5), Mm(5, 5), {}}};
  plan.ends_ready = true;
  const auto order = [&](const TravelOptions& travel) {
    OrderingOptions options;
    options.travel = travel;
    return *OrderLayer(layer, plan, std::vector<Copy>{{0, {}, 0}}, options);
  };
  const OrderedLayer ready = order({});
  EXPECT_TRUE(ready.begins_ready);
  EXPECT_TRUE(ready.ends_ready);
  ASSERT_TRUE(ready.blocks[0].exit_travel);
  for (const TravelOptions& travel :
       {TravelOptions{.hide = false}, TravelOptions{.retract_layer_change = true}}) {
    EXPECT_FALSE(order(travel).begins_ready);
    EXPECT_FALSE(order(travel).ends_ready);
  }
  plan = {};
  EXPECT_FALSE(order({}).begins_ready);
  EXPECT_FALSE(order({}).ends_ready);
}

TEST(OrderLayer, RefusesBrokenPaths) {
  struct Case {
    const char* name;
    void (*spoil)(Path&);
  };
  const Case cases[] = {{"Short", [](Path& path) { path.points.resize(1); }},
                        {"Widths", [](Path& path) { path.widths_nm.resize(3, 450'000); }},
                        {"Settings", [](Path& path) { path.settings = 1; }},
                        {"Tool", [](Path& path) { path.tool = 1; }}};
  for (const Case& c : cases) {
    FilledLayer layer = LayerOf({SectionOf(0, kSquare)});
    c.spoil(layer.sections[0].islands[0].walls[0]);
    const auto ordered = OrderLayer(layer, {}, {}, {});
    EXPECT_EQ(DetailOf(ordered.status()).reason, Reason::kRequestMalformed) << c.name;
    EXPECT_EQ(DetailOf(ordered.status()).metadata.at("layer"), "3") << c.name;
  }
}

TEST(OrderLayer, ATurnOfASpiralStartsWhereThePlanSays) {
  LayerPlan plan;
  plan.begins_ready = plan.ends_ready = true;
  plan.sections = {{.stack = 0, .entry = {}, .exit = {}, .seams = {}}};
  plan.sections[0].spiral = {.start = Mm(5, 1), .from = Mm(5, 0.9)};
  const OrderedLayer ordered = Order(LayerOf({SectionOf(0, kSquare)}), {{0, {}, 0}}, plan);
  ASSERT_THAT(ordered.blocks, SizeIs(1));
  EXPECT_EQ(ordered.blocks[0].spiral, plan.sections[0].spiral);
  EXPECT_EQ(ordered.blocks[0].paths[0].points.front(), Mm(5, 1));
  EXPECT_TRUE(ordered.begins_ready && ordered.ends_ready);
}

}  // namespace
}  // namespace slicefarm::ordering::layer_order_test
