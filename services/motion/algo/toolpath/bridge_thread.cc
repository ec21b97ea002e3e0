#include "services/motion/algo/toolpath/bridge_thread.h"

#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/model/bead_section.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/region_motion.h"

namespace slicefarm::motion {
namespace {

/// Largest difference between a bridge's section and a thread's section, as a share.
constexpr double kThreadTolerance = 0.001;

}  // namespace

double DiscMm2(double diameter_mm) { return std::numbers::pi / 4 * diameter_mm * diameter_mm; }

double ThreadMm(const RegionMotion& region, double nozzle_mm, Feature feature) {
  const bool own = feature == Feature::kInternalBridge && region.internal_bridge_flow > 0;
  const double flowless_mm = region.bridge_width_mm > 0 ? region.bridge_width_mm : nozzle_mm;
  return flowless_mm * std::sqrt(own ? region.internal_bridge_flow : region.bridge_flow);
}

Coord ThreadNm(const Path& path, Coord bead_height_nm, const MotionOptions& options) {
  if (!IsBridge(path.feature)) return 0;
  const double thread_mm = ThreadMm(options.speeds[static_cast<size_t>(path.settings)],
                                    options.tool().nozzle_diameter_mm, path.feature);
  const double off_mm2 = SectionMm2(path.widths_nm.front(), bead_height_nm) - DiscMm2(thread_mm);
  return std::abs(off_mm2) <= kThreadTolerance * DiscMm2(thread_mm) ? FromMm(thread_mm) : 0;
}

}  // namespace slicefarm::motion
