#include "services/planning/algo/infill/choose_pattern.h"

#include <algorithm>

#include "common/geometry/measure.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::planning {
namespace {

constexpr double kCrowded = 0.6;
constexpr double kNarrowPitches = 4;
constexpr double kGyroidPeriods = 2.456;
constexpr double kAiry = 0.1;
constexpr double kFirm = 0.4;

PatternChoice ForTime(double density) {
  if (density < kAiry)
    return {FillPattern::kLightning,
            "least material, because such sparse infill only supports top surfaces"};
  return {FillPattern::kRectilinear, "fastest, because each layer has one path with few turns"};
}

PatternChoice ForStrength(double density) {
  if (density < kFirm)
    return {FillPattern::kCubic, "strong, because planes in three directions brace each other"};
  return {FillPattern::kGyroid,
          "equally stiff in all directions, without crossing lines, which such dense infill must "
          "not have"};
}

}  // namespace

PartShape ShapeOf(const ObjectStack& stack) {
  double area = 0, perimeter = 0;
  Coord bottom = 0, top = 0;
  bool found = false;
  for (const StackLayer& layer : stack) {
    if (layer.region.empty()) continue;
    if (!found) bottom = layer.z_nm - layer.height_nm;
    found = true;
    top = layer.z_nm;
    area += Area(layer.region);
    ForEachRing(layer.region, [&](const Polygon& ring) { perimeter += Perimeter(ring); });
  }
  if (!found) return {};
  return {ToMm(static_cast<double>(top - bottom)), ToMm(4 * area / perimeter)};
}

PatternChoice ChoosePattern(const InfillOptions& options, const PartShape& shape) {
  const double density = options.density;
  if (density >= kCrowded)
    return {FillPattern::kRectilinear,
            "such dense infill must not have crossing lines, which would pile up"};
  const double pitch_mm =
      ToMm(static_cast<double>(options.sparse_width_nm)) / std::max(density, 0.01);
  const bool flexible = options.goal == FillGoal::kFlexibility;
  if (shape.width_mm < kNarrowPitches * pitch_mm) {
    if (flexible)
      return {FillPattern::kConcentric,
              "the part is too narrow for cells, and lines along it bend"};
    return {FillPattern::kGrid, "the part is too narrow for larger cells"};
  }
  if (options.goal == FillGoal::kTime) return ForTime(density);
  if (shape.height_mm < kGyroidPeriods * pitch_mm) {
    constexpr std::string_view kFlat =
        "the part is too flat for a pattern that changes with the height";
    return {flexible ? FillPattern::kHoneycomb : FillPattern::kTriangles, std::string(kFlat)};
  }
  if (flexible) return {FillPattern::kGyroid, "equally flexible in all directions"};
  return ForStrength(density);
}

}  // namespace slicefarm::planning
