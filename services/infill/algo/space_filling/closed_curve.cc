#include "services/infill/algo/space_filling/closed_curve.h"

#include "services/infill/algo/space_filling/hilbert.h"
#include "services/infill/algo/space_filling/peano.h"

namespace slicefarm::infill {

std::vector<CurveCell> ClosedHilbert(int order) {
  const uint32_t side = uint32_t{1} << order, last = side - 1;
  const uint64_t count = uint64_t{1} << (2 * order);
  std::vector<CurveCell> cells;
  cells.reserve(4 * count);
  // The curve rises along the middle through the left half, and falls through the right half.
  for (const uint32_t above : {uint32_t{0}, side}) {
    for (uint64_t i = 0; i < count; ++i) {
      const auto [x, y] = HilbertCell(order, i);
      cells.push_back({last - y, above + x});
    }
  }
  for (const uint32_t above : {side, uint32_t{0}}) {
    for (uint64_t i = 0; i < count; ++i) {
      const auto [x, y] = HilbertCell(order, i);
      cells.push_back({side + y, above + last - x});
    }
  }
  return cells;
}

std::vector<CurveCell> ClosedPeano(int order) {
  uint32_t side = 1;
  for (int i = 0; i < order; ++i) side *= 3;
  const uint32_t last = side - 1;
  const uint64_t count = uint64_t{side} * side;
  std::vector<CurveCell> cells;
  cells.reserve(4 * count);
  // The order is counter-clockwise from the lower left. Each curve runs from corner to corner,
  // towards the next one.
  for (uint64_t i = 0; i < count; ++i) {
    const auto [x, y] = PeanoCell(order, i);
    cells.push_back({x, last - y});
  }
  for (uint64_t i = 0; i < count; ++i) {
    const auto [x, y] = PeanoCell(order, i);
    cells.push_back({side + x, y});
  }
  for (uint64_t i = 0; i < count; ++i) {
    const auto [x, y] = PeanoCell(order, i);
    cells.push_back({side + last - x, side + y});
  }
  for (uint64_t i = 0; i < count; ++i) {
    const auto [x, y] = PeanoCell(order, i);
    cells.push_back({last - x, side + last - y});
  }
  return cells;
}

}  // namespace slicefarm::infill
