#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>

namespace slicefarm {

namespace internal {

/// Returns true if kValue is an enumerator of its enumeration. The function reads its own
/// signature: the compiler writes an enumerator as a name, and any other value as a cast of a
/// number.
template <auto kValue>
constexpr bool IsEnumerator() {
  constexpr std::string_view kText = __PRETTY_FUNCTION__;
  constexpr size_t kAt = kText.rfind("kValue = ");
  static_assert(kAt != std::string_view::npos);
  return kText[kAt + sizeof("kValue = ") - 1] != '(';
}

/// Returns the number of enumerators, at most 64. Counts upwards from kCount; REQUIRES: the values
/// below kCount are enumerators.
template <typename Enum, int kCount = 0>
constexpr int CountEnumerators() {
  constexpr int kMost = 64;
  if constexpr (kCount < kMost && IsEnumerator<static_cast<Enum>(kCount)>())
    return CountEnumerators<Enum, kCount + 1>();
  else
    return kCount;
}

}  // namespace internal

/// Number of enumerators of an enumeration, at most 64. REQUIRES: their values are 0, 1, 2, ...
/// without gaps.
template <typename Enum>
requires std::is_enum_v<Enum>
inline constexpr int kEnumerators = internal::CountEnumerators<Enum>();

}  // namespace slicefarm
