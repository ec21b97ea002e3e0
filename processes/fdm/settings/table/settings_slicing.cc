#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {

std::vector<SettingSpec> SlicingSettings() {
  std::vector<SettingSpec> settings = {
      {.key = "elefant_foot_compensation",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0",
       .doc = "Distance by which the outline of the first layer moves inwards, because the weight "
              "of the part spreads this layer; 0: not moved",
       .field = Bind<&ObjectSlicingOptions::elephant_foot_nm>(),
       .orca = {{"elefant_foot_compensation"}}},
      {.key = "elefant_foot_compensation_layers",
       .kind = Kind::kInteger,
       .unit = "layers",
       .min = 1,
       .max = 100,
       .standard = "1",
       .doc = "Number of layers over which elefant_foot_compensation decreases evenly to 0; 1: "
              "only the first layer shrinks",
       .field = Bind<&ObjectSlicingOptions::elephant_foot_layers>(),
       .orca = {{"elefant_foot_compensation_layers"}},
       .needs = {&needs::kElephantFoot}},
      {.key = "counterbore_hole_bridging",
       .kind = Kind::kChoice,
       .standard = "none",
       .doc = "Printing of a hole that begins above a wider recess. none: the hole's edge is "
              "printed in the air. partiallybridge: the edge rests on bridges of two layers, each "
              "at two sides of the hole. sacrificiallayer: one layer closes the recess and must be "
              "drilled through",
       .choices = {{"none", static_cast<int>(CounterboreBridging::kNone)},
                   {"partiallybridge", static_cast<int>(CounterboreBridging::kPartial)},
                   {"sacrificiallayer", static_cast<int>(CounterboreBridging::kSacrificial)}},
       .field = Bind<&ObjectSlicingOptions::counterbores>(),
       .orca = {{"counterbore_hole_bridging"}}},
      {.key = "precise_z_height",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Adapt the heights of the last layers so that the top of the object is met exactly",
       .field = Bind<&ObjectSlicingOptions::precise_top>(),
       .orca = {{"precise_z_height"}}},
      {.key = "adaptive_layer_height",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Adapt the layer height to the shape instead of using layer_height: low layers where "
              "the surface is nearly horizontal, high layers where it is steep. A layer ends "
              "exactly at each horizontal face",
       .field = Bind<&ObjectSlicingOptions::adaptive, &AdaptiveHeights::on>(),
       .needs = {&needs::kNoHeightProfile}},
      {.key = "adaptive_layer_cusp",
       .unit = "mm",
       .min = 0.005,
       .max = 5,
       .standard = "0.1",
       .doc = "Largest step between adaptive layers that may show on the surface, measured "
              "perpendicular to the surface; smaller: lower layers",
       .field = Bind<&ObjectSlicingOptions::adaptive, &AdaptiveHeights::cusp_nm>(),
       .needs = {&needs::kAdaptiveLayers, &needs::kNoHeightProfile}},
      {.key = "adaptive_layer_ratio",
       .min = 1,
       .max = kMostHeightRatio,
       .standard = "1.5",
       .doc = "Largest ratio between the heights of neighbouring adaptive layers",
       .field = Bind<&ObjectSlicingOptions::adaptive, &AdaptiveHeights::max_ratio>(),
       .needs = {&needs::kAdaptiveLayers, &needs::kNoHeightProfile}},
      {.key = "min_layer_height",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0.07",
       .doc = "Smallest height of adaptive layers, and of support layers that differ from the "
              "part's layers",
       .list = List::kPerExtruder,
       .field = Bind<&ObjectSlicingOptions::adaptive, &AdaptiveHeights::min_nm>(),
       .also = Bind<&ObjectRow::support, &SupportOptions::min_layer_height_nm>(),
       .own_scope = Scope::kJob,
       .orca = {{"min_layer_height"}}},
      {.key = "max_layer_height",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0",
       .doc = "Largest height of adaptive layers; 0: 75 % of the nozzle diameter",
       .list = List::kPerExtruder,
       .field = Bind<&ObjectSlicingOptions::adaptive, &AdaptiveHeights::max_nm>(),
       .own_scope = Scope::kJob,
       .orca = {{"max_layer_height"}}},
      {.key = "layer_height_profile",
       .kind = Kind::kLayerHeights,
       .doc = "Layer heights by z above the object's bottom, interpolated between the given "
              "points, instead of layer_height. Projects store hand-edited layer heights in this "
              "setting. Empty: layer_height",
       .field = Bind<&ObjectSlicingOptions::height_profile>(),
       .orca = {{"layer_height_profile", OrcaValue::kWhole}}},
      {.key = "thumbnails",
       .kind = Kind::kSizes,
       .unit = "pixels",
       .standard = "32x32,300x300",
       .doc = "Pictures of the part at the beginning of the G-code, for the printer's display: "
              "WIDTHxHEIGHT or WIDTHxHEIGHT/FORMAT in pixels, separated by commas",
       .field = Bind<&JobSlicingOptions::thumbnails>(),
       .orca = {{"thumbnails", OrcaValue::kPoints}}},
      {.key = "thumbnails_format",
       .kind = Kind::kChoice,
       .standard = "PNG",
       .doc = "Format of the pictures in thumbnails that have no FORMAT",
       .choices = {{"PNG", static_cast<int>(PictureFormat::kPng)},
                   {"QOI", static_cast<int>(PictureFormat::kQoi)},
                   {"JPG", static_cast<int>(PictureFormat::kJpg)},
                   {"BTT_TFT", static_cast<int>(PictureFormat::kBtt)},
                   {"COLPIC", static_cast<int>(PictureFormat::kColPic)}},
       .orca = {{"thumbnails_format"}}},
  };
  for (const auto& section : {HoleSettings, ContourSettings})
    for (SettingSpec& spec : section()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
