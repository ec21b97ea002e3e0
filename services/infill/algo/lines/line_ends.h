#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Ends of the pieces of a line family inside a region: the same ends as in ScanLines, at less than
/// half its cost, without their places on the boundary.
class LineEnds {
 public:
  /// Cuts the lines of a family. Errors and cost: as CutLines.
  static absl::StatusOr<LineEnds> Of(const MultiPolygon& region, const LineFamily& family);

  /// Returns the first line of the family that meets the region, and the line after the last one.
  int64_t first() const { return first_; }
  int64_t last() const { return first_ + static_cast<int64_t>(begin_.size()) - 1; }

  /// Returns the u coordinates on a line of the family, in ascending order. Pieces begin at even
  /// indices and end at the odd ones after them.
  std::span<const double> On(int64_t line) const;

 private:
  struct End {
    int64_t line = 0;
    double u = 0;
  };

  void Sort(const std::vector<End>& ends);

  int64_t first_ = 0;
  std::vector<double> ends_;          ///< sorted by line, then by u
  std::vector<int32_t> begin_ = {0};  ///< index of each line's first end; one more than lines
};

}  // namespace slicefarm::infill
