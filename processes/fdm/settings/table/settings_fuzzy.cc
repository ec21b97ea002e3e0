#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

bool HasNoise(const JobRows& s) {
  const BeadingOptions& walls = FdmOf(s).region.walls;
  return walls.fuzzy != FuzzySkin::kNone && walls.texture.noise != FuzzyNoise::kClassic &&
         walls.texture.noise != FuzzyNoise::kRipple;
}

bool HasRipples(const JobRows& s) {
  const BeadingOptions& walls = FdmOf(s).region.walls;
  return walls.fuzzy != FuzzySkin::kNone && walls.texture.noise == FuzzyNoise::kRipple;
}

constexpr Need kNoise{
    "a fuzzy_skin other than none and a fuzzy_skin_noise_type other than classic and ripple",
    HasNoise};
constexpr Need kOctaves{
    "a fuzzy_skin_noise_type of perlin, billow or ridgedmulti", [](const JobRows& s) {
      return HasNoise(s) && FdmOf(s).region.walls.texture.noise != FuzzyNoise::kVoronoi;
    }};
constexpr Need kPersistence{"a fuzzy_skin_noise_type of perlin or billow", [](const JobRows& s) {
                              const FuzzyNoise noise = FdmOf(s).region.walls.texture.noise;
                              return HasNoise(s) &&
                                     (noise == FuzzyNoise::kPerlin || noise == FuzzyNoise::kBillow);
                            }};
constexpr Need kRipples{"a fuzzy_skin other than none and fuzzy_skin_noise_type = ripple",
                        HasRipples};

template <auto kMember>
Field Texture() {
  return Bind<&RegionRow::walls, &BeadingOptions::texture, kMember>();
}

std::vector<SettingSpec> Kinds() {
  const auto mode = [](FuzzyMode value) { return static_cast<int>(value); };
  const auto noise = [](FuzzyNoise value) { return static_cast<int>(value); };
  return {
      {.key = "fuzzy_skin",
       .kind = Kind::kChoice,
       .standard = "none",
       .doc = "Walls that get a rough surface. external: the outermost walls of outer contours. "
              "all: the outermost walls of holes too. allwalls: inner walls too",
       .choices = {{"none", static_cast<int>(FuzzySkin::kNone)},
                   {"external", static_cast<int>(FuzzySkin::kContours)},
                   {"all", static_cast<int>(FuzzySkin::kAllWalls)},
                   {"allwalls", static_cast<int>(FuzzySkin::kEveryWall)}},
       .field = Bind<&RegionRow::walls, &BeadingOptions::fuzzy>(),
       .orca = {{"fuzzy_skin", OrcaValue::kChoice}}},
      {.key = "fuzzy_skin_thickness",
       .unit = "mm",
       .min = 0,
       .max = 10,
       .standard = "0.3",
       .doc = "Largest distance by which points of a fuzzy skin move outwards or inwards, or "
              "largest change of the width of its beads",
       .field = Bind<&RegionRow::walls, &BeadingOptions::fuzzy_thickness_nm>(),
       .orca = {{"fuzzy_skin_thickness"}},
       .needs = {&needs::kFuzzySkin}},
      {.key = "fuzzy_skin_point_dist",
       .unit = "mm",
       .min = 0.01,
       .max = 1000,
       .standard = "0.8",
       .doc = "Mean distance between the points of a fuzzy skin; smaller: finer",
       .field = Bind<&RegionRow::walls, &BeadingOptions::fuzzy_point_distance_nm>(),
       .orca = {{"fuzzy_skin_point_distance"}},
       .needs = {&needs::kFuzzySkin}},
      {.key = "fuzzy_skin_first_layer",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Make the walls of the first layer rough too; rough walls hold less well to the bed",
       .field = Texture<&FuzzyTexture::first_layer>(),
       .orca = {{"fuzzy_skin_first_layer"}},
       .needs = {&needs::kFuzzySkin}},
      {.key = "fuzzy_skin_mode",
       .kind = Kind::kChoice,
       .standard = "displacement",
       .doc = "Change of a wall with fuzzy skin. displacement: its points move. extrusion: its "
              "beads become wider and narrower. combined: only their outer sides move, so that "
              "the wall keeps its hold on the next wall",
       .choices = {{"displacement", mode(FuzzyMode::kDisplacement)},
                   {"extrusion", mode(FuzzyMode::kExtrusion)},
                   {"combined", mode(FuzzyMode::kCombined)}},
       .field = Texture<&FuzzyTexture::mode>(),
       .orca = {{"fuzzy_skin_mode"}},
       .needs = {&needs::kFuzzySkin}},
      {.key = "fuzzy_skin_noise_type",
       .kind = Kind::kChoice,
       .standard = "classic",
       .doc = "Shape of a fuzzy skin. classic: each point is independent. perlin: smooth hills. "
              "billow: rounded lumps. ridgedmulti: sharp ridges. voronoi: cells with steps "
              "between them. ripple: waves along the wall",
       .choices = {{"classic", noise(FuzzyNoise::kClassic)},
                   {"perlin", noise(FuzzyNoise::kPerlin)},
                   {"billow", noise(FuzzyNoise::kBillow)},
                   {"ridgedmulti", noise(FuzzyNoise::kRidgedMulti)},
                   {"voronoi", noise(FuzzyNoise::kVoronoi)},
                   {"ripple", noise(FuzzyNoise::kRipple)}},
       .field = Texture<&FuzzyTexture::noise>(),
       .orca = {{"fuzzy_skin_noise_type"}},
       .needs = {&needs::kFuzzySkin}},
  };
}

