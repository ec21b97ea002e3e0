#pragma once

#include <string_view>

#include "common/config/table/value.h"

namespace slicefarm {
struct JobRows;
}  // namespace slicefarm

namespace slicefarm::config {

/// Narrowest level at which a setting may be given. Wider levels are allowed as well.
enum class Scope {
  kJob,     ///< job: one value for all objects
  kObject,  ///< object: each object may have its own value
  kRegion,  ///< region: each part, modifier and height range may have its own value
};

/// Returns the name of a scope: "the job", "an object" or "a region".
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

/// Functions that store a setting's value in a member of JobRows and read it from there.
struct Field {
  void (*set)(JobRows&, const Value&) = nullptr;
  Value (*get)(const JobRows&) = nullptr;
  Scope scope = Scope::kJob;  ///< scope of the row to which the member belongs
};

}  // namespace slicefarm::config
