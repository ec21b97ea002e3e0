#include <utility>

#include "common/config/settings_sections.h"

namespace slicefarm::config {
namespace {

constexpr std::string_view kAsGrid = "not supported yet: grid is used";

std::vector<Choice> SparsePatterns() {
  std::vector<Choice> choices;
  for (const FillPatternInfo& info : kFillPatterns)
    if (info.sparse) choices.push_back({info.name, static_cast<int>(info.pattern)});
  for (const std::string_view name : {"adaptivecubic", "supportcubic", "lightning"})
    choices.push_back({name, static_cast<int>(FillPattern::kGrid), kAsGrid});
  return choices;
}

SettingSpec SolidFill(std::string_view key, std::string_view doc, Field field) {
  std::vector<Choice> choices;
  for (const FillPatternInfo& info : kFillPatterns)
    if (info.solid != SolidWay::kNone) choices.push_back({info.name, static_cast<int>(info.pattern)});
  return {.key = key,
          .kind = Kind::kChoice,
          .standard = "monotonic",
          .doc = doc,
          .choices = std::move(choices),
          .field = field};
}

SettingSpec SolidLayers(std::string_view key, std::string_view doc, Field field) {
  return {.key = key,
          .kind = Kind::kInteger,
          .min = 0,
          .max = 1000,
          .standard = "3",
          .doc = doc,
          .field = field};
}

SettingSpec MinThickness(std::string_view key, std::string_view doc) {
  return {.key = key, .unit = "mm", .min = 0, .max = 1000, .standard = "0", .doc = doc};
}

}  // namespace

std::vector<SettingSpec> InfillSettings() {
  return {
      SolidLayers("top_solid_layers", "Number of solid layers under a top surface",
                  Bind([](auto& s) -> auto& { return s.infill[0].top_solid_layers; })),
      SolidLayers("bottom_solid_layers", "Number of solid layers over a bottom surface",
                  Bind([](auto& s) -> auto& { return s.infill[0].bottom_solid_layers; })),
      MinThickness("top_solid_min_thickness",
                   "Makes top_solid_layers more until they are this thick; not if it is 0"),
      MinThickness("bottom_solid_min_thickness",
                   "Makes bottom_solid_layers more until they are this thick; not if it is 0"),
      {.key = "fill_density",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "20%",
       .doc = "How much of the inside is filled; 100%: solid",
       .field = Bind<Scale::kPercent>([](auto& s) -> auto& { return s.infill[0].density; })},
      {.key = "fill_pattern",
       .kind = Kind::kChoice,
       .standard = "grid",
       .doc = "Pattern of the sparse infill",
       .choices = SparsePatterns(),
       .field = Bind([](auto& s) -> auto& { return s.infill[0].pattern; })},
      SolidFill("solid_fill_pattern", "Pattern of the solid infill inside a part",
                Bind([](auto& s) -> auto& { return s.infill[0].solid_pattern; })),
      SolidFill("top_fill_pattern", "Pattern of top surfaces",
                Bind([](auto& s) -> auto& { return s.infill[0].top_pattern; })),
      SolidFill("bottom_fill_pattern", "Pattern of bottom surfaces",
                Bind([](auto& s) -> auto& { return s.infill[0].bottom_pattern; })),
      {.key = "fill_angle",
       .unit = "degrees",
       .min = 0,
       .max = 360,
       .standard = "45",
       .doc = "Direction of the infill's lines; solid layers turn by a right angle each",
       .field = Bind<Scale::kDegrees>([](auto& s) -> auto& { return s.infill[0].angle_rad; })},
      {.key = "infill_overlap",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "35%",
       .doc = "How far the infill's lines reach into the walls (PrusaSlicer's 25% leaves up "
              "to twice the gaps beside walls)",
       .relative_to = "perimeter_extrusion_width",
       .field = Bind([](auto& s) -> auto& { return s.infill[0].overlap_nm; })},
      {.key = "infill_anchor",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "600%",
       .doc = "How far a line of sparse infill that is not linked to another one turns along the "
              "wall; 0: not at all",
       .relative_to = "infill_extrusion_width",
       .field = Bind([](auto& s) -> auto& { return s.infill[0].anchor_nm; })},
      {.key = "infill_anchor_max",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "50",
       .doc = "Longest link along the wall between two lines of sparse infill; 0: none. Links are "
              "thinner than lines, so that the density stays what fill_density asks for",
       .relative_to = "infill_extrusion_width",
       .field = Bind([](auto& s) -> auto& { return s.infill[0].anchor_max_nm; })},
      {.key = "solid_infill_every_layers",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 1000000,
       .standard = "0",
       .doc = "Each layer whose number is a multiple of this becomes solid; 0: none",
       .field = Bind([](auto& s) -> auto& { return s.infill[0].solid_every_layers; })},
      {.key = "bridge_angle",
       .unit = "degrees",
       .min = 0,
       .max = 360,
       .standard = "0",
       .doc = "Direction of bridges' lines; 0: for each bridge the one in which it is borne best",
       .field =
           Bind<Scale::kDegrees>([](auto& s) -> auto& { return s.infill[0].bridge_angle_rad; })},
      {.key = "solid_infill_below_area",
       .unit = "mm2",
       .min = 0,
       .max = 1e6,
       .standard = "70",
       .doc = "Regions of sparse infill smaller than this become solid",
       .field = Bind([](auto& s) -> auto& { return s.infill[0].solid_below_area_mm2; })},
      {.key = "density_field",
       .kind = Kind::kDensityField,
       .standard = "",
       .doc = "How dense the sparse infill is, by place; fill_density then has no effect",
       .field = Bind([](auto& s) -> auto& { return s.infill[0].density_field; })},
      {.key = "stress_field",
       .kind = Kind::kStressField,
       .standard = "",
       .doc = "Stresses whose principal directions the lines of the sparse infill follow, in place of "
              "fill_pattern",
       .field = Bind([](auto& s) -> auto& { return s.infill[0].stress_field; })},
      {.key = "infill_first",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Prints the infill before the walls",
       .field = Bind([](auto& s) -> auto& { return s.ordering.infill_first; })},
  };
}

}  // namespace slicefarm::config
