#include "services/infill/algo/lines/wave_rows.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::wave_rows_test {
namespace {

MultiPolygon Square() { return MakePolygonsOrDie("(0 0, 1 0, 1 1, 0 1)"); }

TEST(RowsOver, StraightRowsAreApart) {
  const auto curves = RowsOver(Square(), {.apart_nm = 250'000, .period_nm = 1'000'000});
  ASSERT_TRUE(curves.ok()) << curves.status();
  std::set<Coord> rows;
  for (const Curve& curve : *curves) {
    ASSERT_EQ(curve.points.size(), 2);
    EXPECT_EQ(curve.points[0].y, curve.points[1].y);
    EXPECT_LE(curve.points[0].x, 0);
    EXPECT_GE(curve.points[1].x, 1'000'000);
    rows.insert(curve.points[0].y);
  }
  for (const Coord v : {0, 250'000, 500'000, 750'000, 1'000'000})
    EXPECT_TRUE(rows.contains(v)) << v;
}

TEST(RowsOver, OddRowsAreMirrored) {
  const std::vector<Vector2> wave = {{0, 50'000}, {500'000, -50'000}};
  const auto curves =
      RowsOver(Square(), {.apart_nm = 250'000, .period_nm = 1'000'000, .wave = wave});
  ASSERT_TRUE(curves.ok()) << curves.status();
  ASSERT_GT(curves->size(), 3);
  for (size_t i = 0; i + 1 < curves->size(); ++i) {
    const Polyline& a = (*curves)[i].points;
    const Polyline& b = (*curves)[i + 1].points;
    ASSERT_EQ(a.size(), b.size());
    for (size_t k = 0; k < a.size(); ++k) {
      EXPECT_EQ(a[k].x, b[k].x);
      EXPECT_EQ(std::abs(b[k].y - a[k].y - 250'000), 100'000);
    }
  }
}

TEST(RowsOver, TransposedRowsRunAcross) {
  const auto curves =
      RowsOver(Square(), {.transposed = true, .apart_nm = 250'000, .period_nm = 1'000'000});
  ASSERT_TRUE(curves.ok()) << curves.status();
  ASSERT_FALSE(curves->empty());
  for (const Curve& curve : *curves) EXPECT_EQ(curve.points.front().x, curve.points.back().x);
}

TEST(RowsOver, RefusesTooManySegments) {
  EXPECT_EQ(DetailOf(RowsOver(Square(), {.apart_nm = 0.001, .period_nm = 1}).status()).reason,
            Reason::kRequestTooLarge);
  EXPECT_TRUE(RowsOver({}, {.apart_nm = 0.001, .period_nm = 1})->empty());
}

}  // namespace
}  // namespace slicefarm::infill::wave_rows_test
