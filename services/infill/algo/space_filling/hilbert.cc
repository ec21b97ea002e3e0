#include "services/infill/algo/space_filling/hilbert.h"

#include <array>
#include <utility>

namespace slicefarm::infill {
namespace {

struct Quadrant {
  uint8_t x = 0;
  uint8_t y = 0;
  uint8_t state = 0;  ///< orientation of the curve in the quadrant
};

/// Quadrants, by orientation and digit. Orientation 0 is the one of HilbertCell, 1 is mirrored in
/// the diagonal, 2 in the other diagonal, 3 in both.
constexpr std::array<std::array<Quadrant, 4>, 4> kQuadrants = {{
    {{{0, 0, 1}, {0, 1, 0}, {1, 1, 0}, {1, 0, 2}}},
    {{{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 3}}},
    {{{1, 1, 3}, {0, 1, 2}, {0, 0, 2}, {1, 0, 0}}},
    {{{1, 1, 2}, {1, 0, 3}, {0, 0, 3}, {0, 1, 1}}},
}};

}  // namespace

CurveCell HilbertCell(int order, uint64_t index) {
  CurveCell cell;
  uint8_t state = 0;
  for (int level = order - 1; level >= 0; --level) {
    const Quadrant& quadrant = kQuadrants[state][(index >> (2 * level)) & 3];
    cell.x = cell.x << 1 | quadrant.x;
    cell.y = cell.y << 1 | quadrant.y;
    state = quadrant.state;
  }
  return cell;
}

uint64_t HilbertIndex(int order, CurveCell cell) {
  auto [x, y] = cell;
  const uint32_t last = (uint32_t{1} << order) - 1;
  uint64_t index = 0;
  for (int level = order - 1; level >= 0; --level) {
    const uint32_t right = x >> level & 1, upper = y >> level & 1;
    index = index << 2 | ((3 * right) ^ upper);
    if (upper == 1) continue;
    if (right == 1) {
      x = last - x;
      y = last - y;
    }
    std::swap(x, y);
  }
  return index;
}

}  // namespace slicefarm::infill
