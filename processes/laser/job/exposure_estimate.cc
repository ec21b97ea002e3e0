#include "processes/laser/job/exposure_estimate.h"

#include <algorithm>
#include <vector>

#include "common/geometry/measure.h"
#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm::coordinator {
namespace {

double PerimeterNm(const MultiPolygon& outlines) {
  double sum = 0;
  for (const PolygonWithHoles& island : outlines) {
    sum += Perimeter(island.outer);
    for (const Polygon& hole : island.holes) sum += Perimeter(hole);
  }
  return sum;
}

double TimeS(const Region& region, const ExposureOptions& options) {
  const double hatch_mm =
      ToMm(Area(region.outlines) / static_cast<double>(options.hatch_distance_nm));
  const double contours_mm = options.contours * ToMm(PerimeterNm(region.outlines));
  return hatch_mm / options.StyleOf(ExposureKind::kHatch).speed_mm_s +
         contours_mm / options.StyleOf(ExposureKind::kContour).speed_mm_s;
}

}  // namespace

JobEstimate EstimateExposure(const SlicedOutlines& job, const ExposureSettings& settings) {
  JobEstimate estimate;
  estimate.print_time_s = settings.output.recoat_s * static_cast<double>(job.layers.size());
  for (const SlicedLayer& layer : job.layers) {
    for (const ObjectSection& section : layer.sections) {
      const auto copies = std::ranges::count(job.copies, section.stack.object, &PlacedCopy::object);
      for (const Region& region : section.regions)
        estimate.print_time_s +=
            static_cast<double>(copies) *
            TimeS(region, settings.regions[static_cast<size_t>(region.settings)]);
    }
  }
  return estimate;
}

}  // namespace slicefarm::coordinator
