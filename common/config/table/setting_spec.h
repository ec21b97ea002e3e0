#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "common/config/value.h"
#include "common/model/milling/cutter_text.h"
#include "common/model/options/settings.h"

namespace slicefarm::config {

enum class Kind {
  kFlag,  ///< 0 or 1
  kInteger,
  kNumber,
  kPercent,          ///< `20%`, or `20`
  kNumberOrPercent,  ///< a number, or a percentage of the setting `relative_to`
  kChoice,           ///< one of `choices`
  kText,             ///< one line
  kGcode,            ///< lines of G-code, `\n` between them
  kBedShape,
  kAreas,  ///< areas of the bed (ParseAreas); empty: none
  kPoint,  ///< `XxY`
  kSizes,
  // JSON on one line (common/model/fields/field_text.h); empty: none
  kDensityField,
  kStressField,
  kMaterialField,
  kAngles,         ///< angles by layer (common/model/options/fill_angles.h); empty: none
  kFlowTable,      ///< factors by length (common/model/options/flow_table.h)
  kHeightCode,     ///< JSON on one line (common/model/options/height_code.h); empty: none
  kLayerHeights,   ///< z and height by turns (common/model/options/layer_heights.h); empty: none
  kSubstitutions,  ///< texts by fours (common/gcode/substitutions.h); empty: none
  kCutter,         ///< a milling cutter (common/model/milling/cutter_text.h)
};

/// One name of a choice. PrusaSlicer's names that are not made yet stand in the table too: `note`
/// then says what is done instead, and the value counts as one without full effect.
struct Choice {
  std::string_view name;
  int value = 0;
  std::string_view note = {};
};

/// Whether the setting is a list in a config.ini; its first item counts.
enum class List {
  kNone,
  kPerExtruder,  ///< one item per extruder
  kPerMode,      ///< normal and silent mode of the machine
};

/// The narrowest place where a setting may be given; wider ones are fine as well.
enum class Scope {
  kJob,     ///< one value for all
  kObject,  ///< an object may have its own
  kRegion,  ///< so may a part, a modifier and a range of heights
};

/// "the job", "an object", "a region".
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

/// Where a value lives in JobSettings: in the first row of its tables.
struct Field {
  void (*set)(JobSettings&, const Value&) = nullptr;
  Value (*get)(const JobSettings&) = nullptr;
};

/// machine_limits_usage = ignore.
inline constexpr int kIgnoreLimits = 2;

/// What a config.ini writes for "no value".
inline constexpr std::string_view kNotSet = "nil";

/// One setting: all that reading, checking, documenting and printing it takes.
struct SettingSpec {
  std::string_view key;
  Kind kind = Kind::kNumber;
  std::string_view unit = {};
  double min = 0;  ///< of numbers, in `unit`; of kNumberOrPercent, for what the percentage comes to
  double max = 0;
  std::string_view standard = {};  ///< the value when none is given, as a config.ini writes it
  std::string_view doc = {};
  std::vector<Choice> choices = {};
  std::string_view relative_to = {};
  std::string_view percent_of = {};  ///< where it relates to no setting: to what, in words
  List list = List::kNone;
  Scope scope = Scope::kJob;
  Field field = {};  ///< none: it works through other settings only (derive.h)
  Field also = {};   ///< a second place for the same value
};

/// How the number in a field differs from the setting's.
enum class Scale { kSame, kPercent, kDegrees };

namespace internal {

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

}  // namespace internal

/// `T`, const if `Job` is: for views of JobSettings.
template <class T, class Job>
using Like = std::conditional_t<std::is_const_v<Job>, const T, T>;

/// The field that `member` names of a view of the job's settings, which takes its type's own
/// conversion: Coord from mm, enumerations by number. View<Job> is what a process lets its table
/// see, made from a JobSettings& or a const one.
template <template <class Job> class View, Scale kScale, class Member>
Field BindTo(Member) {
  static_assert(std::is_empty_v<Member>, "the lambda must not capture");
  constexpr double kDivisor = internal::Divisor(kScale);
  return {[](JobSettings& s, const Value& v) {
            View<JobSettings> view(s);
            internal::Store(Member{}(view), v, kDivisor);
          },
          [](const JobSettings& s) {
            View<const JobSettings> view(s);
            return internal::Load(Member{}(view), kDivisor);
          }};
}

}  // namespace slicefarm::config
