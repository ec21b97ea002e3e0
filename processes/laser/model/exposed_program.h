#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/model/layers/layer.h"
#include "processes/laser/model/exposed_layer.h"

namespace slicefarm {

/// One layer for the machine, in the job's format. It begins and ends with the beam off.
struct ExposedProgram {
  LayerFrame frame;
  std::string text;  ///< bytes, where the format has them
  ExposureReport report;

  friend bool operator==(const ExposedProgram&, const ExposedProgram&) = default;
};

/// What stands before and after the layers depends on this.
struct ExposureSummary {
  std::vector<LayerFrame> layers;
  Box bounds;                             ///< of what is exposed, on the plate
  std::vector<std::string> object_names;  ///< by object
  double time_s = 0;                      ///< of all layers, recoating included
  std::string settings_text;              ///< effective settings, for templates

  friend bool operator==(const ExposureSummary&, const ExposureSummary&) = default;
};

struct ExposureEnvelope {
  std::string header;
  /// What stands before each layer's text, where the format has such; else empty.
  std::vector<std::string> layer_heads;
  std::string footer;

  friend bool operator==(const ExposureEnvelope&, const ExposureEnvelope&) = default;
};

}  // namespace slicefarm
