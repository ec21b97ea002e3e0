#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

#include "common/config/table/field.h"
#include "common/config/table/value.h"
#include "common/model/options/cutter_text.h"
#include "common/model/options/settings.h"

namespace slicefarm::config {

/// Access to the row of type `Row` in JobRows, and the scope of the row's settings. The base
/// template is for a process with a single row, `Row`, in JobRows::own.
template <typename Row>
struct RowOf {
  static constexpr Scope kScope = Scope::kJob;
  template <typename Rows>
  static auto& In(Rows& rows) {
    return rows.own.template As<Row>();
  }
};
template <>
struct RowOf<JobSlicingOptions> {
  static constexpr Scope kScope = Scope::kJob;
  template <typename Rows>
  static auto& In(Rows& rows) {
    return rows.slicing;
  }
};
template <>
struct RowOf<ObjectSlicingOptions> {
  static constexpr Scope kScope = Scope::kObject;
  template <typename Rows>
  static auto& In(Rows& rows) {
    return rows.object;
  }
};

/// Base class of RowOf<Row> for a row that is member kMember of a process's rows, such as
/// FdmRows::region.
template <auto kMember, Scope kRowScope>
struct MemberRow;
template <typename Own, typename Row, Row Own::*kMember, Scope kRowScope>
struct MemberRow<kMember, kRowScope> {
  static constexpr Scope kScope = kRowScope;
  template <typename Rows>
  static auto& In(Rows& rows) {
    return rows.own.template As<Own>().*kMember;
  }
};

/// Unit of a member's number: the setting's unit, or a fraction for a setting in percent, or
/// radians for a setting in degrees.
enum class Scale { kSame, kPercent, kDegrees };

namespace internal {

/// Returns the factor for the conversion: the setting's number is the member's number times this
/// factor.
constexpr double Divisor(Scale scale) {
  return scale == Scale::kPercent ? 100 : scale == Scale::kDegrees ? 180 / std::numbers::pi : 1;
}

/// Stores a setting's value in a member, converted to the member's type.
template <class T>
void Store(T& member, const Value& value, double divisor) {
  if constexpr (std::is_same_v<T, double>) {
    member = value.number / divisor;
  } else if constexpr (std::is_same_v<T, Coord>) {
    member = FromMm(value.number);
  } else if constexpr (std::is_same_v<T, std::string>) {
    member = value.text.str();
  } else if constexpr (std::is_same_v<T, SharedText>) {
    member = value.text;
  } else if constexpr (std::is_same_v<T, Polygon>) {
    if (auto bed = ParseBedShape(value.text); bed.ok()) member = *std::move(bed);
  } else if constexpr (std::is_same_v<T, std::vector<Polygon>>) {
    if (auto areas = ParseAreas(value.text); areas.ok()) member = *std::move(areas);
  } else if constexpr (std::is_same_v<T, Point>) {
    if (const auto point = ParsePoint(value.text); point.ok()) member = *point;
  } else if constexpr (std::is_same_v<T, Cutter>) {
    if (auto cutter = ParseCutter(value.text); cutter.ok()) member = *std::move(cutter);
  } else if constexpr (std::is_same_v<T, std::vector<LayerHeightAt>>) {
    if (auto heights = ParseLayerHeights(value.text); heights.ok()) member = *std::move(heights);
  } else if constexpr (std::is_class_v<T>) {
    if (auto sizes = ParseSizes(value.text); sizes.ok()) member = *std::move(sizes);
  } else {
    member = static_cast<T>(std::lround(value.number));
  }
}

/// Returns the setting's value from a member, the inverse of Store.
template <class T>
Value Load(const T& member, double divisor) {
  if constexpr (std::is_same_v<T, double>) {
    return {.number = Quantise(member * divisor)};
  } else if constexpr (std::is_same_v<T, Coord>) {
    return {.number = Quantise(ToMm(member))};
  } else if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, SharedText>) {
    return {.text = member};
  } else if constexpr (std::is_same_v<T, Polygon>) {
    return {.text = PrintBedShape(member)};
  } else if constexpr (std::is_same_v<T, std::vector<Polygon>>) {
    return {.text = PrintAreas(member)};
  } else if constexpr (std::is_same_v<T, Point>) {
    return {.text = PrintPoint(member)};
  } else if constexpr (std::is_same_v<T, Cutter>) {
    return {.text = member.name()};
  } else if constexpr (std::is_same_v<T, std::vector<LayerHeightAt>>) {
    return {.text = PrintLayerHeights(member)};
  } else if constexpr (std::is_class_v<T>) {
    return {.text = PrintSizes(member)};
  } else {
    return {.number = static_cast<double>(member)};
  }
}

/// Returns the class that has the member. The function is only declared, for use in decltype.
template <typename Class, typename Member>
Class ClassOf(Member Class::*);

/// Returns the member at the end of a path that begins at `object`. Each step of the path is either
/// a pointer to a member or an index.
template <auto kStep, auto... kRest>
auto& Follow(auto& object) {
  const auto step = [&]() -> auto& {
    if constexpr (std::is_member_object_pointer_v<decltype(kStep)>) {
      return object.*kStep;
    } else {
      return object[static_cast<size_t>(kStep)];
    }
  };
  if constexpr (sizeof...(kRest) == 0) {
    return step();
  } else {
    return Follow<kRest...>(step());
  }
}

/// Returns the field for the member at the end of a path (see Follow) that begins at a row.
template <Scale kScale, auto kFirst, auto... kRest>
Field BindPath() {
  using Row = decltype(ClassOf(kFirst));
  constexpr double kDivisor = Divisor(kScale);
  return {[](JobRows& rows, const Value& value) {
            Store(Follow<kFirst, kRest...>(RowOf<Row>::In(rows)), value, kDivisor);
          },
          [](const JobRows& rows) {
            return Load(Follow<kFirst, kRest...>(RowOf<Row>::In(rows)), kDivisor);
          },
          RowOf<Row>::kScope};
}

}  // namespace internal

/// Returns the field for a member of a row. The member's type determines how a value is converted:
/// lengths are given in mm, enumerations by number. A path ends at a member or at an item of an
/// array:
///       Bind<&RegionRow::infill, &InfillOptions::overlap_nm>()
///       Bind<Scale::kPercent, &RegionRow::infill, &InfillOptions::density>()
///       Bind<&MachineRow::motion, &MachineMotion::acceleration_mm_s2, Feature::kPerimeter>()
template <auto kFirst, auto... kRest>
Field Bind() {
  if constexpr (std::is_same_v<decltype(kFirst), Scale>) {
    return internal::BindPath<kFirst, kRest...>();
  } else {
    return internal::BindPath<Scale::kSame, kFirst, kRest...>();
  }
}

/// Returns the field for a value that needs a special conversion. `Set`: void(Row&, const Value&),
/// `Get`: Value(const Row&), both without captures.
template <typename Row, typename Set, typename Get>
Field Convert(Set, Get) {
  static_assert(std::is_empty_v<Set> && std::is_empty_v<Get>, "the lambdas must not capture");
  return {[](JobRows& rows, const Value& value) { Set{}(RowOf<Row>::In(rows), value); },
          [](const JobRows& rows) -> Value { return Get{}(RowOf<Row>::In(rows)); },
          RowOf<Row>::kScope};
}

}  // namespace slicefarm::config
