#pragma once

#include <compare>
#include <cstdint>

namespace slicefarm {

/// Purpose of a stack. The order is the order in which the stacks of one copy are printed in a
/// layer.
enum class StackKind : uint8_t { kSkirt, kBrim, kRaft, kSupport, kPart };
inline constexpr int kStackKindCount = 5;

/// Number of the object to which structures around several objects belong. It has one copy, at the
/// plate's origin. This copy is printed first and has no label.
inline constexpr int32_t kPlateObject = -1;

/// Structure that is built in layers of its own: a part, or a structure that planning adds.
struct Stack {
  int32_t id = 0;  ///< id in the job; a part has its object's number, added stacks have higher ids
  int32_t object = 0;  ///< object that provides the copies, passes and labels of the stack
  StackKind kind = StackKind::kPart;

  constexpr Stack() = default;
  /// Makes the stack of an object's part.
  constexpr Stack(int32_t part) : id(part), object(part) {}  // NOLINT(google-explicit-constructor)
  constexpr Stack(int32_t id, int32_t object, StackKind kind)
      : id(id), object(object), kind(kind) {}

  bool IsPart() const { return kind == StackKind::kPart; }
  friend bool operator==(const Stack&, const Stack&) = default;
};

/// Stack of the finished paths with which layers begin, such as the skirt. It has no sections, and
/// no code searches for them.
inline constexpr Stack kSkirtStack(-1, kPlateObject, StackKind::kSkirt);

}  // namespace slicefarm
