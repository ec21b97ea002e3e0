#include "services/infill/algo/space_filling/closed_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace slicefarm::infill::closed_curve_test {
namespace {

void ExpectClosedCurve(const std::vector<CurveCell>& cells, uint32_t side) {
  EXPECT_EQ(std::set(cells.begin(), cells.end()).size(), uint64_t{side} * side);
  for (size_t i = 0; i < cells.size(); ++i) {
    const CurveCell a = cells[i], b = cells[i + 1 == cells.size() ? 0 : i + 1];
    EXPECT_LT(a.x, side);
    EXPECT_LT(a.y, side);
    EXPECT_EQ(std::abs(static_cast<int>(a.x) - static_cast<int>(b.x)) +
                  std::abs(static_cast<int>(a.y) - static_cast<int>(b.y)),
              1)
        << i;
  }
}

TEST(ClosedCurve, Hilbert) {
  for (int order = 0; order <= 6; ++order) ExpectClosedCurve(ClosedHilbert(order), 2U << order);
}

TEST(ClosedCurve, Peano) {
  uint32_t side = 2;
  for (int order = 0; order <= 4; ++order, side *= 3) ExpectClosedCurve(ClosedPeano(order), side);
}

}  // namespace
}  // namespace slicefarm::infill::closed_curve_test
