#pragma once

#include <compare>
#include <cstdint>

namespace slicefarm {

/// Purpose of a stack. In a layer, the stacks of one copy are printed in the order of this enum.
enum class StackKind : uint8_t { kSkirt, kBrim, kRaft, kSupport, kPart };
inline constexpr int kStackKindCount = 5;

/// Stack::object of structures around several objects, such as the skirt. This number has one copy,
/// at the plate's origin. The copy is printed first and has no label.
inline constexpr int32_t kPlateObject = -1;

/// Number of a copy for structures and moves that belong to no copy, such as skirts and travels
/// from one copy to another.
inline constexpr int32_t kNoCopy = -1;

/// Structure that is built in layers of its own: a part, or a structure that planning adds.
struct Stack {
  /// unique id in the job; the stack of an object's part has the object's number, added stacks have
  /// higher ids
  int32_t id = 0;
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

/// Stack of the paths in Skirt and LayerPlan::paths. It has no sections, so its id -1 is never
/// searched for.
inline constexpr Stack kSkirtStack(-1, kPlateObject, StackKind::kSkirt);

}  // namespace slicefarm
