#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/model/layers/layer.h"
#include "processes/laser/model/exposed_layer.h"

namespace slicefarm {

/// Program of one layer in the job's output format. It begins and ends with the beam off.
struct ExposedProgram {
  LayerFrame frame;
  std::string text;  ///< text of the program; bytes if the format is binary
  ExposureReport report;

  friend bool operator==(const ExposedProgram&, const ExposedProgram&) = default;
};

/// Data on which the texts before and after the layers depend.
struct ExposureSummary {
  std::vector<LayerFrame> layers;
  Box bounds;                             ///< bounding box of all exposed vectors on the plate
  std::vector<std::string> object_names;  ///< name of each object
  double time_s = 0;                      ///< time of all layers, including recoating
  std::string settings_text;              ///< effective settings, for use in templates

  friend bool operator==(const ExposureSummary&, const ExposureSummary&) = default;
};

/// Texts around the layers of an exposure program.
struct ExposureEnvelope {
  std::string header;
  /// Text before each layer's program. Empty if the format has no such text.
  std::vector<std::string> layer_heads;
  std::string footer;

  friend bool operator==(const ExposureEnvelope&, const ExposureEnvelope&) = default;
};

}  // namespace slicefarm
