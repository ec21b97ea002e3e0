#pragma once

#include <optional>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// A footprint in one of the ways round that it may lie.
struct ShapeVariant {
  double rotation_deg = 0;
  Polygon hull;
  Box box;
  std::vector<Polygon> parts;     ///< convex pieces
  std::vector<Polygon> mirrored;  ///< the pieces mirrored in the origin and grown by the distance
  std::vector<Polygon> kept_off;  ///< translations that put a piece into an excluded area; convex
};
/// `excluded`: convex pieces of the bed's excluded areas. REQUIRES: footprint not empty.
ShapeVariant MakeVariant(const Polygon& footprint, double rotation_deg, Coord distance_nm,
                         std::span<const Polygon> excluded = {});

/// Returns the translations that put one of the convex `parts` into an area: one polygon for each
/// part and area.
std::vector<Polygon> KeptOff(std::span<const Polygon> parts, std::span<const Polygon> excluded);

using Shape = std::vector<ShapeVariant>;

struct StandingPart {
  std::vector<Polygon> parts;
  int plate = 0;
};

struct PackingTask {
  Polygon bed;  ///< convex, counter-clockwise
  std::vector<Polygon> excluded = {};  ///< convex areas of the bed where nothing may be
  std::vector<Shape> shapes;
  std::vector<size_t> sequence;        ///< index of the shape of each item, in order of placing
  std::vector<StandingPart> standing;  ///< on plates 0, 1, ...
  int max_plates = 0;                  ///< 0: any number
};

struct PackedItem {
  int plate = 0;
  size_t variant = 0;
  Point translation;
};
struct Packing {
  std::vector<std::optional<PackedItem>> items;  ///< one for each of the sequence
  int plates = 0;                                ///< that have an item or a standing part
};

enum class PackingOrder {
  kFromMiddle,  ///< each item as near to the bed's middle as can be
  kFromFront,   ///< each item as far to the front, then to the left
};

/// Greedy packing: each item goes to the first plate that has a place for it, and there to the best
/// one of FreePlaces under `order`. Items that fit on no plate stay without a place.
///
/// Errors: CANCELLED. Cost: for each item O(k m) on the plate where it lands, for the k parts there
/// of m corners; and each time the sequence changes to another shape, O(k^2 m^2) at worst for each
/// plate that is tried.
absl::StatusOr<Packing> Pack(const PackingTask& task, PackingOrder order,
                             const CancelToken& cancel);

}  // namespace slicefarm::slicing
