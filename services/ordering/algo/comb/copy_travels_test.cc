#include "services/ordering/algo/comb/copy_travels.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "common/model/paths_test.h"
#include "services/ordering/algo/comb/curl_avoidance.h"

namespace slicefarm::ordering::copy_travels_test {
namespace {

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

/// Returns a plan with one curled area: the right edge of a 10 mm square, without the ends of the
/// edge.
LayerPlan CurledOnTheRight(int32_t stack = 0) {
  LayerPlan plan;
  plan.sections.push_back({});
  plan.sections.front().stack = stack;
  plan.sections.front().curled = MakePolygonsOrDie("(9.5 3, 10.5 3, 10.5 7, 9.5 7)");
  return plan;
}

/// Returns copies of that square: a loop and then a line that ends in the square's middle.
OrderedLayer Copies(std::vector<BlockVisit> visits) {
  PathBlock block;
  block.paths = {MakePathOrDie("(0 0, 10 0, 10 10, 0 10)", true), MakePathOrDie("(2 5, 5 5)")};
  OrderedLayer layer;
  layer.blocks = {block};
  layer.visits = std::move(visits);
  return layer;
}

OrderedLayer Led(OrderedLayer layer, const LayerPlan& plan, int64_t sights = 10'000) {
  WorkBudget budget{sights};
  KeepOffCurled(plan, budget, layer);
  return layer;
}

TEST(KeepOffCurled, TheWayToTheNextCopyGoesRound) {
  const OrderedLayer layer = Led(Copies({{0, 0, 0, {}}, {0, 1, 0, Mm(30, 5)}}), CurledOnTheRight());
  EXPECT_TRUE(layer.visits[0].corners.empty());
  ASSERT_FALSE(layer.visits[1].corners.empty());
  const Box bounds{{0, 0}, Mm(40, 15)};
  const CurlAvoidance routes(CurledOnTheRight().sections.front().curled, bounds);
  EXPECT_TRUE(routes.Meets(Mm(5, 5), {}, Mm(30, 5)));
  EXPECT_FALSE(routes.Meets(Mm(5, 5), layer.visits[1].corners, Mm(30, 5)));
  for (const Point corner : layer.visits[1].corners)
    EXPECT_TRUE(bounds.Intersects({corner, corner})) << "no bed is smaller than what is printed";
}

// The travel to the third copy crosses the second copy's curled edge.
TEST(KeepOffCurled, CopiesOnTheWayAreInTheWay) {
  const OrderedLayer layer =
      Led(Copies({{0, 1, 0, Mm(30, 0)}, {0, 0, 0, {}}, {0, 2, 0, Mm(60, 5)}}), CurledOnTheRight());
  EXPECT_TRUE(layer.visits[1].corners.empty()) << "to the left nothing has curled up";
  Point last = Mm(5, 5);
  std::vector<Point> path = layer.visits[2].corners;
  ASSERT_FALSE(path.empty());
  for (const double shift : {0.0, 30.0}) {
    MultiPolygon area = CurledOnTheRight().sections.front().curled;
    for (Point& p : area.front().outer) p = p + Mm(shift, 0);
    EXPECT_FALSE(CurlAvoidance(area, {}).Meets(last, path, Mm(60, 5))) << shift;
  }
}

TEST(KeepOffCurled, WaysThatMeetNothingAreStraight) {
  const std::vector<BlockVisit> visits = {{0, 0, 0, {}}, {0, 1, 0, Mm(0, 30)}};
  EXPECT_EQ(Led(Copies(visits), CurledOnTheRight()), Copies(visits));
  const std::vector<BlockVisit> beside = {{0, 0, 0, {}}, {0, 1, 0, Mm(30, 5)}};
  EXPECT_EQ(Led(Copies(beside), {}), Copies(beside)) << "nothing has curled up";
  EXPECT_EQ(Led(Copies(beside), CurledOnTheRight(1)), Copies(beside)) << "nothing of this stack";
  EXPECT_EQ(Led(Copies(beside), CurledOnTheRight(), 0), Copies(beside)) << "no work allowed";
}

TEST(KeepOffCurled, PassesDoNotMeet) {
  const std::vector<BlockVisit> visits = {{0, 0, 0, {}}, {0, 1, 1, Mm(30, 5)}};
  EXPECT_EQ(Led(Copies(visits), CurledOnTheRight()), Copies(visits));
}

}  // namespace
}  // namespace slicefarm::ordering::copy_travels_test
