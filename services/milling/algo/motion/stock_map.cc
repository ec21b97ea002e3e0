#include "services/milling/algo/motion/stock_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/base/span_log.h"
#include "services/milling/algo/drop/drop_cutter.h"

namespace slicefarm::milling {
namespace {

constexpr double kPixelsPerRadius = 16;
constexpr double kLeastPixelMm = 0.05;
constexpr double kMostPixels = 4e6;
constexpr double kSlopeStepMm = 0.02;
constexpr double kNeedleMm = 1e-3;
/// Smallest depth of a contact with stock that counts, because heights are single precision.
constexpr double kInStockMm = 1e-4;

}  // namespace

double StockPixelMm(const MillingJob& job) {
  const Eigen::Vector3d size = job.stock_box.sizes();
  return std::max({kLeastPixelMm, job.options.cutter.radius_mm() / kPixelsPerRadius,
                   std::sqrt(size.x() * size.y() / kMostPixels)});
}

StockMap::StockMap(const MillingJob& job, double pixel_mm, const CancelToken& cancel)
    : cutter_(job.options.cutter),
      low_(job.stock_box.min().head<2>()),
      floor_mm_(job.floor_mm),
      pixel_mm_(pixel_mm) {
  const Eigen::Vector3d size = job.stock_box.sizes();
  columns_ = std::max(1, static_cast<int>(std::ceil(size.x() / pixel_mm - 1e-6)));
  rows_ = std::max(1, static_cast<int>(std::ceil(size.y() / pixel_mm - 1e-6)));
  const double top = job.stock_box.max().z();
  heights_.assign(static_cast<size_t>(columns_) * rows_, static_cast<float>(top));
  if (job.stock_is_box) return;
  const Cutter needle = *Cutter::Cylinder(kNeedleMm);
  const DropCutter dropper(job.stock, needle);
  for (int row = 0; row < rows_ && !cancel.Cancelled(); ++row) {
    for (int column = 0; column < columns_; ++column) {
      const auto drop = dropper.At(low_ + pixel_mm_ * Eigen::Vector2d(column + 0.5, row + 0.5));
      heights_[static_cast<size_t>(row) * columns_ + column] =
          static_cast<float>(drop ? drop->z_mm : job.stock_box.min().z());
    }
  }
}

StockMap::Span StockMap::RowsIn(double low, double high) const {
  const double from = std::ceil((low - low_.y()) / pixel_mm_ - 0.5);
  const double to = std::floor((high - low_.y()) / pixel_mm_ - 0.5);
  return {static_cast<int>(std::clamp(from, 0.0, static_cast<double>(rows_))),
          static_cast<int>(std::clamp(to, -1.0, rows_ - 1.0))};
}

StockMap::Span StockMap::ColumnsIn(double low, double high) const {
  const double from = std::ceil((low - low_.x()) / pixel_mm_ - 0.5);
  const double to = std::floor((high - low_.x()) / pixel_mm_ - 0.5);
  return {static_cast<int>(std::clamp(from, 0.0, static_cast<double>(columns_))),
          static_cast<int>(std::clamp(to, -1.0, columns_ - 1.0))};
}

void StockMap::CutLevel(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double z) {
  const double radius = cutter_.radius_mm(), reach2 = radius * radius;
  const Eigen::Vector2d pass = to - from;
  const double length2 = pass.squaredNorm();
  const Span rows =
      RowsIn(std::min(from.y(), to.y()) - radius, std::max(from.y(), to.y()) + radius);
  for (int row = rows.from; row <= rows.to; ++row) {
    const double y = low_.y() + (row + 0.5) * pixel_mm_;
    double t0 = 0, t1 = 1;  // part of the move that may be within a radius of the row
    if (std::abs(pass.y()) > 1e-12) {
      const double p = (y - radius - from.y()) / pass.y(), q = (y + radius - from.y()) / pass.y();
      t0 = std::clamp(std::min(p, q), 0.0, 1.0), t1 = std::clamp(std::max(p, q), 0.0, 1.0);
    }
    const double x0 = from.x() + std::min(t0 * pass.x(), t1 * pass.x());
    const double x1 = from.x() + std::max(t0 * pass.x(), t1 * pass.x());
    const Span columns = ColumnsIn(x0 - radius, x1 + radius);
    float* heights = &heights_[static_cast<size_t>(row) * columns_];
    for (int column = columns.from; column <= columns.to; ++column) {
      if (heights[column] <= z) continue;
      const Eigen::Vector2d p(low_.x() + (column + 0.5) * pixel_mm_ - from.x(), y - from.y());
      const double t = length2 > 0 ? std::clamp(p.dot(pass) / length2, 0.0, 1.0) : 0;
      const double squared = (p - t * pass).squaredNorm();
      if (squared > reach2) continue;
      const auto height = static_cast<float>(z + cutter_.HeightAt(std::sqrt(squared)));
      if (height >= heights[column]) continue;
      removed_mm3_ += (heights[column] - height) * pixel_mm_ * pixel_mm_;
      heights[column] = height;
    }
  }
}

void StockMap::Cut(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm) {
  const double rise = std::abs(to_mm.z() - from_mm.z());
  const Eigen::Vector3d pass = to_mm - from_mm;
  if (pass.head<2>().squaredNorm() == 0) {
    CutLevel(from_mm.head<2>(), from_mm.head<2>(),
             std::max(floor_mm_, std::min(from_mm.z(), to_mm.z())));
    return;
  }
  const double steps = std::max(1.0, std::ceil(rise / kSlopeStepMm));
  Eigen::Vector3d at = from_mm;
  for (double k = 1; k <= steps; ++k) {
    const Eigen::Vector3d next = from_mm + pass * (k / steps);
    CutLevel(at.head<2>(), next.head<2>(), std::max(at.z(), next.z()));
    at = next;
  }
}

/// Returns the rest height (RestHeight), at least `least`. Only pixels above `least` count. The
/// search ends when the result exceeds `enough`.
double StockMap::Rest(const Eigen::Vector2d& place, double wider, double least,
                      double enough) const {
  const double radius = cutter_.radius_mm() + wider, reach2 = radius * radius;
  double rest = least;
  const Span rows = RowsIn(place.y() - radius, place.y() + radius);
  for (int row = rows.from; row <= rows.to; ++row) {
    const double dy = low_.y() + (row + 0.5) * pixel_mm_ - place.y();
    const double half = std::sqrt(std::max(0.0, reach2 - dy * dy));
    const Span columns = ColumnsIn(place.x() - half, place.x() + half);
    const float* heights = &heights_[static_cast<size_t>(row) * columns_];
    for (int column = columns.from; column <= columns.to; ++column) {
      if (heights[column] <= rest) continue;
      const double dx = low_.x() + (column + 0.5) * pixel_mm_ - place.x();
      const double distance = std::max(0.0, std::sqrt(dx * dx + dy * dy) - wider);
      const double up = cutter_.HeightAt(std::min(distance, cutter_.radius_mm()));
      rest = std::max(rest, heights[column] - up);
      if (rest > enough) return rest;
    }
  }
  return rest;
}

double StockMap::RestHeight(const Eigen::Vector2d& place_mm, double wider_mm) const {
  return Rest(place_mm, wider_mm, floor_mm_, std::numeric_limits<double>::infinity());
}

bool StockMap::Meets(const Eigen::Vector3d& tip_mm, double wider_mm) const {
  const double z = tip_mm.z() + kInStockMm;
  return Rest(tip_mm.head<2>(), wider_mm, z, z) > z;
}

double StockMap::RestHeightOver(const Eigen::Vector2d& from_mm,
                                const Eigen::Vector2d& to_mm) const {
  const double length = (to_mm - from_mm).norm();
  const double steps = std::max(1.0, std::ceil(length / std::max(cutter_.radius_mm(), pixel_mm_)));
  double rest = floor_mm_;
  for (double k = 0; k <= steps; ++k) {
    const Eigen::Vector2d place = from_mm + (to_mm - from_mm) * (k / steps);
    rest = std::max(rest, RestHeight(place, length / steps / 2 + pixel_mm_));
  }
  return rest;
}

}  // namespace slicefarm::milling
