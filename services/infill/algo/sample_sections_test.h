#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"
#include "common/model/options/infill_options.h"
#include "services/infill/algo/section_fill.h"

// Sections of a square prism and of a bridge, filled without walls, for tests.

namespace slicefarm::infill::sample_sections {

inline MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

/// Returns ten equal layers of a square of 20 mm.
inline std::vector<SlicedLayer> Prism() {
  std::vector<SlicedLayer> layers(10);
  for (int i = 0; i < 10; ++i) {
    layers[i].frame = {i, 200'000 * (i + 1), 200'000};
    layers[i].sections = {
        {0, i, 10, 200'000, {{Role::kPart, 0, 0, P("(0 0, 20 0, 20 20, 0 20)")}}, {}, 0, {}}};
  }
  return layers;
}

/// Fills a section without fields.
inline absl::StatusOr<FilledSection> FillPlain(WalledSection walled, bool on_bed,
                                               const ObjectLayers& objects,
                                               const std::vector<InfillOptions>& regions) {
  const auto rows = ParseFields(regions);
  RegionFields none(*rows, {});
  return FillSection(std::move(walled), on_bed, objects, {}, regions, none);
}

inline std::vector<Path> PathsOf(const FilledSection& section) {
  std::vector<Path> paths;
  for (const FilledIsland& island : section.islands)
    for (const FillGroup& group : island.fills)
      paths.insert(paths.end(), group.paths.begin(), group.paths.end());
  return paths;
}

inline std::set<Feature> FeaturesOf(const FilledSection& section, int32_t row) {
  std::set<Feature> features;
  for (const Path& path : PathsOf(section))
    if (path.settings == row) features.insert(path.feature);
  return features;
}

inline std::vector<Path> PathsIn(const FilledSection& section) {
  std::vector<Path> paths;
  for (const FilledIsland& island : section.islands)
    for (const FillGroup& group : island.fills)
      paths.insert(paths.end(), group.paths.begin(), group.paths.end());
  return paths;
}

inline InfillOptions Thin() {
  InfillOptions options;
  options.top_solid_layers = options.bottom_solid_layers = 1;
  return options;
}

inline double VolumeOf(const std::vector<Path>& paths, Feature feature, Coord height = 200'000) {
  double volume = 0;
  for (const Path& path : paths) {
    if (path.feature != feature) continue;
    for (size_t i = 1; i < path.points.size(); ++i)
      volume += ToMm(Distance(path.points[i - 1], path.points[i])) *
                SectionMm2((path.WidthAt(i - 1) + path.WidthAt(i)) / 2, height);
  }
  return volume;
}

/// Returns a layer of a slab on two pillars. The slab's lowest layer has the number 5.
inline FilledSection BridgeBy(const InfillOptions& options, int32_t layer = 5,
                              const LayerPlan& plan = {}) {
  auto layers = Prism();
  for (int i = 0; i < 5; ++i)
    layers[static_cast<size_t>(i)].sections[0].regions[0].outlines =
        P("(0 0, 5 0, 5 20, 0 20) ; (15 0, 20 0, 20 20, 15 20)");
  const ObjectLayers objects(layers);
  WalledIsland island;
  island.fill_areas = {{Role::kPart, 0, 0, P("(1 1, 19 1, 19 19, 1 19)")}};
  const std::vector<InfillOptions> regions = {options};
  const auto rows = ParseFields(regions);
  RegionFields none(*rows, {});
  auto filled = FillSection({0, layer, 200'000, {island}}, false, objects, plan, regions, none);
  EXPECT_TRUE(filled.ok()) << filled.status();
  return *std::move(filled);
}

/// Returns the length of a feature's paths, in mm.
inline double LengthOf(const FilledSection& section, Feature feature) {
  double length = 0;
  for (const Path& path : PathsOf(section))
    if (path.feature == feature) length += PathLength(path) / 1e6;
  return length;
}

/// Fills the prism's area in one layer, without skins of neighbouring layers unless `options` has
/// some.
inline FilledSection OneLayer(const InfillOptions& options, int32_t layer,
                              std::string_view area = "(1 1, 19 1, 19 19, 1 19)") {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  WalledIsland island;
  island.fill_areas = {{Role::kPart, 0, 0, P(area)}};
  auto filled = FillPlain({0, layer, 200'000, {island}}, layer == 0, objects, {options});
  EXPECT_TRUE(filled.ok()) << filled.status();
  return *std::move(filled);
}

}  // namespace slicefarm::infill::sample_sections
