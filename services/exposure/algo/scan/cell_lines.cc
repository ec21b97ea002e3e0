#include "services/exposure/algo/scan/cell_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "processes/laser/model/exposure_options.h"
#include "services/exposure/algo/scan/scan_lines.h"

namespace slicefarm::exposure {
namespace {

/// Part of a hatch line in one cell.
struct CellLine {
  int32_t row = 0, column = 0;  ///< indices of the cell; stripes are all in row 0
  int32_t line = 0;
  double u0 = 0, u1 = 0;

  auto Key() const { return std::tuple(row, column, line, u0); }
};

/// Row of cells of equal width. Each cell extends by half of the overlap on either side.
struct CellRow {
  double width = 0;
  double half_overlap = 0;

  int32_t First(double at) const { return Index(at - half_overlap); }
  int32_t Last(double at) const { return Index(at + half_overlap); }
  double Low(int32_t cell) const { return cell * width - half_overlap; }
  double High(int32_t cell) const { return (cell + 1) * width + half_overlap; }
  bool Meets(int32_t cell, double low, double high) const {
    return high > cell * width && low < (cell + 1) * width;
  }

 private:
  int32_t Index(double at) const { return static_cast<int32_t>(std::floor(at / width)); }
};

/// Cuts a piece of a line at the cells' borders. Calls emit(cell, u0, u1) for each part in a cell
/// for which wanted(cell) is true.
template <typename Wanted, typename Emit>
void CutAtCells(const ScanPiece& piece, const CellRow& cells, double least, Wanted wanted,
                Emit emit) {
  for (int32_t cell = cells.First(piece.u0); cell <= cells.Last(piece.u1); ++cell) {
    // A piece that is only in the overlap of a cell is left to the neighbour cell.
    if (!wanted(cell) || !cells.Meets(cell, piece.u0, piece.u1)) continue;
    const double u0 = std::max(piece.u0, cells.Low(cell)),
                 u1 = std::min(piece.u1, cells.High(cell));
    if (u1 > u0 && u1 - u0 >= least) emit(cell, u0, u1);
  }
}

bool IsOdd(int64_t i) { return (i & 1) != 0; }

/// Hatch lines of one direction, for the odd or the even cells. Coordinates are in a frame with u
/// along the lines.
struct Family {
  LineAxes frame;
  LineGrid grid;
  bool odd = false;
  std::vector<CellLine> lines = {};
};

absl::Status FillStripes(const HatchRegion& region, const ExposureOptions& options,
                         Family& family) {
  const CellRow stripes{static_cast<double>(options.stripe_width_nm),
                        static_cast<double>(options.overlap_nm) / 2};
  const double least = static_cast<double>(options.minimum_vector_nm);
  auto pieces = CutTrimmedLines(region, family.frame, family.grid);
  if (!pieces.ok()) return pieces.status();
  family.lines.reserve(pieces->size());
  for (const ScanPiece& piece : *pieces) {
    CutAtCells(
        piece, stripes, least, [&](int32_t stripe) { return IsOdd(stripe) == family.odd; },
        [&](int32_t stripe, double u0, double u1) {
          family.lines.push_back({0, stripe, piece.line, u0, u1});
        });
  }
  return absl::OkStatus();
}

/// Adds the lines of islands. Rows and columns are in the family's own frame.
absl::Status FillIslands(const HatchRegion& region, const ExposureOptions& options,
                         Family& family) {
  const CellRow islands{static_cast<double>(options.island_width_nm),
                        static_cast<double>(options.overlap_nm) / 2};
  const double least = static_cast<double>(options.minimum_vector_nm);
  auto pieces = CutTrimmedLines(region, family.frame, family.grid);
  if (!pieces.ok()) return pieces.status();
  family.lines.reserve(pieces->size());
  for (const ScanPiece& piece : *pieces) {
    const double v = family.grid.V(piece.line);
    for (int32_t row = islands.First(v); row <= islands.Last(v); ++row) {
      CutAtCells(
          piece, islands, least,
          // The frame of the odd family is rotated by 90 degrees. Column c of the even family has
          // the row number -c - 1 in this frame. So odd cells of the plane have an even sum of row
          // and column here, and the same test selects them.
          [&](int32_t column) { return !IsOdd(int64_t{row} + column); },
          [&](int32_t column, double u0, double u1) {
            family.lines.push_back({row, column, piece.line, u0, u1});
          });
    }
  }
  return absl::OkStatus();
}

/// Appends each cell of a family as a block. `alternate`: consecutive lines of a block have
/// opposite directions.
void AppendBlocks(Family& family, bool alternate, LineBlocks& blocks) {
  std::sort(family.lines.begin(), family.lines.end(),
            [](const CellLine& a, const CellLine& b) { return a.Key() < b.Key(); });
  const auto same_cell = [](const CellLine& a, const CellLine& b) {
    return a.row == b.row && a.column == b.column;
  };
  for (size_t i = 0; i < family.lines.size();) {
    size_t end = i;
    while (end < family.lines.size() && same_cell(family.lines[i], family.lines[end])) ++end;
    blocks.begin.push_back(blocks.points.size());
    blocks.odd.push_back(family.odd);
    for (bool forward = true; i < end; forward = !forward || !alternate) {
      size_t last = i;  // end of the pieces of this line
      while (last < end && family.lines[last].line == family.lines[i].line) ++last;
      for (size_t k = i; k < last; ++k) {
        const CellLine& line = family.lines[forward ? k : i + last - 1 - k];
        const double v = family.grid.V(line.line);
        blocks.points.push_back(family.frame.At(forward ? line.u0 : line.u1, v));
        blocks.points.push_back(family.frame.At(forward ? line.u1 : line.u0, v));
      }
      i = last;
    }
  }
}

}  // namespace

absl::StatusOr<LineBlocks> CellBlocks(const HatchRegion& region, double angle_deg,
                                      const ExposureOptions& options) {
  const bool stripes = options.strategy == ScanStrategy::kStripes;
  const double pitch = static_cast<double>(options.hatch_distance_nm);
  LineBlocks blocks;
  for (const bool odd : {false, true}) {
    Family family{.frame = LineAxes::OfDegrees(odd && !stripes ? angle_deg + 90 : angle_deg),
                  .grid = {.pitch_nm = pitch, .phase = odd && stripes ? 0.5 : 0},
                  .odd = odd};
    const absl::Status status =
        stripes ? FillStripes(region, options, family) : FillIslands(region, options, family);
    if (!status.ok()) return status;
    AppendBlocks(family, options.alternate_directions, blocks);
  }
  if (!blocks.begin.empty()) blocks.begin.push_back(blocks.points.size());
  return blocks;
}

}  // namespace slicefarm::exposure
