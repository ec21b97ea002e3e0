#include "common/model/spiral.h"

#include <utility>

#include "common/geometry/offset/clean_offset.h"

namespace slicefarm {
namespace {

bool IsOneLoop(const MultiPolygon& region) {
  return region.size() == 1 && region.front().holes.empty();
}

}  // namespace

std::optional<Polygon> SpiralLoop(const MultiPolygon& outline, Coord width_nm) {
  if (!IsOneLoop(outline)) return std::nullopt;
  MultiPolygon inner = FastOffset(outline, -width_nm / 2);
  if (!IsOneLoop(inner)) return std::nullopt;
  return std::move(inner.front().outer);
}

}  // namespace slicefarm
