#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {

/// What a copy is called.
struct CopyName {
  std::string object_name;
  int32_t object = 0;
  int32_t copy = 0;    ///< of the object's, from 0
  int32_t copies = 1;  ///< how many the object has

  friend bool operator==(const CopyName&, const CopyName&) = default;
};

/// What a pass finds when it begins, as planned: layers at the very top of an object that turn out
/// to be too thin for a bead are counted.
struct PassFacts {
  int32_t layers_before = 0;  ///< of the passes before it; of the first pass: the raft's
  int32_t first_layer = 0;    ///< the job's layer in which its objects begin: 0 without a raft
  Coord top_before_nm = 0;    ///< how high the passes before it reach

  friend bool operator==(const PassFacts&, const PassFacts&) = default;
};

/// What the G-code of a layer may say of its job.
struct JobFacts {
  int32_t layer_count = 0;       ///< of all passes; templates may name it; 0: not known
  std::vector<CopyName> copies;  ///< in the order of the job's copies; empty: nothing is labelled
  std::vector<PassFacts> passes;  ///< by pass; empty: there is one

  friend bool operator==(const JobFacts&, const JobFacts&) = default;
};

}  // namespace slicefarm
