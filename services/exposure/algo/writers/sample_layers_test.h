#pragma once

#include <vector>

#include "processes/laser/model/exposed_layer.h"
#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// Returns two layers with every kind of line: hatch, closed lines in both directions, an open
/// line, two copies, two rows of settings, negative positions.
inline std::vector<ExposedLayer> SampleLayers() {
  std::vector<ExposedLayer> layers(2);
  for (int32_t i = 0; i < 2; ++i) {
    ExposedLayer& layer = layers[static_cast<size_t>(i)];
    layer.frame = {i, (i + 1) * Coord{50'000}, 50'000};
    ExposureGroup contour;
    contour.kind = ExposureKind::kContour;
    contour.AddLine(Polyline{{0, 0}, {10'000'000, 0}, {10'000'000, 5'000'500}, {0, 0}});
    contour.AddLine(Polyline{{2'000'000, 1'000'000},
                             {3'000'000, 2'000'000},
                             {3'000'000, 1'000'000},
                             {2'000'000, 1'000'000}});
    ExposureGroup hatch;
    hatch.points = {
        {1'000'001, 80'000}, {9'000'000, 80'000}, {9'000'000, 160'000}, {1'234'567, 160'000}};
    ExposureGroup wall;
    wall.kind = ExposureKind::kThinWall;
    wall.settings = 1;
    wall.object = 1;
    wall.AddLine(
        Polyline{{-5'000'000, -7'000'000}, {-4'000'000, -7'100'000}, {-3'000'000, -7'000'000}});
    layer.groups = {contour, hatch, wall};
    layer.visits = {{0, 0, {}}, {1, 2, {}}, {0, 1, {20'000'000, 1'000'000}}};
  }
  return layers;
}

/// Returns facts that refer to a static table.
inline FileFacts SampleFacts(OutputFormat format) {
  static const std::vector<ExposureOptions> regions = [] {
    std::vector<ExposureOptions> rows(2);
    rows[0].styles[0].power_w = 100;
    rows[0].styles[1].speed_mm_s = 1200;
    rows[1].styles[4] = {.power_w = 50, .speed_mm_s = 300.5};
    return rows;
  }();
  static const std::vector<std::string> names = {"bracket.stl", "a,b/$c"};
  FileFacts facts;
  facts.object_names = names;
  facts.layers = 2;
  facts.bounds = {{-5'000'000, -7'100'000}, {30'000'000, 6'000'500}};
  facts.top_nm = 100'000;
  facts.regions = regions;
  facts.output.format = format;
  return facts;
}

inline std::string SampleFile(OutputFormat format) {
  const FileFacts facts = SampleFacts(format);
  std::string file = FileHeader(facts);
  for (const ExposedLayer& layer : SampleLayers()) {
    if (HasLayerHeads(format)) file += LayerHead(layer.frame, {});
    file += LayerText(layer, facts);
  }
  return file + FileFooter(facts);
}

/// Line of a layer in plate coordinates.
struct PlateLine {
  int32_t object = 0;
  int32_t settings = 0;
  ExposureKind kind = ExposureKind::kHatch;
  std::vector<Point> points;
};
inline std::vector<PlateLine> PlateLines(const ExposedLayer& layer) {
  std::vector<PlateLine> lines;
  for (const ExposureVisit& visit : layer.visits)
    for (const ExposureGroup& group : layer.groups) {
      if (group.object != visit.object) continue;
      group.ForEachLine([&](std::span<const Point> line) {
        PlateLine& plate =
            lines.emplace_back(PlateLine{group.object, group.settings, group.kind, {}});
        for (const Point p : line) plate.points.push_back(p + visit.shift);
      });
    }
  return lines;
}

}  // namespace slicefarm::exposure
