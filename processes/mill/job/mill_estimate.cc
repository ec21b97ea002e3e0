#include "processes/mill/job/mill_estimate.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"

namespace slicefarm::coordinator {
namespace {

/// Sums over all copies of a layer, in mm and mm2.
struct LayerSums {
  double area = 0;
  double perimeter = 0;
  double height = 0;
};

double PerimeterMm(const MultiPolygon& outlines) {
  double sum = 0;
  for (const PolygonWithHoles& island : outlines) {
    sum += Perimeter(island.outer);
    for (const Polygon& hole : island.holes) sum += Perimeter(hole);
  }
  return ToMm(sum);
}

LayerSums SumsOf(const SlicedLayer& layer, std::span<const PlacedCopy> copies) {
  LayerSums sums;
  sums.height = ToMm(static_cast<double>(layer.frame.height_nm));
  for (const ObjectSection& section : layer.sections) {
    const auto count =
        static_cast<double>(std::ranges::count(copies, section.stack.object, &PlacedCopy::object));
    const MultiPolygon& outline = OutlineOf(section);
    sums.area += count * Area(outline) * 1e-12;
    sums.perimeter += count * PerimeterMm(outline);
  }
  return sums;
}

/// Returns the area of the box around all copies, seen from above and grown by the margin.
double StockAreaMm2(std::span<const PlacedCopy> copies, double margin_mm) {
  Box box;
  bool first = true;
  for (const PlacedCopy& copy : copies) {
    for (const Point p : copy.footprint) {
      if (first) box = {p, p};
      first = false;
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
  }
  return (ToMm(static_cast<double>(box.max.x - box.min.x)) + 2 * margin_mm) *
         (ToMm(static_cast<double>(box.max.y - box.min.y)) + 2 * margin_mm);
}

}  // namespace

JobEstimate EstimateMilling(const SlicedOutlines& job, const MillingOptions& how) {
  const double stock = StockAreaMm2(job.copies, how.stock_margin_mm);
  double removed = stock * how.stock_margin_mm, waterlines = 0, flats = 0, height = 0, above = 0;
  for (size_t i = job.layers.size(); i-- > 0;) {
    const LayerSums sums = SumsOf(job.layers[i], job.copies);
    removed += std::max(0.0, stock - sums.area) * sums.height;
    waterlines += sums.perimeter * sums.height / how.finish_stepdown_mm;
    flats += std::max(0.0, sums.area - above);
    above = sums.area;
    height += sums.height;
  }
  double cut = removed / (how.stepover_mm() * how.stepdown_mm);
  double levels = std::ceil((height + how.stock_margin_mm) / how.stepdown_mm);
  if (how.finishing) {
    cut += waterlines + flats / how.finish_stepover_mm;
    levels += std::ceil(height / how.finish_stepdown_mm);
  }
  JobEstimate estimate;
  estimate.print_time_s = 60 * cut / how.machining.feed_mm_min;
  estimate.layers = static_cast<int32_t>(std::min(levels, 1e9));
  return estimate;
}

}  // namespace slicefarm::coordinator