std::vector<SettingSpec> Noises() {
  return {
      {.key = "fuzzy_skin_scale",
       .unit = "mm",
       .min = 0.1,
       .max = 500,
       .standard = "1",
       .doc = "Size of the largest features of the noise of a fuzzy skin",
       .field = Texture<&FuzzyTexture::scale_mm>(),
       .orca = {{"fuzzy_skin_scale"}},
       .needs = {&kNoise}},
      {.key = "fuzzy_skin_octaves",
       .kind = Kind::kInteger,
       .min = 1,
       .max = 10,
       .standard = "4",
       .doc = "Number of sizes of features that the noise of a fuzzy skin adds, each half as large "
              "as the previous one",
       .field = Texture<&FuzzyTexture::octaves>(),
       .orca = {{"fuzzy_skin_octaves"}},
       .needs = {&kOctaves}},
      {.key = "fuzzy_skin_persistence",
       .min = 0.01,
       .max = 1,
       .standard = "0.5",
       .doc = "Height of each smaller size of features of a fuzzy skin, as a share of the previous "
              "size; smaller: smoother",
       .field = Texture<&FuzzyTexture::persistence>(),
       .orca = {{"fuzzy_skin_persistence"}},
       .needs = {&kPersistence}},
      {.key = "fuzzy_skin_ripples_per_layer",
       .kind = Kind::kInteger,
       .min = 1,
       .max = 10000,
       .standard = "15",
       .doc = "Number of waves around each wall of a fuzzy skin",
       .field = Texture<&FuzzyTexture::ripples>(),
       .orca = {{"fuzzy_skin_ripples_per_layer"}},
       .needs = {&kRipples}},
      {.key = "fuzzy_skin_ripple_offset",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "50%",
       .doc = "Shift of the waves of a fuzzy skin from one group of layers to the next, as a share "
              "of a wave's length",
       .field = Bind<Scale::kPercent, &RegionRow::walls, &BeadingOptions::texture,
                     &FuzzyTexture::ripple_shift>(),
       .orca = {{"fuzzy_skin_ripple_offset", OrcaValue::kPercent}},
       .needs = {&kRipples}},
      {.key = "fuzzy_skin_layers_between_ripple_offset",
       .kind = Kind::kInteger,
       .unit = "layers",
       .min = 1,
       .max = 1'000'000,
       .standard = "1",
       .doc = "Number of consecutive layers with the same waves of a fuzzy skin",
       .field = Texture<&FuzzyTexture::ripple_layers>(),
       .orca = {{"fuzzy_skin_layers_between_ripple_offset"}},
       .needs = {&kRipples}},
  };
}

}  // namespace

std::vector<SettingSpec> FuzzySkinSettings() {
  std::vector<SettingSpec> settings = Kinds();
  for (SettingSpec& noise : Noises()) settings.push_back(std::move(noise));
  return settings;
}

}  // namespace slicefarm::config::fdm
