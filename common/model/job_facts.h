#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {

/// Name and number of a copy of an object.
struct CopyName {
  std::string object_name;
  int32_t object = 0;
  int32_t copy = 0;    ///< number of this copy among the object's copies, from 0
  int32_t copies = 1;  ///< number of copies of the object

  friend bool operator==(const CopyName&, const CopyName&) = default;
};

/// State of the print at the start of a pass (Copy::pass), as planned. The numbers of layers may
/// include layers at the very top of an object that turn out too thin for a bead.
struct PassFacts {
  /// Number of layers of all earlier passes; for the first pass: number of layers of the raft.
  int32_t layers_before = 0;
  /// Index of the job's layer in which the objects of this pass begin; 0 without a raft.
  int32_t first_layer = 0;
  Coord top_before_nm = 0;  ///< height of the highest layer of all earlier passes

  friend bool operator==(const PassFacts&, const PassFacts&) = default;
};

/// Facts about the job that the G-code of a layer may contain.
struct JobFacts {
  int32_t layer_count = 0;  ///< number of layers of all passes, for templates; 0: unknown
  /// Names in the order of the job's copies; empty: no copy is labelled.
  std::vector<CopyName> copies;
  std::vector<PassFacts> passes;  ///< state at the start of each pass; empty: there is one pass

  friend bool operator==(const JobFacts&, const JobFacts&) = default;
};

}  // namespace slicefarm
