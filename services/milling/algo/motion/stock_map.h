#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/base/cancel_token.h"
#include "common/model/options/cutter.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// The stock that is left, as a map of heights at the middles of square pixels.
class StockMap {
 public:
  /// Cost: a drop of a needle for each pixel, of a stock that is no box; once cancelled, the rest
  /// is left as high as the box: ask the token.
  StockMap(const MillingJob& job, double pixel_mm, const CancelToken& cancel = {});

  /// Takes away what the cutter meets on a straight way of its tip. A way that slopes is taken in
  /// steps of 0.02 mm at their higher ends: rather too little goes.
  /// Cost: 1 ns for each pixel under the way that is lower, 10 ns for each other.
  void Cut(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm);

  /// The least height of the tip at a place at which the cutter, wider by `wider_mm` on all sides,
  /// meets nothing; the floor where there is nothing.
  double RestHeight(const Eigen::Vector2d& place_mm, double wider_mm) const;

  /// Whether the cutter with its tip there, wider by `wider_mm`, is in stock by more than 0.1 um.
  bool Meets(const Eigen::Vector3d& tip_mm, double wider_mm) const;

  /// RestHeight over a straight way: no place of it is missed that is wider than the pixels.
  double RestHeightOver(const Eigen::Vector2d& from_mm, const Eigen::Vector2d& to_mm) const;

  /// Of all that Cut took away since the beginning.
  double removed_mm3() const { return removed_mm3_; }
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

/// Pixels fine enough for a cutter, and no more than four million.
double StockPixelMm(const MillingJob& job);

}  // namespace slicefarm::milling
