#include "common/config/table/bind.h"
#include "common/config/table/shared_settings.h"

namespace slicefarm::config {

namespace {

/// Index of the choice of slicing_mode that is not a FillRule. The other indices are values of
/// FillRule.
constexpr int kCloseHoles = 3;

void SetSlicingMode(ObjectSlicingOptions& object, const Value& value) {
  const auto mode = static_cast<int>(std::lround(value.number));
  object.close_holes = mode == kCloseHoles;
  object.fill_rule = object.close_holes ? FillRule::kNonZero : static_cast<FillRule>(mode);
}

Value SlicingModeOf(const ObjectSlicingOptions& object) {
  return {.number = static_cast<double>(object.close_holes ? kCloseHoles
                                                           : static_cast<int>(object.fill_rule))};
}

}  // namespace

std::vector<SettingSpec> LayerSettings() {
  const auto fill_rule = [](FillRule rule) { return static_cast<int>(rule); };
  return {
      {.key = "layer_height",
       .unit = "mm",
       .min = 0.01,
       .max = 5,
       .standard = "0.3",
       .doc = "Height of a layer; at most the nozzle diameter",
       .field = Bind<&ObjectSlicingOptions::layer_height_nm>(),
       .orca = {{"layer_height"}}},
      {.key = "first_layer_height",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0.01,
       .max = 5,
       .standard = "0.35",
       .doc = "Height of the first layer; at most the nozzle diameter",
       .relative_to = "layer_height",
       .field = Bind<&JobSlicingOptions::first_layer_height_nm>(),
       .orca = {{"initial_layer_print_height"}}},
      {.key = "slicing_mode",
       .kind = Kind::kChoice,
       .standard = "regular",
       .doc = "Rule for the inside of a part where outlines of a layer overlap. regular: enclosed "
              "by any outline. even_odd: enclosed by an odd number of outlines. positive: enclosed "
              "by more outer outlines than holes. close_holes: enclosed by any outer outline, so "
              "that holes are filled",
       .choices = {{"regular", fill_rule(FillRule::kNonZero)},
                   {"even_odd", fill_rule(FillRule::kEvenOdd)},
                   {"positive", fill_rule(FillRule::kPositive)},
                   {"close_holes", kCloseHoles}},
       .field = Convert<ObjectSlicingOptions>(
           [](ObjectSlicingOptions& row, const Value& value) { SetSlicingMode(row, value); },
           [](const ObjectSlicingOptions& row) { return SlicingModeOf(row); }),
       .orca = {{"slicing_mode"}}},
      {.key = "slice_closing_radius",
       .unit = "mm",
       .min = 0,
       .max = 10,
       .standard = "0.049",
       .doc = "Half the width of the widest crack in an outline that is closed; only for meshes "
              "with holes or other defects. 0: cracks remain open",
       .field = Bind<&ObjectSlicingOptions::closing_radius_nm>(),
       .orca = {{"slice_closing_radius"}}},
      {.key = "open_loop_max_gap",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "2",
       .doc = "Widest gap in an outline, caused by holes of the mesh, that is closed with a "
              "straight line; an outline with a wider gap is omitted and reported",
       .field = Bind<&JobSlicingOptions::max_gap_nm>()},
      {.key = "xy_size_compensation",
       .unit = "mm",
       .min = -5,
       .max = 5,
       .standard = "0",
       .doc = "Distance by which the outlines of every layer move outwards, so that the part grows "
              "and its holes shrink; negative: the part shrinks and its holes grow",
       .field = Bind<&ObjectSlicingOptions::xy_compensation_nm>(),
       .orca = {{"xy_contour_compensation"}}},
      {.key = "xy_hole_compensation",
       .unit = "mm",
       .min = -5,
       .max = 5,
       .standard = "0",
       .doc = "Distance by which holes grow in every layer, in addition to xy_size_compensation; "
              "negative: holes shrink",
       .field = Bind<&ObjectSlicingOptions::hole_compensation_nm>(),
       .orca = {{"xy_hole_compensation"}}},
      {.key = "outline_resolution",
       .unit = "mm",
       .min = 0,
       .max = 1,
       .standard = "0.005",
       .doc = "Largest deviation of a simplified outline from the outline of the mesh; larger: "
              "fewer points and less detail",
       .field = Bind<&JobSlicingOptions::resolution_nm>()},
      {.key = "resolution",
       .unit = "mm",
       .min = 0,
       .max = 1,
       .standard = "0",
       .doc = "Largest deviation of a simplified outline from the outline of the mesh; the larger "
              "value of `resolution` and outline_resolution is used"},
  };
}

}  // namespace slicefarm::config
