#pragma once

#include <cstdint>
#include <cstdlib>

namespace slicefarm {

/// Returns a number from an environment variable, with which a test runs longer than in CI.
inline int64_t FromEnvironment(const char* name, int64_t otherwise) {
  const char* const value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoll(value, nullptr, 10);
}

}  // namespace slicefarm
