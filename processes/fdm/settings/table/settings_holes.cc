#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

constexpr Need kPolyholes{"hole_to_polyhole = 1",
                          [](const JobRows& s) { return s.object.polyholes.on; }};
constexpr Need kPrintable{"make_overhang_printable = 1",
                          [](const JobRows& s) { return s.object.printable.on; }};

Field ThresholdField() {
  return Convert<ObjectSlicingOptions>(
      [](ObjectSlicingOptions& object, const Value& value) {
        PolyholeOptions& holes = object.polyholes;
        holes.threshold_nm = value.percent ? 0 : FromMm(value.number);
        holes.threshold_share = value.percent ? value.number / 100 : 0;
      },
      [](const ObjectSlicingOptions& object) {
        const PolyholeOptions& holes = object.polyholes;
        const bool percent = holes.threshold_share > 0;
        return Value{
            .number = Quantise(percent ? 100 * holes.threshold_share : ToMm(holes.threshold_nm)),
            .percent = percent};
      });
}

std::vector<SettingSpec> Polyholes() {
  return {
      {.key = "hole_to_polyhole",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print round vertical holes as polygons around the circle, because plastic narrows a "
              "polygonal hole less than a round hole",
       .field = Bind<&ObjectSlicingOptions::polyholes, &PolyholeOptions::on>(),
       .orca = {{"hole_to_polyhole"}}},
      {.key = "hole_to_polyhole_threshold",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "0.01",
       .doc = "Largest deviation of a hole from a circle at which the hole becomes a polygon",
       .percent_of = "the radius of the hole",
       .field = ThresholdField(),
       .orca = {{"hole_to_polyhole_threshold"}},
       .needs = {&kPolyholes}},
      {.key = "hole_to_polyhole_twisted",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Turn the polygons of holes from layer to layer, so that their corners form no lines",
       .field = Bind<&ObjectSlicingOptions::polyholes, &PolyholeOptions::twisted>(),
       .orca = {{"hole_to_polyhole_twisted"}},
       .needs = {&kPolyholes}},
      {.key = "hole_to_polyhole_max_edges",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Largest number of edges of the polygon of a hole; 0: by the size of the hole",
       .field = Bind<&ObjectSlicingOptions::polyholes, &PolyholeOptions::max_edges>(),
       .orca = {{"hole_to_polyhole_max_edges"}},
       .needs = {&kPolyholes}},
  };
}

std::vector<SettingSpec> OverhangShapes() {
  return {
      {.key = "make_overhang_printable",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Add material below overhangs until they print without supports. This changes the "
              "shape of the part",
       .field = Bind<&ObjectSlicingOptions::printable, &PrintableOverhangs::on>(),
       .orca = {{"make_overhang_printable"}}},
      {.key = "make_overhang_printable_angle",
       .unit = "degrees",
       .min = 0,
       .max = 90,
       .standard = "55",
       .doc = "Largest angle of overhangs against the vertical that remains; 90: the part does "
              "not change. 0: no overhangs remain",
       .field = Bind<Scale::kDegrees, &ObjectSlicingOptions::printable,
                     &PrintableOverhangs::angle_rad>(),
       .orca = {{"make_overhang_printable_angle"}},
       .needs = {&kPrintable}},
      {.key = "make_overhang_printable_hole_size",
       .unit = "mm2",
       .min = 0,
       .max = 1e6,
       .standard = "0",
       .doc = "Area of the largest holes of a layer that stay open below overhangs; 0: all holes "
              "are filled",
       .field = Bind<&ObjectSlicingOptions::printable, &PrintableOverhangs::hole_mm2>(),
       .orca = {{"make_overhang_printable_hole_size"}},
       .needs = {&kPrintable}},
  };
}

}  // namespace

std::vector<SettingSpec> HoleSettings() {
  std::vector<SettingSpec> settings = Polyholes();
  for (SettingSpec& overhang : OverhangShapes()) settings.push_back(std::move(overhang));
  return settings;
}

}  // namespace slicefarm::config::fdm
