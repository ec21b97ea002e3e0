#include "services/infill/algo/patterns/voronoi.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "services/infill/algo/cells/cell_strands.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/frame_box.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

/// Number of cells along a tile's side: 70 mm at 20 %.
constexpr int kTileCells = 16;
/// Number of Lloyd rounds. More rounds would make no visible difference, and the cells are not yet
/// a honeycomb.
constexpr int kLloydRounds = 40;
constexpr int kMostSizeSteps = 60;

const StrandTile& TileOfCells() {
  static const auto& tile = *new StrandTile(RelaxedCells(kTileCells, kLloydRounds));
  return tile;
}

double LengthOf(const std::vector<Strand>& strands) {
  double length = 0;
  for (const Strand& strand : strands) {
    for (size_t i = 1; i < strand.points.size(); ++i) {
      const double u = strand.points[i].x() - strand.points[i - 1].x();
      const double v = strand.points[i].y() - strand.points[i - 1].y();
      length += std::sqrt(u * u + v * v);
    }
  }
  return length;
}

/// Strands of a tile, with a total length of the tile's area / pitch.
struct SizedTile {
  double size_nm = 0;
  std::vector<Strand> strands;
};
SizedTile TileFor(double pitch_nm, double gap_nm) {
  const StrandTile& tile = TileOfCells();
  SizedTile sized{LengthOf(tile.Strands(0)) * pitch_nm, {}};
  for (int i = 0; i < kMostSizeSteps; ++i) {
    sized.strands = tile.Strands(gap_nm / sized.size_nm);
    const double before = sized.size_nm;
    // The mean with the previous size converges to the same size, and cannot oscillate.
    sized.size_nm = (before + LengthOf(sized.strands) * pitch_nm) / 2;
    if (std::abs(sized.size_nm - before) < 1) break;
  }
  return sized;
}

/// Copies of a tile near a region, and the curves of their strands there.
class NearStrands {
 public:
  NearStrands(const SizedTile& tile, const LineAxes& frame, const FrameBox& box)
      : tile_(tile),
        frame_(frame),
        box_{box.min_u / tile.size_nm, box.max_u / tile.size_nm, box.min_v / tile.size_nm,
             box.max_v / tile.size_nm},
        first_u_(static_cast<int32_t>(std::floor(box_.min_u)) - 2),
        first_v_(static_cast<int32_t>(std::floor(box_.min_v)) - 2),
        columns_(static_cast<int32_t>(std::floor(box_.max_u)) + 3 - first_u_),
        rows_(static_cast<int32_t>(std::floor(box_.max_v)) + 3 - first_v_) {}

  static double CountOf(const SizedTile& tile, const FrameBox& box) {
    return ((box.max_u - box.min_u) / tile.size_nm + 4) *
           ((box.max_v - box.min_v) / tile.size_nm + 4) * static_cast<double>(tile.strands.size());
  }

  std::vector<Curve> Curves() {
    near_.resize(static_cast<size_t>(columns_) * static_cast<size_t>(rows_) * tile_.strands.size());
    for (int32_t row = 0; row < rows_; ++row)
      for (int32_t column = 0; column < columns_; ++column) MarkNear(column, row);
    std::vector<Curve> curves;
    for (const bool loops : {false, true}) {
      for (int32_t row = 0; row < rows_; ++row) {
        for (int32_t column = 0; column < columns_; ++column) {
          for (int32_t strand = 0; strand < static_cast<int32_t>(tile_.strands.size()); ++strand)
            for (const int32_t end : {0, 1}) Begin({strand, end, column, row}, loops, curves);
        }
      }
    }
    return curves;
  }

 private:
  /// Strand of a copy, entered at one of its ends.
  struct At {
    int32_t strand = 0;
    int32_t end = 0;
    int32_t column = 0;
    int32_t row = 0;
  };

