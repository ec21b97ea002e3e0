#pragma once

#include <cstdint>
#include <string>

#include "processes/engrave/model/engrave_report.h"

namespace slicefarm {

/// What all layers of a job come to together, before they are made.
struct EngraveLayout {
  int32_t layer_count = 0;
  std::string header;  ///< of the file
  std::string footer;
  MapReport map;

  friend bool operator==(const EngraveLayout&, const EngraveLayout&) = default;
};

/// A layer's part of the file: it depends on no other layer.
struct EngravedLayer {
  LayerNumbers numbers;
  ProgramFacts program;
  std::string text;

  friend bool operator==(const EngravedLayer&, const EngravedLayer&) = default;
};

}  // namespace slicefarm
