#include "services/infill/algo/patterns/planned_lines.h"

#include <gtest/gtest.h>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::planned_lines_test {
namespace {

Polyline Line(std::initializer_list<Point> mm) {
  Polyline line;
  for (const Point& p : mm) line.push_back({p.x * kNmPerMm, p.y * kNmPerMm});
  return line;
}

TEST(PlannedLines, AreCutToTheRegion) {
  const std::vector<Polyline> lines = {Line({{-30, 0}, {30, 0}}), Line({{0, 5}, {10, 5}, {10, 40}}),
                                       Line({{30, 30}, {40, 30}})};
  const auto pieces = PlannedLines(SampleBox(), {.planned = lines});
  ASSERT_TRUE(pieces.ok());
  ASSERT_EQ(pieces->size(), 2);
  EXPECT_NEAR(LengthOf(*pieces), (48 + 10 + 19) * 1e6, 10);
  EXPECT_EQ((*pieces)[1].from.ring, -1);  // ends inside
  EXPECT_EQ((*pieces)[1].to.ring, 0);
}

TEST(PlannedLines, NothingPlannedIsNothing) { EXPECT_TRUE(PlannedLines(SampleBox(), {})->empty()); }

}  // namespace
}  // namespace slicefarm::infill::planned_lines_test
