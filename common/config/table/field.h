#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "common/config/value.h"
#include "common/model/milling/cutter_text.h"
#include "common/model/options/settings.h"

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

/// Scope of the settings in a row.
template <typename Row>
inline constexpr Scope kScopeOf = Scope::kJob;
template <>
inline constexpr Scope kScopeOf<ObjectSlicingOptions> = Scope::kObject;
template <>
inline constexpr Scope kScopeOf<ObjectRow> = Scope::kObject;
template <>
inline constexpr Scope kScopeOf<RegionRow> = Scope::kRegion;
template <>
inline constexpr Scope kScopeOf<ExposureOptions> = Scope::kRegion;

/// The member of a resolved set that a setting sets.
struct Field {
  void (*set)(JobRows&, const Value&) = nullptr;
  Value (*get)(const JobRows&) = nullptr;
  Scope scope = Scope::kJob;  ///< scope of the row that has the member
};

/// Relation of the number in a member to the setting's.
enum class Scale { kSame, kPercent, kDegrees };

namespace internal {

/// Returns the row of type `Row`.
template <typename Row, typename Rows>
auto& RowIn(Rows& rows) {
  if constexpr (std::is_same_v<Row, JobSlicingOptions>) {
    return rows.slicing;
  } else if constexpr (std::is_same_v<Row, ObjectSlicingOptions>) {
    return rows.object;
  } else if constexpr (std::is_same_v<Row, MachineRow>) {
    return FdmOf(rows).machine;
  } else if constexpr (std::is_same_v<Row, ObjectRow>) {
    return FdmOf(rows).object;
  } else if constexpr (std::is_same_v<Row, RegionRow>) {
    return FdmOf(rows).region;
  } else if constexpr (std::is_same_v<Row, ToolRow>) {
    return FdmOf(rows).tool;
  } else if constexpr (std::is_same_v<Row, ExposureOptions>) {
    return ExposureOf(rows).region;
  } else if constexpr (std::is_same_v<Row, ExposureOutput>) {
    return ExposureOf(rows).output;
  } else {
    return std::get<Row>(rows.own);
  }
}

constexpr double Divisor(Scale scale) {
  return scale == Scale::kPercent ? 100 : scale == Scale::kDegrees ? 180 / std::numbers::pi : 1;
}

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

template <typename Class, typename Member>
Class ClassOf(Member Class::*);

/// Returns the member that a path of pointers to members and indices leads to.
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

template <Scale kScale, auto kFirst, auto... kRest>
Field BindPath() {
  using Row = decltype(ClassOf(kFirst));
  constexpr double kDivisor = Divisor(kScale);
  return {[](JobRows& rows, const Value& value) {
            Store(Follow<kFirst, kRest...>(RowIn<Row>(rows)), value, kDivisor);
          },
          [](const JobRows& rows) {
            return Load(Follow<kFirst, kRest...>(RowIn<Row>(rows)), kDivisor);
          },
          kScopeOf<Row>};
}

}  // namespace internal

/// Returns the field of a row's member. The member's type says how a value becomes one: lengths are
/// given in mm, enumerations by number. A path ends at a member or at an item of an array:
///     Bind<&RegionRow::infill, &InfillOptions::overlap_nm>()
///     Bind<Scale::kPercent, &RegionRow::infill, &InfillOptions::density>()
///     Bind<&MachineRow::motion, &MachineMotion::acceleration_mm_s2, Feature::kPerimeter>()
template <auto kFirst, auto... kRest>
Field Bind() {
  if constexpr (std::is_same_v<decltype(kFirst), Scale>) {
    return internal::BindPath<kFirst, kRest...>();
  } else {
    return internal::BindPath<Scale::kSame, kFirst, kRest...>();
  }
}

/// Returns the field of a value that needs a conversion of its own. `Set`: void(Row&, const Value&),
/// `Get`: Value(const Row&), both without captures.
template <typename Row, typename Set, typename Get>
Field Convert(Set, Get) {
  static_assert(std::is_empty_v<Set> && std::is_empty_v<Get>, "the lambdas must not capture");
  return {[](JobRows& rows, const Value& value) { Set{}(internal::RowIn<Row>(rows), value); },
          [](const JobRows& rows) -> Value { return Get{}(internal::RowIn<Row>(rows)); },
          kScopeOf<Row>};
}

}  // namespace slicefarm::config