  size_t IndexOf(const At& at) const {
    const auto tile = static_cast<size_t>(at.row) * static_cast<size_t>(columns_) +
                      static_cast<size_t>(at.column);
    return tile * tile_.strands.size() + static_cast<size_t>(at.strand);
  }
  bool IsNear(const At& at) const {
    return at.column >= 0 && at.column < columns_ && at.row >= 0 && at.row < rows_ &&
           near_[IndexOf(at)] != 0;
  }

  void MarkNear(int32_t column, int32_t row) {
    const double u = first_u_ + column, v = first_v_ + row;
    for (int32_t strand = 0; strand < static_cast<int32_t>(tile_.strands.size()); ++strand) {
      FrameBox reach;
      for (const Vector2& p : tile_.strands[static_cast<size_t>(strand)].points) {
        reach.min_u = std::min(reach.min_u, p.x() + u),
        reach.max_u = std::max(reach.max_u, p.x() + u);
        reach.min_v = std::min(reach.min_v, p.y() + v),
        reach.max_v = std::max(reach.max_v, p.y() + v);
      }
      near_[IndexOf({strand, 0, column, row})] =
          reach.max_u >= box_.min_u && reach.min_u <= box_.max_u && reach.max_v >= box_.min_v &&
          reach.min_v <= box_.max_v;
    }
  }

  At NextOf(const At& at) const {
    const Strand::Next& next =
        tile_.strands[static_cast<size_t>(at.strand)].next[static_cast<size_t>(at.end ^ 1)];
    return {next.strand, next.end, at.column + next.step_u, at.row + next.step_v};
  }

  /// Follows a curve from the point where it enters the surroundings of the region. A curve that
  /// never leaves them (`loops`) may start at any strand.
  void Begin(At at, bool loops, std::vector<Curve>& curves) {
    if (!IsNear(at)) return;
    const At before = NextOf({at.strand, at.end ^ 1, at.column, at.row});
    if (!loops && IsNear(before)) return;
    Curve& curve = curves.emplace_back();
    curve.closed = loops;
    if (!loops) Append(at, 0, curve.points);
    while (IsNear(at)) {
      near_[IndexOf(at)] = 0;
      Append(at, 1, curve.points);
      Append(at, 2, curve.points);
      const At next = NextOf(at);
      if (!loops && !IsNear(next)) Append(at, 3, curve.points);
      at = next;
    }
    if (curve.closed && curve.points.size() > 1 && curve.points.front() == curve.points.back())
      curve.points.pop_back();
  }

  /// Appends the strand's point `i`, counted from the end at which the strand was entered.
  void Append(const At& at, size_t i, Polyline& points) const {
    const Vector2 p = tile_.strands[static_cast<size_t>(at.strand)].points[at.end == 0 ? i : 3 - i];
    const Point q = frame_.At((p.x() + first_u_ + at.column) * tile_.size_nm,
                              (p.y() + first_v_ + at.row) * tile_.size_nm);
    if (points.empty() || points.back() != q) points.push_back(q);
  }

  const SizedTile& tile_;
  const LineAxes& frame_;
  const FrameBox box_;  ///< box of the region, in tiles
  const int32_t first_u_, first_v_, columns_, rows_;
  /// 1 for strands near the region and not yet in a curve, by copy and strand.
  std::vector<char> near_;
};

}  // namespace

absl::StatusOr<std::vector<Piece>> Voronoi(const MultiPolygon& region,
                                           const PatternContext& context) {
  if (region.empty()) return std::vector<Piece>{};
  const LineAxes frame(context.angle_rad);
  const FrameBox box = BoxIn(frame, region);
  const SizedTile tile = TileFor(context.pitch_nm, static_cast<double>(context.spacing_nm));
  if (absl::Status ok = CheckLineCount(NearStrands::CountOf(tile, box)); !ok.ok()) return ok;
  return ClipCurves(region, NearStrands(tile, frame, box).Curves());
}

}  // namespace slicefarm::infill
