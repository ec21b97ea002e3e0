#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "common/model/job_facts.h"
#include "common/model/layers/layer.h"
#include "common/model/scene/mesh.h"

namespace slicefarm {

/// What the frame of a finished program tells about a layer (of a pass).
struct LayerSummary {
  LayerFrame frame;
  int32_t pass = 0;
  Point entry;  ///< this and the next: as LayerProgram has them
  Point exit;
  double time_s = 0;
  bool empty = false;  ///< nothing is printed in it; entry and exit mean nothing
  LayerEdges edges;
  double filament_mm = 0;
  Polygon footprint = {};    ///< as LayerProgram's
  double silent_time_s = 0;  ///< as LayerProgram's

  friend bool operator==(const LayerSummary&, const LayerSummary&) = default;
};

/// A copy of an object, for those who read G-code.
struct CopySummary {
  CopyName name;
  Polygon footprint;  ///< convex hull on the plate

  friend bool operator==(const CopySummary&, const CopySummary&) = default;
};

/// What motion needs to write what stands before and after the layers.
struct ProgramSummary {
  std::vector<LayerSummary> layers;  ///< in the order of printing: by pass, then bottom up
  ProgramStats total;  ///< sum over the layers
  std::vector<Thumbnail> thumbnails;
  std::vector<CopySummary> copies;
  /// The effective settings, `key = value`, one a line: the tail of the file quotes them for those
  /// who read G-code.
  std::string settings_text;

  friend bool operator==(const ProgramSummary&, const ProgramSummary&) = default;
};

/// How high the layers of all passes reach.
inline Coord TopOf(const ProgramSummary& summary) {
  Coord top_nm = 0;
  for (const LayerSummary& layer : summary.layers)
    top_nm = std::max(top_nm, layer.frame.print_z_nm);
  return top_nm;
}

}  // namespace slicefarm
