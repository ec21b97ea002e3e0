#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace slicefarm {

/// What a copy is called.
struct CopyName {
  std::string object_name;
  int32_t object = 0;
  int32_t copy = 0;    ///< of the object's, from 0
  int32_t copies = 1;  ///< how many the object has

  friend bool operator==(const CopyName&, const CopyName&) = default;
};

/// What the G-code of a layer may say of its job.
struct JobFacts {
  int32_t layer_count = 0;       ///< templates may name it; 0: not known
  std::vector<CopyName> copies;  ///< in the order of the job's copies; empty: nothing is labelled

  friend bool operator==(const JobFacts&, const JobFacts&) = default;
};

}  // namespace slicefarm
