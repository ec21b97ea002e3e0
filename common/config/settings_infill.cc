#include "common/config/settings_sections.h"

namespace slicefarm::config {
namespace {

constexpr std::string_view kAsRectilinear = "not supported yet: rectilinear is used";
constexpr std::string_view kAsGrid = "not supported yet: grid is used";
constexpr std::string_view kAsMonotonic = "not supported yet: monotonic is used";

std::vector<Choice> SparsePatterns() {
  const int rectilinear = static_cast<int>(SparsePattern::kRectilinear);
  const int grid = static_cast<int>(SparsePattern::kGrid);
  return {{"grid", grid},
          {"rectilinear", rectilinear},
          {"line", rectilinear, kAsRectilinear},
          {"alignedrectilinear", rectilinear, kAsRectilinear},
          {"monotonic", rectilinear, kAsRectilinear},
          {"monotoniclines", rectilinear, kAsRectilinear},
          {"zigzag", rectilinear, kAsRectilinear},
          {"concentric", rectilinear, kAsRectilinear},
          {"hilbertcurve", rectilinear, kAsRectilinear},
          {"archimedeanchords", rectilinear, kAsRectilinear},
          {"octagramspiral", rectilinear, kAsRectilinear},
          {"triangles", grid, kAsGrid},
          {"stars", grid, kAsGrid},
          {"cubic", grid, kAsGrid},
          {"honeycomb", grid, kAsGrid},
          {"3dhoneycomb", grid, kAsGrid},
          {"gyroid", grid, kAsGrid},
          {"adaptivecubic", grid, kAsGrid},
          {"supportcubic", grid, kAsGrid},
          {"lightning", grid, kAsGrid}};
}

SettingSpec SolidFill(std::string_view key, std::string_view doc, Field field) {
  const int monotonic = static_cast<int>(SolidPattern::kMonotonic);
  const int rectilinear = static_cast<int>(SolidPattern::kRectilinear);
  return {.key = key,
          .kind = Kind::kChoice,
          .standard = "monotonic",
          .doc = doc,
          .choices = {{"monotonic", monotonic},
                      {"rectilinear", rectilinear},
                      {"monotoniclines", monotonic, kAsMonotonic},
                      {"alignedrectilinear", monotonic, kAsMonotonic},
                      {"zigzag", rectilinear, kAsRectilinear},
                      {"concentric", monotonic, kAsMonotonic},
                      {"hilbertcurve", monotonic, kAsMonotonic},
                      {"archimedeanchords", monotonic, kAsMonotonic},
                      {"octagramspiral", monotonic, kAsMonotonic}},
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
      {.key = "solid_infill_below_area",
       .unit = "mm2",
       .min = 0,
       .max = 1e6,
       .standard = "70",
       .doc = "Regions of sparse infill smaller than this become solid",
       .field = Bind([](auto& s) -> auto& { return s.infill[0].solid_below_area_mm2; })},
      {.key = "infill_first",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Prints the infill before the walls",
       .field = Bind([](auto& s) -> auto& { return s.ordering.infill_first; })},
  };
}

}  // namespace slicefarm::config
