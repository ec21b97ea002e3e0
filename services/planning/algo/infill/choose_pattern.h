#pragma once

#include <string>

#include "common/model/options/fill_patterns.h"
#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm {
struct InfillOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// What the choice of a pattern looks at.
struct PartShape {
  double height_mm = 0;  ///< of the region
  double width_mm =
      0;  ///< 4 area / perimeter, over all layers: a disc's diameter, twice a thin wall's
};

PartShape ShapeOf(const ObjectStack& stack);

struct PatternChoice {
  FillPattern pattern = FillPattern::kGrid;
  std::string reason;  ///< in words, without the pattern's name
};

/// fill_pattern = auto. Rules, the first that holds; a pitch is a line's width / density:
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
