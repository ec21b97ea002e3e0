#include "services/slicing/algo/placement/arranging/arrange.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "common/model/limits.h"
#include "services/slicing/algo/placement/arranging/convex_parts.h"
#include "services/slicing/algo/placement/arranging/free_positions.h"
#include "services/slicing/algo/placement/arranging/grid_positions.h"
#include "services/slicing/algo/placement/arranging/packing.h"

namespace slicefarm::slicing {
namespace {

constexpr auto kInvalid = absl::StatusCode::kInvalidArgument;

bool WithinRange(const Polygon& ring) {
  const auto ok = [](Coord c) { return std::abs(c) <= limits::kMaxCoord; };
  return std::all_of(ring.begin(), ring.end(), [&](Point p) { return ok(p.x) && ok(p.y); });
}

absl::Status CheckFootprint(const Polygon& footprint, std::string_view what, size_t index) {
  const std::map<std::string, std::string> metadata = {{"item", std::to_string(index)}};
  if (footprint.empty())
    return MakeError(kInvalid, Reason::kRequestMalformed,
                     fmt::format("{} {} has no footprint", what, index), metadata);
  if (!WithinRange(footprint))
    return MakeError(kInvalid, Reason::kOutOfRange,
                     fmt::format("{} {} reaches beyond 2.1 m", what, index), metadata);
  return absl::OkStatus();
}

absl::Status CheckItem(const ArrangeItem& item, size_t index) {
  if (absl::Status status = CheckFootprint(item.footprint, "item", index); !status.ok())
    return status;
  const bool finite = std::all_of(item.rotations_deg.begin(), item.rotations_deg.end(),
                                  [](double deg) { return std::isfinite(deg); });
  if (item.rotations_deg.empty() || !finite)
    return MakeError(kInvalid, Reason::kRequestMalformed,
                     fmt::format("item {} has no rotation, or one that is not finite", index),
                     {{"item", std::to_string(index)}});
  return absl::OkStatus();
}

absl::Status CheckOptions(const ArrangeOptions& options) {
  const auto refuse = [](std::string_view setting, std::string_view what) {
    return MakeError(kInvalid, Reason::kSettingOutOfRange, fmt::format("{} {}", setting, what),
                     {{"setting", std::string(setting)}});
  };
  const auto in_range = [](Coord c) { return c >= 0 && c <= limits::kMaxCoord; };
  if (!in_range(options.distance_nm)) return refuse("distance", "must be from 0 to 2.1 m");
  if (!in_range(options.bed_margin_nm)) return refuse("bed_margin", "must be from 0 to 2.1 m");
  if (options.max_plates < 0) return refuse("max_plates", "must not be negative");
  if (!std::ranges::all_of(options.excluded, WithinRange))
    return refuse("bed_exclude_area", "reaches beyond 2.1 m");
  if (options.bed.size() < 3) return absl::OkStatus();
  if (!WithinRange(options.bed)) return refuse("bed_shape", "reaches beyond 2.1 m");
  const double area = SignedArea(ConvexHull(options.bed));
  if (area <= 0 || area != std::abs(SignedArea(options.bed)))
    return refuse("bed_shape", "must be convex and have an area");
  return absl::OkStatus();
}

absl::Status Check(std::span<const ArrangeItem> items, std::span<const FixedFootprint> fixed,
                   const ArrangeOptions& options) {
  if (absl::Status status = CheckOptions(options); !status.ok()) return status;
  if (const int64_t got = items.size() + fixed.size(); got > limits::kMaxObjects)
    return LimitError(Reason::kRequestTooLarge, "parts to arrange", limits::kMaxObjects, got);
  for (size_t i = 0; i < items.size(); ++i)
    if (absl::Status status = CheckItem(items[i], i); !status.ok()) return status;
  for (size_t i = 0; i < fixed.size(); ++i) {
    if (absl::Status status = CheckFootprint(fixed[i].footprint, "fixed part", i); !status.ok())
      return status;
    const int plates = options.max_plates > 0 ? options.max_plates : limits::kMaxObjects;
    if (fixed[i].plate < 0 || fixed[i].plate >= plates)
      return MakeError(
          kInvalid, Reason::kRequestMalformed,
          fmt::format("fixed part {} stands on plate {} of {}", i, fixed[i].plate, plates),
          {{"item", std::to_string(i)}});
  }
  return absl::OkStatus();
}

/// Returns the bed shrunk by its margin; empty if nothing remains.
Polygon UsableBed(const ArrangeOptions& options) {
  constexpr Coord kFar = 1'000 * kNmPerMm;
  Polygon bed = options.bed.size() < 3
                    ? Polygon{{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}}
                    : options.bed;
  bed = ConvexHull(std::move(bed));
  if (options.bed_margin_nm == 0) return bed;
  const MultiPolygon inner = Offset({{std::move(bed), {}}}, -options.bed_margin_nm);
  return inner.empty() ? Polygon{} : ConvexHull(inner[0].outer);
}

/// Returns the excluded areas as convex pieces, grown by the margin. The areas are cut at the
/// height of each corner, which gives trapezoids.
std::vector<Polygon> ExcludedPieces(const ArrangeOptions& options) {
  const MultiPolygon areas = Union(options.excluded, FillRule::kNonZero);
  std::set<Coord> heights;
  for (const Polygon& ring : Rings(areas))
    for (const Point corner : ring) heights.insert(corner.y);
  const Box box = Bounds(areas);
  const Polygon disc = DiscCover(options.bed_margin_nm);
  std::vector<Polygon> pieces;
  for (auto low = heights.begin(); low != heights.end(); ++low) {
    const auto high = std::next(low);
    if (high == heights.end()) break;
    const Polygon slab = {
        {box.min.x, *low}, {box.max.x, *low}, {box.max.x, *high}, {box.min.x, *high}};
    for (const PolygonWithHoles& piece : Intersection(areas, {{slab, {}}}))
      pieces.push_back(ConvexSum(ConvexHull(piece.outer), disc));
  }
  return pieces;
}

/// Packing task, and the index of the input item for each element of its sequence.
struct PreparedItems {
  PackingTask task;
  std::vector<size_t> item_of;
};

PreparedItems Prepare(std::span<const ArrangeItem> items, std::span<const FixedFootprint> fixed,
                      const ArrangeOptions& options) {
  // Equal items share one shape. The largest items come first, independent of the order of the
  // input.
  using Key = std::tuple<double, const Polygon&, const std::vector<double>&>;
  std::vector<std::pair<double, size_t>> by_area;
  const auto key = [&](const std::pair<double, size_t>& entry) {
    const ArrangeItem& item = items[entry.second];
    return Key(entry.first, item.footprint, item.rotations_deg);
  };
  for (size_t i = 0; i < items.size(); ++i)
    by_area.push_back({-SignedArea(ConvexHull(items[i].footprint)), i});
  std::stable_sort(by_area.begin(), by_area.end(),
                   [&](const auto& a, const auto& b) { return key(a) < key(b); });

  PreparedItems prepared;
  PackingTask& task = prepared.task;
  task.bed = UsableBed(options);
  task.excluded = ExcludedPieces(options);
  task.max_plates = options.max_plates;
  for (size_t i = 0; i < by_area.size(); ++i) {
    const ArrangeItem& item = items[by_area[i].second];
    if (i == 0 || key(by_area[i - 1]) != key(by_area[i])) {
      Shape& shape = task.shapes.emplace_back();
      for (const double deg : item.rotations_deg)
        shape.push_back(MakeVariant(item.footprint, deg, options.distance_nm, task.excluded));
    }
    task.sequence.push_back(task.shapes.size() - 1);
    prepared.item_of.push_back(by_area[i].second);
  }
  for (const FixedFootprint& part : fixed)
    task.standing.push_back({ConvexParts(part.footprint), part.plate});
  return prepared;
}

size_t LeftOver(const Packing& packing) {
  return std::count(packing.items.begin(), packing.items.end(), std::nullopt);
}

/// Returns true if `a` is better than `b`: it leaves fewer items over, then needs fewer plates,
/// then has fewer items on the last plate.
bool Better(const Packing& a, const Packing& b) {
  const auto rank = [](const Packing& packing) {
    const auto on_last = [&](const auto& item) {
      return item && item->plate + 1 == packing.plates;
    };
    return std::tuple(LeftOver(packing), packing.plates,
                      std::count_if(packing.items.begin(), packing.items.end(), on_last));
  };
  return rank(a) < rank(b);
}

bool OnePlate(const Packing& packing) { return packing.plates <= 1 && LeftOver(packing) == 0; }

/// Returns a packing of equal items in one grid per plate.
Packing InGrids(const PackingTask& task, size_t variant, Coord distance_nm) {
  const ShapeVariant& shape = task.shapes[0][variant];
  Packing packing;
  size_t left = task.sequence.size();
  while (left > 0 && (task.max_plates == 0 || packing.plates < task.max_plates)) {
    const std::vector<Point> places =
        GridPositions(task.bed, shape.hull, distance_nm, left, shape.kept_off);
    if (places.empty()) break;
    for (const Point place : places)
      packing.items.push_back(PackedItem{packing.plates, variant, place});
    left -= places.size();
    ++packing.plates;
  }
  packing.items.resize(task.sequence.size());
  return packing;
}

std::optional<Packing> BestGrid(const PackingTask& task, Coord distance_nm) {
  if (task.shapes.size() != 1 || !task.standing.empty()) return std::nullopt;
  std::optional<Packing> best;
  for (size_t variant = 0; variant < task.shapes[0].size(); ++variant)
    if (Packing grid = InGrids(task, variant, distance_nm); !best || Better(grid, *best))
      best = std::move(grid);
  return best;
}

absl::StatusOr<Packing> BestPacking(const PackingTask& task, Coord distance_nm,
                                    const CancelToken& cancel) {
  std::optional<Packing> best = BestGrid(task, distance_nm);
  for (const PackingOrder order : {PackingOrder::kFromMiddle, PackingOrder::kFromFront}) {
    if (best && OnePlate(*best)) break;
    absl::StatusOr<Packing> packing = Pack(task, order, cancel);
    if (!packing.ok()) return packing.status();
    if (!best || Better(*packing, *best)) best = *std::move(packing);
  }
  return *std::move(best);
}

/// All items on one plate, moved together.
struct Group {
  std::vector<Point> corners;
  std::vector<Polygon> kept_off;  ///< forbidden translations, as in ShapeVariant
};

/// Returns twice the position of the middle of a plate's parts.
Point TwiceMiddle(const Polygon& bed, const ArrangeOptions& options) {
  const Box box = Bounds(bed);
  const auto at = [](Coord least, Coord most, double share) {
    return least + most + std::llround((2 * share - 1) * static_cast<double>(most - least));
  };
  return {at(box.min.x, box.max.x, options.middle_x), at(box.min.y, box.max.y, options.middle_y)};
}

/// Returns the translation that moves the middle of the group's box towards `twice_middle` / 2,
/// along a straight line, as far as the bed's outline and its excluded areas allow.
Point TowardsMiddle(const Polygon& bed, Point twice_middle, Group group) {
  const Box box = Bounds(group.corners);
  const Point path = twice_middle - (box.min + box.max);
  FreePositions free(bed, ConvexHull(std::move(group.corners)), {0, 0});
  free.AddObstacles(std::move(group.kept_off));
  const auto at = [&](Coord part, Coord of) {
    const auto rounded = [&](Coord whole) {
      return std::llround(0.5 * whole * part / of / kPositionStep) * kPositionStep;
    };
    return Point{rounded(path.x), rounded(path.y)};
  };
  constexpr Coord kParts = 1 << 12;
  Coord good = 0, bad = kParts + 1;
  if (free.Allowed(at(kParts, kParts))) return at(kParts, kParts);
  while (bad - good > 1) {
    const Coord half = (good + bad) / 2;
    (free.Allowed(at(half, kParts)) ? good : bad) = half;
  }
  return at(good, kParts);
}

void CenterPlates(const PackingTask& task, const ArrangeOptions& options, Packing& packing) {
  std::vector<Group> groups(packing.plates);
  std::vector<bool> fixed(packing.plates, false);
  for (const StandingPart& part : task.standing) fixed[part.plate] = true;
  for (size_t i = 0; i < packing.items.size(); ++i) {
    if (!packing.items[i]) continue;
    const auto& [plate, variant, at] = *packing.items[i];
    const ShapeVariant& shape = task.shapes[task.sequence[i]][variant];
    Group& group = groups[plate];
    for (const Point corner : shape.hull) group.corners.push_back(corner + at);
    // The areas are relative to the item's present position.
    for (const Polygon& area : shape.kept_off) group.kept_off.push_back(Moved(area, Point{} - at));
  }
  std::vector<Point> moves(packing.plates);
  for (int plate = 0; plate < packing.plates; ++plate)
    if (!fixed[plate] && !groups[plate].corners.empty())
      moves[plate] =
          TowardsMiddle(task.bed, TwiceMiddle(task.bed, options), std::move(groups[plate]));
  for (std::optional<PackedItem>& item : packing.items)
    if (item) item->translation = item->translation + moves[item->plate];
}

Arrangement Result(const PreparedItems& prepared, const Packing& packing) {
  const PackingTask& task = prepared.task;
  Arrangement result;
  result.plates = packing.plates;
  result.places.resize(packing.items.size());
  for (size_t i = 0; i < packing.items.size(); ++i) {
    if (!packing.items[i]) {
      result.left_over.push_back(prepared.item_of[i]);
      continue;
    }
    const auto& [plate, variant, at] = *packing.items[i];
    const double deg = task.shapes[task.sequence[i]][variant].rotation_deg;
    result.places[prepared.item_of[i]] = ItemPosition{plate, at, deg};
  }
  std::sort(result.left_over.begin(), result.left_over.end());
  return result;
}

}  // namespace

absl::StatusOr<Arrangement> Arrange(std::span<const ArrangeItem> items,
                                    std::span<const FixedFootprint> fixed,
                                    const ArrangeOptions& options, const CancelToken& cancel) {
  if (absl::Status status = Check(items, fixed, options); !status.ok()) return status;
  const PreparedItems prepared = Prepare(items, fixed, options);
  Packing packing;
  packing.items.resize(items.size());
  if (prepared.task.bed.size() >= 3 && !items.empty()) {
    absl::StatusOr<Packing> best = BestPacking(prepared.task, options.distance_nm, cancel);
    if (!best.ok()) return best.status();
    packing = *std::move(best);
    CenterPlates(prepared.task, options, packing);
  }
  return Result(prepared, packing);
}

}  // namespace slicefarm::slicing
