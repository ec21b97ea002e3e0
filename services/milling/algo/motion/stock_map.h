#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/base/cancel_token.h"
#include "common/model/options/cutter.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// Remaining stock, as a map of heights at the centres of square pixels.
class StockMap {
 public:
  /// Cost: O(pixels); if the stock is a mesh, each pixel costs a drop of a needle onto it. After
  /// cancellation, the remaining pixels have the height of the box, so callers must check the
  /// token.
  StockMap(const MillingJob& job, double pixel_mm, const CancelToken& cancel = {});

  /// Removes the stock that the cutter meets on a straight move of its tip. A sloping move is
  /// divided into steps of 0.02 mm. Each step is at the height of its higher end, so slightly too
  /// little is removed. Cost: 1 ns for each pixel under the move that is already low enough, 10 ns
  /// for each other pixel.
  void Cut(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm);

  /// Returns the lowest height of the tip at which the cutter, widened by `wider_mm` on all sides,
  /// touches no stock. Returns the floor (MillingJob::floor_mm) if no stock is below the cutter.
  double RestHeight(const Eigen::Vector2d& place_mm, double wider_mm) const;

  /// Returns true if the cutter with this tip position, widened by `wider_mm`, penetrates stock by
  /// more than 0.1 um.
  bool Meets(const Eigen::Vector3d& tip_mm, double wider_mm) const;

  /// Returns the largest RestHeight over a straight move. Obstacles narrower than a pixel may be
  /// missed.
  double RestHeightOver(const Eigen::Vector2d& from_mm, const Eigen::Vector2d& to_mm) const;

  /// Returns the total volume removed by Cut.
  double removed_mm3() const { return removed_mm3_; }
  /// Returns the side length of a pixel, in mm.
  double pixel_mm() const { return pixel_mm_; }

 private:
  struct Span {
    int from = 0;
    int to = -1;
  };
  Span RowsIn(double low, double high) const;
  Span ColumnsIn(double low, double high) const;
  double Rest(const Eigen::Vector2d& place, double wider, double least, double enough) const;
  void CutLevel(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double z);

  const Cutter cutter_;
  Eigen::Vector2d low_;
  double floor_mm_;
  double pixel_mm_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> heights_;
  double removed_mm3_ = 0;
};

/// Returns a pixel size that is fine enough for the job's cutter and gives at most four million
/// pixels.
double StockPixelMm(const MillingJob& job);

}  // namespace slicefarm::milling
