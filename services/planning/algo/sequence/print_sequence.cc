#include "services/planning/algo/sequence/print_sequence.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/model/limits.h"

namespace slicefarm::planning {
namespace {

constexpr auto kInvalid = absl::StatusCode::kInvalidArgument;
constexpr Coord kTolerance = 1'000;
constexpr size_t kGroups = 4;
constexpr int kMostPasses = 50;
/// Radius of the widest nozzles.
constexpr Coord kNozzleRadius = 2 * kNmPerMm;

/// Finished object, as an obstacle for the head.
struct Standing {
  size_t index = 0;
  Polygon hull;
  Box box;
  Point middle;
  /// true if the object is taller than nozzle_height, clearance_height or lid_height
  bool meets_head = false, meets_gantry = false, meets_lid = false;

  /// Number of these three heights that the object exceeds. A taller object is in the same group or
  /// a later one.
  int Group() const { return int{meets_head} + int{meets_gantry} + int{meets_lid}; }
};

bool InRange(Coord c) { return std::abs(c) <= limits::kMaxCoord; }

absl::Status CheckItem(const SequenceItem& item, size_t index) {
  if (item.footprint.empty() || item.height_nm < 0)
    return MakeError(
        kInvalid, Reason::kRequestMalformed,
        fmt::format("object {} ({}) has no footprint, or a negative height", index, item.name),
        {{"item", std::to_string(index)}});
  if (!std::all_of(item.footprint.begin(), item.footprint.end(),
                   [](Point p) { return InRange(p.x) && InRange(p.y); }))
    return MakeError(kInvalid, Reason::kOutOfRange,
                     fmt::format("object {} ({}) reaches beyond 2.1 m", index, item.name),
                     {{"item", std::to_string(index)}});
  return absl::OkStatus();
}

absl::Status Check(std::span<const SequenceItem> items, const SequenceOptions& options) {
  const std::pair<std::string_view, Coord> lengths[] = {
      {"extruder_clearance_radius", options.clearance_radius_nm},
      {"extruder_clearance_height", options.clearance_height_nm},
      {"extruder_clearance_dist_to_rod", options.gantry_reach_nm.value_or(0)},
      {"extruder_clearance_height_to_lid", options.lid_height_nm.value_or(0)},
      {"nozzle_height", options.nozzle_height_nm}};
  for (const auto& [setting, value] : lengths)
    if (value < 0 || !InRange(value))
      return MakeError(kInvalid, Reason::kSettingOutOfRange,
                       fmt::format("{} must be from 0 to 2.1 m", setting),
                       {{"setting", std::string(setting)}});
  if (const int64_t got = items.size(); got > limits::kMaxObjects)
    return LimitError(Reason::kRequestTooLarge, "objects to print one by one", limits::kMaxObjects,
                      got);
  for (size_t i = 0; i < items.size(); ++i)
    if (absl::Status status = CheckItem(items[i], i); !status.ok()) return status;
  return absl::OkStatus();
}

std::vector<Standing> AllStanding(std::span<const SequenceItem> items,
                                  const SequenceOptions& options) {
  std::vector<Standing> all;
  for (size_t i = 0; i < items.size(); ++i) {
    Polygon hull = ConvexHull(items[i].footprint);
    const Box box = Bounds(hull);
    const Point middle = {(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2};
    const Coord height = items[i].height_nm;
    all.push_back({i, std::move(hull), box, middle,
                   options.nozzle_height_nm == 0 || height > options.nozzle_height_nm,
                   height > options.clearance_height_nm,
                   options.lid_height_nm && height > *options.lid_height_nm});
  }
  return all;
}

bool TooNear(const Standing& a, const Standing& b, const SequenceOptions& options) {
  const Coord radius = a.meets_head && b.meets_head
                           ? options.clearance_radius_nm
                           : std::min(options.clearance_radius_nm, kNozzleRadius);
  const Coord least = radius - kTolerance;
  return least > 0 ? a.box.Grown(least).Intersects(b.box) && ConvexDistance(a.hull, b.hull) < least
                   : StrictlyInside({0, 0}, ConvexSum(a.hull, Negated(b.hull)));
}

bool GantryMeets(const Standing& a, const Standing& b, const SequenceOptions& options) {
  if (!a.meets_gantry || !b.meets_gantry) return false;
  const Coord reach = options.gantry_reach_nm.value_or(4 * limits::kMaxCoord);
  return a.box.min.y < b.box.max.y + reach && b.box.min.y < a.box.max.y + reach;
}

absl::Status Collide(std::span<const SequenceItem> items, size_t a, size_t b,
                     std::string_view rule) {
  const std::string_view why = rule == "gantry" ? "are both higher than extruder_clearance_height"
                               : rule == "lid"
                                   ? "are both higher than extruder_clearance_height_to_lid"
                                   : "are closer than extruder_clearance_radius";
  return MakeError(kInvalid, Reason::kObjectsCollide,
                   fmt::format("'{}' and '{}' cannot be printed one after the other: they {}",
                               items[a].name, items[b].name, why),
                   {{"first", items[a].name},
                    {"second", items[b].name},
                    {"first_index", std::to_string(a)},
                    {"second_index", std::to_string(b)},
                    {"rule", std::string(rule)}});
}

absl::Status CheckPairs(std::span<const SequenceItem> items, const std::vector<Standing>& all,
                        const SequenceOptions& options) {
  for (size_t i = 0; i < all.size(); ++i)
    for (size_t j = i + 1; j < all.size(); ++j) {
      if (TooNear(all[i], all[j], options)) return Collide(items, i, j, "clearance");
      if (GantryMeets(all[i], all[j], options)) return Collide(items, i, j, "gantry");
      if (all[i].meets_lid && all[j].meets_lid) return Collide(items, i, j, "lid");
    }
  return absl::OkStatus();
}

/// Short path through points from `start`, to `end` if given.
class Tour {
 public:
  Tour(Point start, std::optional<Point> end) : start_(start), end_(end) {}

  std::vector<Standing> Through(std::vector<Standing> stops) {
    stops_ = std::move(stops);
    NearestNeighbour();
    for (int pass = 0; pass < kMostPasses && ReverseParts(); ++pass) continue;
    return std::move(stops_);
  }

 private:
  void NearestNeighbour() {
    Point at = start_;
    for (size_t i = 0; i < stops_.size(); ++i) {
      const auto next =
          std::min_element(stops_.begin() + i, stops_.end(), [&](const auto& a, const auto& b) {
            return Distance(at, a.middle) < Distance(at, b.middle);
          });
      std::rotate(stops_.begin() + i, next, next + 1);  // keeps the order of the rest
      at = stops_[i].middle;
    }
  }

  /// Runs one pass of 2-opt. Returns true if the path became shorter.
  bool ReverseParts() {
    bool found = false;
    for (size_t i = 0; i + 1 < stops_.size(); ++i)
      for (size_t j = i + 1; j < stops_.size(); ++j) {
        if (Gain(i, j) < kTolerance) continue;
        std::reverse(stops_.begin() + i, stops_.begin() + j + 1);
        found = true;
      }
    return found;
  }

  /// Returns the length saved by reversing stops i..j, in nm.
  double Gain(size_t i, size_t j) const {
    const Point before = i == 0 ? start_ : stops_[i - 1].middle;
    const Point first = stops_[i].middle, last = stops_[j].middle;
    const std::optional<Point> after =
        j + 1 < stops_.size() ? std::optional(stops_[j + 1].middle) : end_;
    double gain = Distance(before, first) - Distance(before, last);
    if (after) gain += Distance(last, *after) - Distance(first, *after);
    return gain;
  }

  Point start_;
  std::optional<Point> end_;
  std::vector<Standing> stops_;
};

/// Returns the order as indices: groups in ascending order of height, each group along a short
/// path.
std::vector<size_t> Ordered(const std::vector<Standing>& all, Point start) {
  std::array<std::vector<Standing>, kGroups> groups;
  for (const Standing& standing : all)
    groups[static_cast<size_t>(standing.Group())].push_back(standing);
  std::vector<size_t> order;
  Point at = start;
  for (size_t i = 0; i < groups.size(); ++i) {
    std::ranges::sort(groups[i], {},
                      [](const Standing& s) { return std::pair(s.middle, s.index); });
    // The start of the next group is known in advance only if it has just one object.
    const auto next = std::find_if(groups.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                   groups.end(), [](const auto& group) { return !group.empty(); });
    const std::optional<Point> end = next != groups.end() && next->size() == 1
                                         ? std::optional(next->front().middle)
                                         : std::nullopt;
    for (const Standing& stop : Tour(at, end).Through(std::move(groups[i]))) {
      order.push_back(stop.index);
      at = stop.middle;
    }
  }
  return order;
}

}  // namespace

absl::StatusOr<std::vector<size_t>> PrintSequence(std::span<const SequenceItem> items,
                                                  const SequenceOptions& options) {
  if (absl::Status status = Check(items, options); !status.ok()) return status;
  std::vector<Standing> all = AllStanding(items, options);
  if (absl::Status status = CheckPairs(items, all, options); !status.ok()) return status;
  return Ordered(all, options.start);
}

}  // namespace slicefarm::planning
