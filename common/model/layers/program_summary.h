#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "common/model/job_facts.h"
#include "common/model/layers/layer.h"
#include "common/model/scene/mesh.h"

namespace slicefarm {

/// Summary of one layer of one pass, from which the texts around the layers are written.
struct LayerSummary {
  LayerFrame frame;
  int32_t pass = 0;
  Point entry;  ///< first point of the layer, as in LayerProgram
  Point exit;
  double time_s = 0;
  bool empty = false;  ///< true if the layer prints no beads; `entry` and `exit` are then undefined
  LayerEdges edges;
  double filament_mm = 0;
  Polygon footprint = {};    ///< LayerProgram::footprint
  double silent_time_s = 0;  ///< LayerProgram::silent_time_s

  friend bool operator==(const LayerSummary&, const LayerSummary&) = default;
};

/// Name and footprint of a copy of an object; the head of the file lists them for other programs.
struct CopySummary {
  CopyName name;
  Polygon footprint;    ///< convex hull on the plate
  FeatureUse use = {};  ///< sum over the layers: see CopyUse

  friend bool operator==(const CopySummary&, const CopySummary&) = default;
};

/// Data from which motion makes the ProgramEnvelope (layer.h).
struct ProgramSummary {
  /// Layers in the order of printing: by pass, then from the bottom up.
  std::vector<LayerSummary> layers;
  ProgramStats total;  ///< sum over the layers
  std::vector<Thumbnail> thumbnails;
  std::vector<CopySummary> copies;
  /// Effective settings, one `key = value` per line. The end of the G-code file quotes them for
  /// other programs.
  std::string settings_text;

  friend bool operator==(const ProgramSummary&, const ProgramSummary&) = default;
};

/// Returns the height of the highest layer of all passes.
inline Coord TopOf(const ProgramSummary& summary) {
  Coord top_nm = 0;
  for (const LayerSummary& layer : summary.layers)
    top_nm = std::max(top_nm, layer.frame.print_z_nm);
  return top_nm;
}

}  // namespace slicefarm
