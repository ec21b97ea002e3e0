#include "services/exposure/algo/scan/ring_scan.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "services/exposure/algo/scan/block_order.h"
#include "services/exposure/algo/scan/convex_rings.h"
#include "services/exposure/algo/scan/layer_shift.h"
#include "services/exposure/algo/scan/ring_starts.h"
#include "services/exposure/algo/scan/scan_pieces.h"

namespace slicefarm::exposure {
namespace {

constexpr double kMayBeOpen = 0.001;

/// Rotates a closed line so that it starts at its corner nearest to `from`. The tip of a spur is
/// never the start: it is outside the piece, and the line to it may leave the region.
void StartNear(Point from, Polyline& ring) {
  ring.pop_back();
  const size_t size = ring.size();
  size_t nearest = 0;
  for (size_t i = 1; i < size; ++i) {
    const bool is_tip = ring[i - 1] == ring[(i + 1) % size];
    if (!is_tip && Distance(ring[i], from) < Distance(ring[nearest], from)) nearest = i;
  }
  std::rotate(ring.begin(), ring.begin() + static_cast<ptrdiff_t>(nearest), ring.end());
  ring.push_back(ring.front());
}

RingFill FillOf(const ExposureOptions& options) {
  const double pitch = static_cast<double>(options.hatch_distance_nm);
  const double first = (pitch - static_cast<double>(options.ring_overlap_nm)) / 2;
  // The outermost ring is `contour_distance_nm` inside of the last contour. A spine that no ring
  // surrounds must only be inside the last contour.
  const double offset =
      options.contours == 0 ? 0 : static_cast<double>(options.contour_distance_nm);
  return {.pitch_nm = pitch,
          .first_nm = first,
          .corners = options.fill_corners,
          .spurs = {.spot_nm = static_cast<double>(options.spot_nm),
                    .least_nm = static_cast<double>(options.minimum_vector_nm)},
          .spine_gap_nm = std::max(0.0, first - offset)};
}

/// Returns `fill` with the layer's choice of rings that melt some area twice (RingTurn). If this
/// would leave a larger share than kMayBeOpen unmelted, returns `fill` unchanged.
RingFill TurnedFill(const Polygon& piece, double scale, RingFill fill, int32_t layer,
                    const ExposureOptions& options) {
  const bool may = OpenShare(ConvexRingOf(piece, scale), fill.pitch_nm, fill.spurs) <= kMayBeOpen;
  if (options.turn_rings && may) fill.turn = RingTurnOf(layer);
  return fill;
}

/// Makes each line of a piece begin near the end of the previous line.
void StartOneAfterAnother(std::vector<Polyline>& rings) {
  for (size_t i = 1; i < rings.size(); ++i)
    if (rings[i].size() > 2) StartNear(rings[i - 1].back(), rings[i]);
}

/// Reverses an open line (spine) if it then begins nearer to the previous line or ends nearer to
/// the next one.
void TurnSpines(std::vector<Polyline>& rings) {
  if (rings.size() < 2) return;
  for (size_t i = 0; i < rings.size(); ++i) {
    if (rings[i].size() > 2) continue;
    const Point near = i == 0 ? rings[1].front() : rings[i - 1].back();
    const bool front_is_nearer = Distance(near, rings[i][0]) < Distance(near, rings[i][1]);
    if (front_is_nearer == (i == 0)) std::swap(rings[i][0], rings[i][1]);
  }
}

/// Returns the lines of one piece, in order.
std::vector<Polyline> PieceLines(const Polygon& piece, double scale, const RingFill& fill,
                                 const ExposureOptions& options, int32_t layer) {
  std::vector<Polyline> rings =
      ConvexRings(piece, scale, TurnedFill(piece, scale, fill, layer, options));
  std::erase_if(rings, [&](const Polyline& ring) {
    return Length(ring) < static_cast<double>(options.minimum_vector_nm);
  });
  if (options.turn_rings) StartAtShare(rings, RingStart(layer));
  if (options.strategy == ScanStrategy::kRings) std::reverse(rings.begin(), rings.end());
  if (!options.turn_rings) StartOneAfterAnother(rings);
  TurnSpines(rings);
  if (!options.link_rings || rings.size() < 2) return rings;
  Polyline linked;
  for (const Polyline& ring : rings) linked.insert(linked.end(), ring.begin(), ring.end());
  return {std::move(linked)};
}

}  // namespace

absl::Status ScanByRings(const MultiPolygon& region, const ExposureOptions& options, int32_t layer,
                         Point from, const CancelToken& cancel, ExposureGroup& group,
                         CutCounts& counts) {
  if (region.empty()) return absl::OkStatus();
  const auto pieces = ScanPieces(region, options.decompose, CutVariant(layer, options), cancel);
  if (!pieces.ok()) return pieces.status();
  counts.Add(pieces->counts);
  RingFill fill = FillOf(options);
  const BorderGrid border(region, std::max(fill.spine_gap_nm, SpurReach(fill.first_nm)));
  fill.border = &border;
  const double scale = static_cast<double>(pieces->scale);
  std::vector<std::vector<Polyline>> scans;
  std::vector<ScanBlock> blocks;
  blocks.reserve(pieces->pieces.size());
  for (const Polygon& piece : pieces->pieces) {
    std::vector<Polyline> lines = PieceLines(piece, scale, fill, options, layer);
    if (lines.empty()) continue;
    blocks.push_back({.start = lines.front().front(),
                      .end = lines.back().back(),
                      .middle = MiddleOf(Bounds(piece)),
                      .odd = blocks.size() % 2 == 1});
    scans.push_back(std::move(lines));
  }
  for (const BlockTurn& turn : OrderBlocks(blocks, options.jump_order, from, options.gas_flow_deg))
    for (const Polyline& line : scans[turn.block]) group.AddLine(line);
  return absl::OkStatus();
}

}  // namespace slicefarm::exposure
