#include "services/slicing/algo/placement/copy_positions.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "absl/strings/escaping.h"
#include "absl/strings/str_join.h"
#include "common/base/error.h"
#include "common/geometry/moved.h"
#include "services/slicing/algo/placement/build_volume.h"

namespace slicefarm::slicing {
namespace {

using Place = CopyInput::Place;
using Positions = std::vector<std::vector<Point>>;

constexpr Coord kUm = 1'000;

Coord ToWholeUm(Coord nm) { return (nm >= 0 ? nm + kUm / 2 : nm - kUm / 2) / kUm * kUm; }
Point ToWholeUm(Point p) { return {ToWholeUm(p.x), ToWholeUm(p.y)}; }

/// Copy without a given position.
struct Free {
  size_t object = 0;
  size_t copy = 0;
};

/// Returns the error for copies that do not fit. `copies`: number of all copies, including the ones
/// with a given position. `options`: settings of the bed.
absl::Status NoRoom(std::span<const ObjectToPlace> objects, const std::vector<Free>& free,
                    const std::vector<size_t>& left_over, size_t copies,
                    const SlicingOptions& options) {
  std::map<size_t, int> counts;  // number of copies per object
  for (const size_t item : left_over) ++counts[free[item].object];
  std::vector<std::string> which;
  for (const auto& [object, count] : counts) {
    which.push_back(fmt::format("{} of {}", count, ObjectWords(objects[object].name, object)));
  }
  std::vector<std::string> outside;
  if (!options.excluded.empty()) outside.emplace_back(" outside of bed_exclude_area");
  if (!options.wrapping.empty()) outside.emplace_back(" outside of wrapping_exclude_area");
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfBuildVolume,
                   fmt::format("{} of {} copies do not fit on the bed{}: {}", left_over.size(),
                               copies, absl::StrJoin(outside, " and"), absl::StrJoin(which, ", ")),
                   {{"limit", fmt::format("{}", copies - left_over.size())},
                    {"got", fmt::format("{}", copies)}});
}

/// Arranges the copies of `free` around the copies with a given position.
absl::Status ArrangeFree(std::span<const ObjectToPlace> objects, const std::vector<Free>& free,
                         const std::vector<FixedFootprint>& standing, const SlicingOptions& options,
                         const CancelToken& cancel, Positions& places) {
  std::vector<ArrangeItem> items;
  items.reserve(free.size());
  for (const Free& copy : free) items.push_back({objects[copy.object].footprint});
  ArrangeOptions arrange = ArrangeOptionsOf(options);
  arrange.max_plates = 1;
  absl::StatusOr<Arrangement> arranged = Arrange(items, standing, arrange, cancel);
  if (!arranged.ok()) return arranged.status();
  if (!arranged->left_over.empty())
    return NoRoom(objects, free, arranged->left_over, free.size() + standing.size(), options);
  for (size_t i = 0; i < free.size(); ++i)
    places[free[i].object][free[i].copy] = arranged->places[i]->translation;
  return absl::OkStatus();
}

/// Returns true if the settings place parts elsewhere than in the middle of the bed.
bool HasPlace(const SlicingOptions& options) {
  return options.best_x != 0.5 || options.best_y != 0.5;
}

bool FitsInTheMiddle(const ObjectToPlace& object, const SlicingOptions& options) {
  return !HasPlace(options) &&
         !MeetsExcluded(object.footprint, ToWholeUm(BedCenter(options.bed)),
                        ArrangeOptionsOf(options).bed_margin_nm, AllExcluded(options));
}

}  // namespace

std::string ObjectWords(std::string_view name, size_t object) {
  if (name.empty()) return fmt::format("object {} (without a name)", object + 1);
  return fmt::format("\"{}\"", absl::Utf8SafeCEscape(std::string(name)));
}

ArrangeOptions ArrangeOptionsOf(const SlicingOptions& options) {
  Coord growth = 0;
  for (const ObjectSlicingOptions& object : options.objects)
    growth = std::max(growth, object.xy_compensation_nm);
  return {.bed = options.bed,
          .distance_nm = std::max(options.part_distance_nm, options.clearance_radius_nm),
          .excluded = AllExcluded(options),
          .bed_margin_nm = growth,
          .middle_x = std::clamp(options.best_x, 0.0, 1.0),
          .middle_y = std::clamp(options.best_y, 0.0, 1.0)};
}

absl::StatusOr<Positions> PlaceCopies(std::span<const ObjectToPlace> objects,
                                      const SlicingOptions& options, const CancelToken& cancel) {
  Positions places(objects.size());
  std::vector<Free> free;
  std::vector<FixedFootprint> standing;
  for (size_t i = 0; i < objects.size(); ++i) {
    for (const CopyInput& copy : objects[i].copies) {
      if (copy.place == Place::kAnywhere) {
        free.push_back({i, places[i].size()});
        places[i].push_back(ToWholeUm(BedCenter(options.bed)));
        continue;
      }
      const Point offset = copy.place == Place::kOriginAt ? objects[i].middle : Point{};
      places[i].push_back(ToWholeUm(copy.at + offset));
      if (objects[i].footprint.size() >= 3)
        standing.push_back({Moved(objects[i].footprint, places[i].back())});
    }
  }
  const bool alone = free.size() == 1 && standing.empty();
  if (free.empty() || (alone && FitsInTheMiddle(objects[free[0].object], options))) return places;
  if (absl::Status ok = ArrangeFree(objects, free, standing, options, cancel, places); !ok.ok())
    return ok;
  return places;
}

}  // namespace slicefarm::slicing
