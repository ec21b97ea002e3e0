#include "common/wire/layers/region_wire.h"

#include <utility>

#include "common/model/limits.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

static_assert(v1::ROLE_PART == static_cast<int>(Role::kPart) + 1);
static_assert(v1::ROLE_BRIM == static_cast<int>(Role::kBrim) + 1);
static_assert(v1::ROLE_RAFT == static_cast<int>(Role::kRaft) + 1);
static_assert(v1::ROLE_RAFT_INTERFACE == static_cast<int>(Role::kRaftInterface) + 1);
static_assert(v1::ROLE_SUPPORT == static_cast<int>(Role::kSupport) + 1);
static_assert(v1::ROLE_SUPPORT_INTERFACE == static_cast<int>(Role::kSupportInterface) + 1);
static_assert(v1::Role_MAX == kRoleCount);
static_assert(v1::STACK_KIND_SKIRT == static_cast<int>(StackKind::kSkirt) + 1);
static_assert(v1::STACK_KIND_BRIM == static_cast<int>(StackKind::kBrim) + 1);
static_assert(v1::STACK_KIND_RAFT == static_cast<int>(StackKind::kRaft) + 1);
static_assert(v1::STACK_KIND_SUPPORT == static_cast<int>(StackKind::kSupport) + 1);
static_assert(v1::STACK_KIND_PART == static_cast<int>(StackKind::kPart) + 1);
static_assert(v1::StackKind_MAX == kStackKindCount);

struct Owner {
  Role role = Role::kPart;
  int32_t settings = 0;
  int32_t tool = 0;
};

template <typename Proto>
absl::StatusOr<Owner> OwnerFromProto(const Proto& proto) {
  const absl::StatusOr<Role> role = EnumFromProto<Role>(proto.role(), kRoleCount, "role");
  if (!role.ok()) return role.status();
  if (proto.settings() < 0) return Malformed("settings", "is negative");
  if (proto.tool() < 0) return Malformed("tool", "is negative");
  return Owner{*role, proto.settings(), proto.tool()};
}

template <typename Model, typename Proto>
void OwnerToProto(const Model& model, Proto* proto) {
  proto->set_role(EnumToProto<v1::Role>(model.role));
  proto->set_settings(model.settings);
  proto->set_tool(model.tool);
}

}  // namespace

absl::Status ToProto(const Region& region, v1::Region* proto) {
  OwnerToProto(region, proto);
  return ToProto(region.outlines, proto->mutable_outlines());
}

absl::StatusOr<Region> FromProto(const v1::Region& proto) {
  const absl::StatusOr<Owner> owner = OwnerFromProto(proto);
  if (!owner.ok()) return owner.status();
  absl::StatusOr<MultiPolygon> outlines = FromProto(proto.outlines());
  if (!outlines.ok()) return Within("outlines", outlines.status());
  return Region{owner->role, owner->settings, owner->tool, *std::move(outlines)};
}

absl::Status ToProto(const FillArea& area, v1::FillArea* proto) {
  OwnerToProto(area, proto);
  return ToProto(area.area, proto->mutable_area());
}

absl::StatusOr<FillArea> FromProto(const v1::FillArea& proto) {
  const absl::StatusOr<Owner> owner = OwnerFromProto(proto);
  if (!owner.ok()) return owner.status();
  absl::StatusOr<MultiPolygon> area = FromProto(proto.area());
  if (!area.ok()) return Within("area", area.status());
  return FillArea{owner->role, owner->settings, owner->tool, *std::move(area)};
}

void ToProto(const Stack& stack, v1::Stack* proto) {
  proto->set_id(stack.id);
  proto->set_object(stack.object);
  proto->set_kind(EnumToProto<v1::StackKind>(stack.kind));
}

absl::StatusOr<Stack> FromProto(const v1::Stack& proto) {
  const absl::StatusOr<StackKind> kind =
      EnumFromProto<StackKind>(proto.kind(), kStackKindCount, "stack.kind");
  if (!kind.ok()) return kind.status();
  if (*kind == StackKind::kSkirt) {
    if (proto.id() != kSkirtStack.id || proto.object() != kSkirtStack.object)
      return Malformed("stack", "is not the skirt's");
    return kSkirtStack;
  }
  if (absl::Status ok = CheckStack("stack.id", proto.id()); !ok.ok()) return ok;
  const bool is_part = *kind == StackKind::kPart;
  const int32_t least = is_part ? 0 : kPlateObject;
  if (proto.object() < least || proto.object() >= limits::kMaxObjects)
    return Malformed("stack.object", "is not the index of an object");
  if (is_part && proto.id() != proto.object())
    return Malformed("stack.id", "is not that of the object's part");
  return Stack(proto.id(), proto.object(), *kind);
}

absl::Status CheckStack(std::string_view field, int32_t id) {
  if (0 <= id && id < limits::kMaxStacks) return absl::OkStatus();
  return Malformed(field, "is not the number of a stack");
}

absl::Status ToProto(const Mark& mark, v1::Mark* proto) {
  proto->set_role(EnumToProto<v1::PartRole>(mark.role));
  return ToProto(mark.outlines, proto->mutable_outlines());
}

absl::StatusOr<Mark> FromProto(const v1::Mark& proto) {
  constexpr int kPartRoleCount = v1::PartRole_MAX;
  const auto role = EnumFromProto<PartRole>(proto.role(), kPartRoleCount, "role");
  if (!role.ok()) return role.status();
  absl::StatusOr<MultiPolygon> outlines = FromProto(proto.outlines());
  if (!outlines.ok()) return Within("outlines", outlines.status());
  return Mark{*role, *std::move(outlines)};
}

absl::Status CheckSection(int32_t layer, int64_t height_nm) {
  if (layer < 0 || layer >= limits::kMaxLayers) {
    return Malformed("layer", "is not the index of a layer");
  }
  if (height_nm <= 0 || height_nm > limits::kMaxCoord) {
    return Malformed("height_nm", "is not a height");
  }
  return absl::OkStatus();
}

}  // namespace slicefarm
