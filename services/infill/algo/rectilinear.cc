#include "services/infill/algo/rectilinear.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "common/geometry/offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/scan_lines.h"
#include "services/infill/algo/serpentine.h"

namespace slicefarm::infill {
namespace {

/// Ends that lie farther apart along the edge than this many pitches are not joined.
constexpr double kMaxLinkPitches = 1.6;
/// Pieces shorter than this many widths hold nothing.
constexpr double kMinLengthWidths = 1.0;

absl::Status AppendFamily(const MultiPolygon& area, const LineFamily& family,
                          const SparseFill& fill, std::vector<Path>& paths) {
  const auto lines = CutLines(area, family);
  if (!lines.ok()) return lines.status();
  const SerpentineOptions options{
      .monotonic = false,
      .max_link_nm = kMaxLinkPitches * family.pitch_nm,
      .min_length_nm = kMinLengthWidths * static_cast<double>(fill.width_nm)};
  for (SerpentinePath& line : Serpentine(*lines, options)) {
    Path& path = paths.emplace_back();
    path.feature = Feature::kInternalInfill;
    path.points = std::move(line.points);
    path.widths_nm = {fill.width_nm};
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::vector<Path>> FillSparse(const MultiPolygon& region, const SparseFill& fill) {
  std::vector<Path> paths;
  if (region.empty() || fill.density <= 0) return paths;
  const Coord spacing = Spacing(fill.width_nm, fill.height_nm);
  const MultiPolygon area = Offset(region, -std::max<Coord>(0, spacing / 2 - fill.overlap_nm));
  const double pitch = static_cast<double>(spacing) / std::min(1.0, fill.density);
  const bool grid = fill.pattern == SparsePattern::kGrid;
  const bool turned = !grid && fill.layer_index % 2 != 0;
  LineFamily family{fill.angle_rad + (turned ? std::numbers::pi / 2 : 0), 0,
                    grid ? 2 * pitch : pitch};
  if (absl::Status status = AppendFamily(area, family, fill, paths); !status.ok()) return status;
  if (!grid) return paths;
  family.angle_rad += std::numbers::pi / 2;
  if (absl::Status status = AppendFamily(area, family, fill, paths); !status.ok()) return status;
  return paths;
}

}  // namespace slicefarm::infill
