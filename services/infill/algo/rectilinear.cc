#include "services/infill/algo/rectilinear.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "common/geometry/clean_offset.h"
#include "common/geometry/measure.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/edge_links.h"
#include "services/infill/algo/scan_lines.h"

namespace slicefarm::infill {
namespace {

/// Ends that lie farther apart along the edge than this many pitches are not joined.
constexpr double kMaxLinkPitches = 3;
/// Joints may bring a region's length this far over what its density asks for.
constexpr double kMostExcess = 0.028;
/// Where the grid lies beside the object's middle, in pitches. A grid through the middle meets both
/// halves of a symmetric part at like places. The models of tests/bench/README.md together have
/// 6 % fewer retractions with a quarter than with 0, and as much travel.
constexpr double kPhase = 0.25;

/// Pieces shorter than this many widths hold nothing.
constexpr double kMinLengthWidths = 1.0;

}  // namespace

absl::StatusOr<std::vector<Path>> FillSparse(const MultiPolygon& region, const SparseFill& fill) {
  std::vector<Path> paths;
  if (region.empty() || fill.density <= 0) return paths;
  const Coord spacing = Spacing(fill.width_nm, fill.height_nm);
  const MultiPolygon area = FastOffset(region, -std::max<Coord>(0, spacing / 2 - fill.overlap_nm));
  const double pitch = static_cast<double>(spacing) / std::min(1.0, fill.density);
  const bool grid = fill.pattern == SparsePattern::kGrid;
  const bool turned = !grid && fill.layer_index % 2 != 0;
  const double line_pitch = grid ? 2 * pitch : pitch;
  LineFamily family{fill.angle_rad + (turned ? std::numbers::pi / 2 : 0), kPhase * line_pitch,
                    line_pitch};
  std::vector<ScanLines> families;
  double length = 0;
  for (int i = 0; i < (grid ? 2 : 1); ++i) {
    auto lines = CutLines(area, family);
    if (!lines.ok()) return lines.status();
    length += lines->TotalLength();
    families.push_back(*std::move(lines));
    family.angle_rad += std::numbers::pi / 2;
  }
  // Where lines are few, chance may make them fewer than the area says; joints are not to make up
  // for that.
  const double expected = std::max(length, Area(area) / pitch);
  const EdgeLinkOptions options{
      .max_link_nm = kMaxLinkPitches * pitch,
      .link_budget_nm = (1 + kMostExcess) * Area(region) / pitch - expected,
      .min_length_nm = kMinLengthWidths * static_cast<double>(fill.width_nm)};
  for (Polyline& line : LinkAlongEdge(families, options)) {
    Path& path = paths.emplace_back();
    path.feature = Feature::kInternalInfill;
    path.points = std::move(line);
    path.widths_nm = {fill.width_nm};
  }
  return paths;
}

}  // namespace slicefarm::infill
