#include "common/model/path.h"

#include "common/geometry/measure.h"

namespace slicefarm {

std::string_view FeatureName(Feature feature) {
  static constexpr std::array<std::string_view, kFeatureCount> kNames = {
      "External perimeter",
      "Perimeter",
      "Overhang perimeter",
      "Gap fill",
      "Internal infill",
      "Solid infill",
      "Top solid infill",
      "Bridge infill",
      "Skirt/Brim",
      "Support material",
      "Support material interface",
      "Ironing",
      "Solid infill over bridge",
      "Internal bridge"};
  return kNames[static_cast<size_t>(feature)];
}

std::string_view FeatureType(Feature feature) {
  if (feature == Feature::kInternalBridge) return FeatureName(Feature::kBridgeInfill);
  return FeatureName(feature == Feature::kSolidOverBridge ? Feature::kSolidInfill : feature);
}

bool WellFormed(const Path& path) {
  const size_t widths = path.widths_nm.size();
  return path.points.size() >= 2 && (widths == 1 || widths == path.points.size());
}

Point StartOf(const Path& path) { return path.points.front(); }
Point EndOf(const Path& path) { return path.closed ? path.points.front() : path.points.back(); }

double PathLength(const Path& path) {
  return path.closed ? Perimeter(path.points) : Length(path.points);
}

}  // namespace slicefarm
