#pragma once

#include <boost/preprocessor/repetition/enum_params.hpp>
#include <boost/preprocessor/repetition/repeat_from_to.hpp>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace slicefarm {

namespace internal {

/// Type that converts to any type, used to count the members of an aggregate at compile time.
struct AnyMember {
  template <typename T>
  operator T() const;  // NOLINT(google-explicit-constructor): a conversion without a body
};

/// Returns true if an aggregate of type T can be initialized with sizeof...(I) values.
template <typename T, size_t... I>
constexpr bool CanBeMadeFrom(std::index_sequence<I...>) {
  return requires { T{(static_cast<void>(I), AnyMember{})...}; };
}

inline constexpr size_t kMostMembers = 96;

/// Returns the number of members of an aggregate: the largest number of values, at most N, with
/// which it can be initialized.
template <typename T, size_t N = kMostMembers>
constexpr size_t CountMembers() {
  if constexpr (N == 0 || CanBeMadeFrom<T>(std::make_index_sequence<N>{})) {
    return N;
  } else {
    return CountMembers<T, N - 1>();
  }
}

#define SLICEFARM_TIE(z, n, unused)                                 \
  template <typename T>                                             \
  constexpr auto Tie(T& value, std::integral_constant<size_t, n>) { \
    auto& [BOOST_PP_ENUM_PARAMS(n, m)] = value;                     \
    return std::tie(BOOST_PP_ENUM_PARAMS(n, m));                    \
  }
BOOST_PP_REPEAT_FROM_TO(1, 97, SLICEFARM_TIE, ~)
#undef SLICEFARM_TIE

}  // namespace internal

/// Returns a tuple of references to the members of an aggregate, in their order. REQUIRES: at most
/// 96 members, and no base class.
template <typename T>
constexpr auto MembersOf(T& value) {
  constexpr size_t kCount = internal::CountMembers<std::remove_const_t<T>>();
  static_assert(kCount > 0, "no aggregate, or one with more than 96 members");
  return internal::Tie(value, std::integral_constant<size_t, kCount>{});
}

}  // namespace slicefarm
