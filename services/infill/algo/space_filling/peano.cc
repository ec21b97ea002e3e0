#include "services/infill/algo/space_filling/peano.h"

namespace slicefarm::infill {
namespace {

uint64_t PowerOf3(int exponent) {
  uint64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 3;
  return power;
}

uint32_t MirroredIf(uint64_t odd, uint32_t digit) { return odd % 2 == 1 ? 2 - digit : digit; }

}  // namespace

CurveCell PeanoCell(int order, uint64_t index) {
  CurveCell cell;
  uint64_t sum_x = 0, sum_y = 0;  // sums of the index's digits per axis
  uint64_t unit = PowerOf3(2 * order);
  for (int level = 0; level < order; ++level) {
    unit /= 3;
    const auto slow = static_cast<uint32_t>(index / unit % 3);
    unit /= 3;
    const auto fast = static_cast<uint32_t>(index / unit % 3);
    cell.x = 3 * cell.x + MirroredIf(sum_y, slow);
    sum_x += slow;
    cell.y = 3 * cell.y + MirroredIf(sum_x, fast);
    sum_y += fast;
  }
  return cell;
}

uint64_t PeanoIndex(int order, CurveCell cell) {
  uint64_t index = 0, sum_x = 0, sum_y = 0;
  uint64_t unit = PowerOf3(order);
  for (int level = 0; level < order; ++level) {
    unit /= 3;
    const uint32_t slow = MirroredIf(sum_y, static_cast<uint32_t>(cell.x / unit % 3));
    sum_x += slow;
    const uint32_t fast = MirroredIf(sum_x, static_cast<uint32_t>(cell.y / unit % 3));
    sum_y += fast;
    index = 9 * index + 3 * slow + fast;
  }
  return index;
}

}  // namespace slicefarm::infill
