#pragma once

#include <compare>
#include <cstdint>

namespace slicefarm {

/// What a stack is for, in the order in which those of one copy are printed in a layer.
enum class StackKind : uint8_t { kSkirt, kBrim, kRaft, kSupport, kPart };
inline constexpr int kStackKindCount = 5;

/// The object of what stands round several objects: it has one copy, at the plate's origin, that is
/// printed before all others and has no label.
inline constexpr int32_t kPlateObject = -1;

/// What is built up layer on layer, with layers of its own: a part, or what planning adds to it.
struct Stack {
  int32_t id = 0;      ///< in the job; a part has its object's number, others follow
  int32_t object = 0;  ///< whose copies, passes and labels it shares
  StackKind kind = StackKind::kPart;

  constexpr Stack() = default;
  /// An object's part.
  constexpr Stack(int32_t part) : id(part), object(part) {}  // NOLINT(google-explicit-constructor)
  constexpr Stack(int32_t id, int32_t object, StackKind kind)
      : id(id), object(object), kind(kind) {}

  bool IsPart() const { return kind == StackKind::kPart; }
  friend bool operator==(const Stack&, const Stack&) = default;
};

/// The finished paths that layers begin with: they have no sections, so that nobody looks for them.
inline constexpr Stack kSkirtStack(-1, kPlateObject, StackKind::kSkirt);

}  // namespace slicefarm
