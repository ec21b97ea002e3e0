#include "services/exposure/algo/scan/inside.h"

#include <algorithm>

#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {
namespace {

/// Returns the distance from the outline to the innermost contour.
Coord LastContour(const ExposureOptions& options) {
  return options.beam_compensation_nm +
         std::max(options.contours - 1, 0) * options.contour_distance_nm;
}

}  // namespace

Coord InsideInset(const ExposureOptions& options, int32_t border_lines) {
  const bool rings = IsRings(options.strategy);
  Coord inset = LastContour(options) + border_lines * options.hatch_distance_nm;
  if (options.contours > 0)
    inset += rings ? options.contour_distance_nm : options.hatch_offset_nm - HatchTrim(options);
  return rings ? inset - (options.hatch_distance_nm - options.ring_overlap_nm) / 2 : inset;
}

std::vector<Coord> BorderInsets(const ExposureOptions& options, int32_t border_lines) {
  std::vector<Coord> insets;
  for (int32_t i = 1; i <= border_lines; ++i)
    insets.push_back(LastContour(options) + i * options.hatch_distance_nm);
  return insets;
}

Coord HatchTrim(const ExposureOptions& options) {
  if (options.contours == 0 || IsRings(options.strategy)) return 0;
  return std::min(options.hatch_offset_nm, options.spot_nm / 2);
}

Coord NarrowDepth(const ExposureOptions& options, int32_t border_lines) {
  if (HatchTrim(options) > 0) return InsideInset(options, border_lines) + HatchTrim(options);
  const auto levels = LineLevels(options, border_lines);
  return levels.empty() ? 0 : levels.back().line_nm;
}

std::vector<LineLevel> LineLevels(const ExposureOptions& options, int32_t border_lines) {
  std::vector<LineLevel> levels;
  const auto add = [&](Coord melted, Coord line) {
    if (line > melted) levels.push_back({melted, line});
  };
  const Coord half_spot = options.spot_nm / 2;
  add(0, options.beam_compensation_nm);
  for (int32_t i = 1; i < options.contours; ++i) {
    const Coord line = options.beam_compensation_nm + i * options.contour_distance_nm;
    add(line - options.contour_distance_nm + half_spot, line);
  }
  for (const Coord line : BorderInsets(options, border_lines))
    add(line - options.hatch_distance_nm + half_spot, line);
  if (options.contours > 0 && IsRings(options.strategy))
    add(LastContour(options) + half_spot, InsideInset(options));
  return levels;
}

}  // namespace slicefarm::exposure
