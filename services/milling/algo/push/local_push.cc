#include "services/milling/algo/push/local_push.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slicefarm::milling {
namespace {

constexpr int32_t kMaxCellsASide = 512;

struct FlatBox {
  Eigen::Vector2d low;
  Eigen::Vector2d high;
};

FlatBox FlatBoxOf(const TriangleMesh& mesh, uint32_t triangle) {
  const auto& t = mesh.triangles[triangle];
  const Eigen::Vector2d a = mesh.points_mm[t[0]].head<2>(), b = mesh.points_mm[t[1]].head<2>(),
                        c = mesh.points_mm[t[2]].head<2>();
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

/// Returns true if the triangle's bounding box is closer to the fiber than half the cutter's width
/// at the height of the box's top.
bool MayReach(const FiberFrame& frame, const Cutter& cutter, uint32_t triangle,
              const Fiber& fiber) {
  const auto& t = frame.mesh().triangles[triangle];
  const FiberPoint a = frame.At(t[0], fiber), b = frame.At(t[1], fiber), c = frame.At(t[2], fiber);
  const double top = std::max({a.height, b.height, c.height});
  if (top <= kTouchMm) return false;
  const double width = cutter.Width(top);
  return std::min({a.across, b.across, c.across}) < width &&
         std::max({a.across, b.across, c.across}) > -width;
}

}  // namespace

TriangleGrid::TriangleGrid(const TriangleMesh& mesh) {
  std::vector<FlatBox> boxes;
  boxes.reserve(mesh.triangles.size());
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) boxes.push_back(FlatBoxOf(mesh, t));
  Eigen::Vector2d high(0, 0);
  if (!boxes.empty()) low_ = boxes[0].low, high = boxes[0].high;
  for (const FlatBox& box : boxes) low_ = low_.cwiseMin(box.low), high = high.cwiseMax(box.high);
  const Eigen::Vector2d size = high - low_;
  const double fair =
      std::sqrt(2 * size.x() * size.y() / static_cast<double>(std::max<size_t>(1, boxes.size())));
  cell_mm_ = std::max({fair, size.maxCoeff() / kMaxCellsASide, 1e-6});
  columns_ = static_cast<int32_t>(size.x() / cell_mm_) + 1;
  rows_ = static_cast<int32_t>(size.y() / cell_mm_) + 1;
  starts_.assign(static_cast<size_t>(columns_) * rows_ + 1, 0);
  const auto visit_cells = [&](const FlatBox& box, auto visit) {
    const Cell a = CellOf(box.low), b = CellOf(box.high);
    for (int32_t row = a.row; row <= b.row; ++row)
      for (int32_t column = a.column; column <= b.column; ++column)
        visit(static_cast<size_t>(row) * columns_ + column);
  };
  for (const FlatBox& box : boxes) visit_cells(box, [&](size_t cell) { ++starts_[cell + 1]; });
  for (size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
  triangles_.resize(starts_.back());
  std::vector<size_t> next(starts_.begin(), starts_.end() - 1);
  for (uint32_t t = 0; t < boxes.size(); ++t)
    visit_cells(boxes[t], [&](size_t cell) { triangles_[next[cell]++] = t; });
}

TriangleGrid::Cell TriangleGrid::CellOf(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d at = (p - low_) / cell_mm_;
  return {static_cast<int32_t>(std::clamp(at.x(), 0.0, columns_ - 1.0)),
          static_cast<int32_t>(std::clamp(at.y(), 0.0, rows_ - 1.0))};
}

IntervalSet PushLocally(const FiberFrame& frame, const Cutter& cutter,
                        const TriangleGrid& triangles, const Fiber& fiber, double from_mm,
                        double to_mm) {
  const double reach = cutter.radius_mm();
  const bool along_x = frame.axis() == FiberAxis::kX;
  const Eigen::Vector2d ends(from_mm - reach, to_mm + reach),
      sides(fiber.across_mm - reach, fiber.across_mm + reach);
  const Eigen::Vector2d& x = along_x ? ends : sides;
  const Eigen::Vector2d& y = along_x ? sides : ends;
  IntervalSet gouged;
  triangles.ForEachIn({x[0], y[0]}, {x[1], y[1]}, [&](uint32_t t) {
    if (!MayReach(frame, cutter, t, fiber)) return;
    const Interval found = frame.PushTriangle(cutter, t, fiber);
    if (found.low < found.high) gouged.Add(found);
  });
  return gouged;
}

}  // namespace slicefarm::milling
