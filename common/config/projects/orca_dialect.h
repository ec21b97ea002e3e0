#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config {

/// Function that returns the first value of a setting of OrcaSlicer or Bambu Studio, or nullopt if
/// the setting is not given.
using OrcaLookup = std::function<std::optional<std::string>(std::string_view key)>;

/// Returns slicefarm's settings for parts of the G-code that OrcaSlicer and Bambu Studio write in
/// another form, or without a setting: Bambu Lab's own dialect for its machines, progress, limits
/// of the machine, labels of objects, and the chamber's temperature control. Source: the G-code of
/// Bambu Studio 2.4; OrcaSlicer 2.2, Print and GCode.
std::vector<Setting> DialectOf(const OrcaLookup& given);

/// Returns true if the machine is from Bambu Lab.
bool IsBambuMachine(const OrcaLookup& given);

/// Returns a template expression that is true if an object is in the zone where the machine's head
/// checks for filament around it. `zone`: `head_wrap_detect_zone`, corners `XxY` separated by
/// commas. The comparison uses bounding boxes.
std::string HeadWrapExpression(std::string_view zone);

}  // namespace slicefarm::config
