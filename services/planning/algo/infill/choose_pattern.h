#pragma once

#include <string>

#include "common/model/options/fill_patterns.h"
#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm {
struct InfillOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Size of a region in all layers of an object, as input of the choice of a pattern.
struct PartShape {
  double height_mm = 0;  ///< total height of the layers that have the region
  /// Mean width: 4 (total area) / (total perimeter) of all layers. For a disc this is its diameter,
  /// for a thin wall twice its thickness.
  double width_mm = 0;
};

/// Measures the region in `stack` (StackLayer::region). Returns zeros if no layer has the region.
PartShape ShapeOf(const ObjectStack& stack);

/// Chosen pattern and the reason for it.
struct PatternChoice {
  FillPattern pattern = FillPattern::kGrid;
  std::string reason;  ///< reason in words, without the pattern's name
};

/// Chooses the pattern for fill_pattern = auto. The first line of this table that applies decides.
/// The left column has conditions on infill_goal (flexibility, time or strength), density and
/// shape; the right column has the pattern. A pitch is a line's width / density:
///
///     density 60 % or more             rectilinear
///     narrower than 4 pitches          flexibility: concentric, else grid
///     time, density below 10 %         lightning
///     time                             rectilinear
///     lower than a gyroid's period     flexibility: honeycomb, strength: triangles
///     flexibility                      gyroid
///     strength, density below 40 %     cubic
///     strength                         gyroid
PatternChoice ChoosePattern(const InfillOptions& options, const PartShape& shape);

}  // namespace slicefarm::planning
