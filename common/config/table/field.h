#pragma once

#include <string_view>

#include "common/config/table/value.h"

namespace slicefarm {
struct JobRows;
}  // namespace slicefarm

namespace slicefarm::config {

/// The narrowest place where a setting may be given; wider places are allowed as well.
enum class Scope {
  kJob,     ///< one value for all
  kObject,  ///< an object may have its own
  kRegion,  ///< so may a part, a modifier and a range of heights
};

/// Returns "the job", "an object" or "a region".
constexpr std::string_view ScopeName(Scope scope) {
  switch (scope) {
    case Scope::kJob:
      return "the job";
    case Scope::kObject:
      return "an object";
    case Scope::kRegion:
      return "a region";
  }
  return {};
}

/// The member of a resolved set that a setting sets.
struct Field {
  void (*set)(JobRows&, const Value&) = nullptr;
  Value (*get)(const JobRows&) = nullptr;
  Scope scope = Scope::kJob;  ///< scope of the row that has the member
};

}  // namespace slicefarm::config
