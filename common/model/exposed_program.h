#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/model/exposed_layer.h"
#include "common/model/layer.h"

namespace slicefarm {

/// One layer for the machine, in the job's format. It begins and ends with the laser off.
struct ExposedProgram {
  LayerFrame frame;
  std::string text;  ///< bytes, where the format has them
  ExposureReport report;

  friend bool operator==(const ExposedProgram&, const ExposedProgram&) = default;
};

/// What stands before and after the layers depends on this.
struct ExposureSummary {
  int32_t layers = 0;
  Box bounds;           ///< of what is exposed, on the plate
  Coord bottom_nm = 0;  ///< the first layer's lower side
  Coord top_nm = 0;     ///< the last layer's upper side
  std::vector<std::string> object_names;  ///< by object

  friend bool operator==(const ExposureSummary&, const ExposureSummary&) = default;
};

struct ExposureEnvelope {
  std::string header;
  std::string footer;

  friend bool operator==(const ExposureEnvelope&, const ExposureEnvelope&) = default;
};

}  // namespace slicefarm
