#include "processes/laser/job/scan_runs.h"

#include <algorithm>
#include <map>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/shared/shared_text.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/process.h"
#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm::coordinator {
namespace {

/// The longest run before and after lines with the laser off, and the setting that requests it.
struct LongestRun {
  Coord run_nm = 0;
  std::string setting;
};
LongestRun RunOf(std::span<const ExposureOptions> regions) {
  LongestRun longest;
  const auto add = [&](Coord run_nm, const char* setting) {
    if (run_nm > longest.run_nm) longest = {run_nm, setting};
  };
  for (const ExposureOptions& region : regions) {
    if (!IsRings(region.strategy)) add(region.skywriting_nm, "skywriting");
    add(region.contour_run_nm, "contour_run");
  }
  return longest;
}

/// Returns the bounding boxes of the area that contours can reach, by object. `exact`: insets the
/// outlines by the beam compensation; otherwise insets their bounding boxes.
std::map<int32_t, Box> ExposedBoxes(const SlicedOutlines& job, const ExposureSettings& exposure,
                                    bool exact) {
  std::map<int32_t, Box> boxes;
  for (const SlicedLayer& layer : job.layers)
    for (const ObjectSection& section : layer.sections)
      for (const Region& region : section.regions) {
        const Coord inset =
            exposure.regions[static_cast<size_t>(region.settings)].beam_compensation_nm;
        Box box = exact ? Bounds(FastOffset(region.outlines, -inset)) : Bounds(region.outlines);
        if (!exact && !box.Empty()) box = box.Grown(-inset);
        if (!box.Empty()) boxes[section.stack.object].Add(box);
      }
  return boxes;
}

Box OnPlate(const std::map<int32_t, Box>& boxes, std::span<const PlacedCopy> copies) {
  Box all;
  for (const PlacedCopy& copy : copies) {
    const auto box = boxes.find(copy.object);
    if (box == boxes.end()) continue;
    all.Add(box->second.min + copy.shift);
    all.Add(box->second.max + copy.shift);
  }
  return all;
}

}  // namespace

absl::Status CheckRuns(const ExposureSettings& settings, const Polygon& bed, const Box& exposed) {
  const auto [run_nm, setting] = RunOf(settings.regions);
  if (run_nm == 0 || exposed.Empty()) return absl::OkStatus();
  const Box around = exposed.Grown(run_nm);
  const Polygon corners = {
      around.min, {around.max.x, around.min.y}, around.max, {around.min.x, around.max.y}};
  const bool fits = std::ranges::all_of(
      corners, [&](Point corner) { return Locate(corner, bed) != Side::kOutside; });
  if (fits) return absl::OkStatus();
  const double run_mm = ToMm(static_cast<double>(run_nm));
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfBuildVolume,
                   absl::StrCat(setting, " = ", run_mm,
                                " mm moves the scanner off the bed: exposed areas must be at least "
                                "this far from the edge of the bed"),
                   {{"setting", setting}, {"value", absl::StrCat(run_mm)}});
}

absl::Status CheckRuns(const ExposureSettings& settings, const Polygon& bed,
                       const SlicedOutlines& job) {
  if (RunOf(settings.regions).run_nm == 0) return absl::OkStatus();
  const auto check = [&](bool exact) {
    return CheckRuns(settings, bed, OnPlate(ExposedBoxes(job, settings, exact), job.copies));
  };
  // The inset of a sharp corner is farther inside than the inset of the box. The cheap check of
  // boxes therefore suffices in most cases, and the exact check follows only if it fails.
  return check(false).ok() ? absl::OkStatus() : check(true);
}

}  // namespace slicefarm::coordinator
