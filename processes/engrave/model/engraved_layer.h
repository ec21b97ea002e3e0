#pragma once

#include <cstdint>
#include <string>

#include "processes/engrave/model/engrave_report.h"

namespace slicefarm {

/// Common data of all layers of a job, computed before the layers are made.
struct EngraveLayout {
  int32_t layer_count = 0;
  std::string header;  ///< first lines of the file
  std::string footer;
  MapReport map;

  friend bool operator==(const EngraveLayout&, const EngraveLayout&) = default;
};

/// Part of the output file that belongs to one layer. It depends on no other layer.
struct EngravedLayer {
  LayerNumbers numbers;
  ProgramFacts program;
  std::string text;

  friend bool operator==(const EngravedLayer&, const EngravedLayer&) = default;
};

}  // namespace slicefarm
