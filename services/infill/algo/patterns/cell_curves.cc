#include "services/infill/algo/patterns/cell_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/frame_box.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

/// Orders of the curves: 2^kHilbertOrder and 3^kPeanoOrder cells along a side. Patterns with lines
/// closer than kMaxCoord divided by this number would not reach a job's edge, but no bead is so
/// narrow.
constexpr int kHilbertOrder = 20;
constexpr int kPeanoOrder = 13;

/// Cell, or step between cells.
struct Cell {
  int64_t i = 0;
  int64_t j = 0;

  friend Cell operator+(Cell a, Cell b) { return {a.i + b.i, a.j + b.j}; }
  friend Cell operator*(int64_t k, Cell a) { return {k * a.i, k * a.j}; }
  friend Cell operator-(Cell a) { return {-a.i, -a.j}; }
};

/// Walk along a curve through the cells near a region. Squares far from the region are skipped.
class CellWalker {
 public:
  CellWalker(const MultiPolygon& region, const PatternContext& context)
      : frame_(context.angle_rad), box_(BoxIn(frame_, region)), pitch_(context.pitch_nm) {}

  absl::Status Check() const {
    return CheckLineCount(((box_.max_u - box_.min_u) / pitch_ + 3) *
                          ((box_.max_v - box_.min_v) / pitch_ + 3));
  }

  /// Follows the Hilbert curve through a square of 2^order cells per side. `corner` is the square's
  /// first cell. The square extends from it along `along` and `across`. The curve runs from
  /// `corner` to the end of the side in the direction `along`.
  void Hilbert(int order, Cell corner, Cell along, Cell across) {
    const int64_t size = int64_t{1} << order;
    if (IsFar(corner, along, across, size)) return;
    if (order == 0) return Visit(corner);
    const int64_t half = size / 2;
    Hilbert(order - 1, corner, across, along);
    Hilbert(order - 1, corner + half * across, along, across);
    Hilbert(order - 1, corner + half * across + half * along, along, across);
    Hilbert(order - 1, corner + (size - 1) * along + (half - 1) * across, -across, -along);
  }

  /// Follows the Peano curve through a square of 3^order cells per side, from `corner` to the
  /// opposite corner: three columns of three squares, up, down and up.
  void Peano(int order, int64_t size, Cell corner, Cell along, Cell across) {
    if (IsFar(corner, along, across, size)) return;
    if (order == 0) return Visit(corner);
    const int64_t third = size / 3;
    Cell along_now = along;
    Cell across_now = across;
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        Peano(order - 1, third, corner, along_now, across_now);
        // The curve ended in the opposite corner of its square. The next square begins one cell
        // further.
        const Cell end = corner + (third - 1) * along_now + (third - 1) * across_now;
        if (row < 2) {
          corner = end + across_now;
          along_now = -along_now;
        } else {
          corner = end + along;
          // Columns begin with the square's own direction `along`, and reverse `across`.
          across_now = -across_now;
          along_now = along;
        }
      }
    }
  }

  std::vector<Curve> Take() {
    Flush();
    return std::move(curves_);
  }

 private:
  bool IsFar(Cell corner, Cell along, Cell across, int64_t size) const {
    const Cell far = corner + (size - 1) * along + (size - 1) * across;
    const auto [i0, i1] = std::minmax(corner.i, far.i);
    const auto [j0, j1] = std::minmax(corner.j, far.j);
    return (static_cast<double>(i1) + 2) * pitch_ < box_.min_u ||
           (static_cast<double>(i0) - 1) * pitch_ > box_.max_u ||
           (static_cast<double>(j1) + 2) * pitch_ < box_.min_v ||
           (static_cast<double>(j0) - 1) * pitch_ > box_.max_v;
  }

  void Visit(Cell cell) {
    if (!cells_.empty()) {
      const Cell last = cells_.back();
      if (std::abs(cell.i - last.i) + std::abs(cell.j - last.j) != 1) Flush();
    }
    cells_.push_back(cell);
  }

  void Flush() {
    if (cells_.size() >= 2) {
      Curve& curve = curves_.emplace_back();
      for (size_t k = 0; k < cells_.size(); ++k) {
        const bool inner = k > 0 && k + 1 < cells_.size();
        if (inner && cells_[k - 1].i + cells_[k + 1].i == 2 * cells_[k].i &&
            cells_[k - 1].j + cells_[k + 1].j == 2 * cells_[k].j)
          continue;  // not a corner
        curve.points.push_back(frame_.At((static_cast<double>(cells_[k].i) + 0.5) * pitch_,
                                         (static_cast<double>(cells_[k].j) + 0.5) * pitch_));
      }
    }
    cells_.clear();
  }

  const LineAxes frame_;
  const FrameBox box_;
  const double pitch_;
  std::vector<Cell> cells_;
  std::vector<Curve> curves_;
};

}  // namespace

absl::StatusOr<std::vector<Piece>> Hilbert(const MultiPolygon& region,
                                           const PatternContext& context) {
  if (region.empty()) return std::vector<Piece>{};
  CellWalker walker(region, context);
  if (absl::Status ok = walker.Check(); !ok.ok()) return ok;
  const int64_t low = -(int64_t{1} << (kHilbertOrder - 1));
  walker.Hilbert(kHilbertOrder, {low, low}, {1, 0}, {0, 1});
  return ClipCurves(region, walker.Take());
}

absl::StatusOr<std::vector<Piece>> Peano(const MultiPolygon& region,
                                         const PatternContext& context) {
  if (region.empty()) return std::vector<Piece>{};
  CellWalker walker(region, context);
  if (absl::Status ok = walker.Check(); !ok.ok()) return ok;
  int64_t size = 1;
  for (int i = 0; i < kPeanoOrder; ++i) size *= 3;
  walker.Peano(kPeanoOrder, size, {-size / 2, -size / 2}, {1, 0}, {0, 1});
  return ClipCurves(region, walker.Take());
}

}  // namespace slicefarm::infill
