#include "services/slicing/algo/placement/arranging/packing.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "common/geometry/convex.h"
#include "common/geometry/moved.h"
#include "common/model/scene/rotation.h"
#include "services/slicing/algo/placement/arranging/convex_parts.h"
#include "services/slicing/algo/placement/arranging/free_positions.h"

namespace slicefarm::slicing {
namespace {

Point Middle(const Box& box) {
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

Polygon Rotated(Polygon ring, double rotation_deg) {
  const auto [s, c] = SineCosineDegrees(rotation_deg);
  for (Point& p : ring) p = {std::llround(c * p.x - s * p.y), std::llround(s * p.x + c * p.y)};
  return ring;
}

/// Smallest extents and area of a shape over its rotations.
struct Size {
  Coord x = INT64_MAX, y = INT64_MAX;
  double area = std::numeric_limits<double>::infinity();

  void Shrink(const Size& other) {
    x = std::min(x, other.x);
    y = std::min(y, other.y);
    area = std::min(area, other.area);
  }
  bool AtLeast(const Size& other, double share) const {
    return x >= share * other.x && y >= share * other.y && area >= share * other.area;
  }
};

Size SizeOf(const Shape& shape) {
  Size size;
  for (const ShapeVariant& variant : shape)
    size.Shrink({variant.box.max.x - variant.box.min.x, variant.box.max.y - variant.box.min.y,
                 SignedArea(variant.hull)});
  return size;
}

/// With more items than this, an item is also skipped if the plate has refused a slightly smaller
/// one.
constexpr size_t kMany = 200;
constexpr double kHardlySmaller = 0.85;

/// Parts on one plate, and the free positions on it for the current shape.
struct Plate {
  std::vector<std::pair<const std::vector<Polygon>*, Point>> standing;
  std::vector<FreePositions> free;  ///< one for each variant; empty: not computed yet
  size_t seen = 0;  ///< number of parts of `standing` that are already obstacles in `free`
  std::vector<Size> refused;  ///< sizes of shapes that found no position
};

class Packer {
 public:
  Packer(const PackingTask& task, PackingOrder order)
      : task_(task), order_(order), middle_(Middle(Bounds(task.bed))) {
    for (const StandingPart& part : task.standing)
      PlateAt(part.plate).standing.push_back({&part.parts, {0, 0}});
  }

  absl::StatusOr<Packing> Run(const CancelToken& cancel) {
    Packing packing;
    for (const size_t shape : task_.sequence) {
      if (absl::Status status = cancel.Check(); !status.ok()) return status;
      if (shape != shape_) ChangeShape(shape);
      packing.items.push_back(Place());
    }
    packing.plates = static_cast<int>(plates_.size());
    return packing;
  }

 private:
  Plate& PlateAt(size_t index) {
    if (plates_.size() <= index) plates_.resize(index + 1);
    return plates_[index];
  }

  void ChangeShape(size_t shape) {
    shape_ = shape;
    size_ = SizeOf(task_.shapes[shape]);
    too_large_ = false;
    for (Plate& plate : plates_) plate.free.clear();
  }

  std::optional<PackedItem> Place() {
    if (too_large_) return std::nullopt;
    for (size_t i = 0; i < plates_.size(); ++i)
      if (auto item = Hopeless(plates_[i]) ? std::nullopt : PlaceOn(i)) return item;
    if (task_.max_plates > 0 && static_cast<int>(plates_.size()) >= task_.max_plates)
      return std::nullopt;
    plates_.emplace_back();
    if (auto item = PlaceOn(plates_.size() - 1)) return item;
    plates_.pop_back();
    too_large_ = true;
    return std::nullopt;
  }

  std::optional<PackedItem> PlaceOn(size_t index) {
    Plate& plate = plates_[index];
    const Shape& shape = task_.shapes[shape_];
    BringUpToDate(plate, shape);
    std::optional<PackedItem> best;
    for (size_t variant = 0; variant < shape.size(); ++variant)
      for (const Point place : plate.free[variant].Positions())
        if (const PackedItem item = {static_cast<int>(index), variant, place};
            !best || Cost(shape, item) < Cost(shape, *best))
          best = item;
    if (best)
      plate.standing.push_back({&shape[best->variant].parts, best->translation});
    else
      plate.refused.push_back(size_);
    return best;
  }

  /// Returns true if the plate has refused a shape that is not larger. A shape rarely fits where a
  /// smaller box did not: it would need a different form.
  bool Hopeless(const Plate& plate) const {
    const double share = task_.sequence.size() > kMany ? kHardlySmaller : 1;
    return std::any_of(plate.refused.begin(), plate.refused.end(),
                       [&](const Size& refused) { return size_.AtLeast(refused, share); });
  }

  void BringUpToDate(Plate& plate, const Shape& shape) {
    if (plate.free.empty()) {
      plate.seen = 0;
      for (const ShapeVariant& variant : shape) {
        plate.free.emplace_back(task_.bed, variant.hull, middle_ - Middle(variant.box));
        plate.free.back().AddObstacles(variant.kept_off);
      }
    }
    for (size_t variant = 0; variant < shape.size(); ++variant) {
      std::vector<Polygon> obstacles;
      for (size_t i = plate.seen; i < plate.standing.size(); ++i) {
        const auto& [parts, at] = plate.standing[i];
        for (const Polygon& there : *parts)
          for (const Polygon& mirrored : shape[variant].mirrored)
            obstacles.push_back(Moved(ConvexSum(there, mirrored), at));
      }
      plate.free[variant].AddObstacles(std::move(obstacles));
    }
    plate.seen = plate.standing.size();
  }

  /// Returns the cost of a position, the smallest is best; the last elements break all ties.
  std::tuple<double, Coord, Coord, size_t> Cost(const Shape& shape, const PackedItem& item) const {
    const Box& box = shape[item.variant].box;
    const Point t = item.translation;
    const double far = order_ == PackingOrder::kFromMiddle ? SquaredNorm(Middle(box) + t - middle_)
                                                           : static_cast<double>(box.max.y + t.y);
    return {far, t.y, t.x, item.variant};
  }

  const PackingTask& task_;
  const PackingOrder order_;
  const Point middle_;
  std::vector<Plate> plates_;
  size_t shape_ = SIZE_MAX;
  Size size_;
  bool too_large_ = false;  ///< true if the current shape is too large even for an empty plate
};

}  // namespace

std::vector<Polygon> KeptOff(std::span<const Polygon> parts, std::span<const Polygon> excluded) {
  std::vector<Polygon> kept_off;
  for (const Polygon& area : excluded)
    for (const Polygon& part : parts) kept_off.push_back(ConvexSum(area, Negated(part)));
  return kept_off;
}

ShapeVariant MakeVariant(const Polygon& footprint, double rotation_deg, Coord distance_nm,
                         std::span<const Polygon> excluded) {
  const Polygon turned = rotation_deg == 0 ? footprint : Rotated(footprint, rotation_deg);
  ShapeVariant variant;
  variant.rotation_deg = rotation_deg;
  variant.parts = ConvexParts(turned);
  variant.hull = ConvexHull(turned);
  variant.box = Bounds(turned);
  const Polygon disc = DiscCover(distance_nm);
  for (const Polygon& part : variant.parts)
    variant.mirrored.push_back(ConvexSum(Negated(part), disc));
  variant.kept_off = KeptOff(variant.parts, excluded);
  return variant;
}

absl::StatusOr<Packing> Pack(const PackingTask& task, PackingOrder order,
                             const CancelToken& cancel) {
  return Packer(task, order).Run(cancel);
}

}  // namespace slicefarm::slicing
