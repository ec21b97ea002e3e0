#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config {

/// Returns the first value of a setting of OrcaSlicer's or Bambu Studio's; nothing: not given.
using OrcaLookup = std::function<std::optional<std::string>(std::string_view key)>;

/// Returns what these programs write by themselves, as settings of ours: Bambu Lab's own dialect for
/// its machines, the progress, limits of the machine, labels of objects.
/// Source: the G-code of Bambu Studio 2.4; OrcaSlicer 2.2, Print and GCode.
std::vector<Setting> DialectOf(const OrcaLookup& given);

/// Returns true if the machine is one of Bambu Lab's.
bool IsBambuMachine(const OrcaLookup& given);

/// Returns an expression that is true if something stands where the head of the machine looks for
/// filament around it (`head_wrap_detect_zone`: corners `XxY`, by commas); by boxes.
std::string HeadWrapExpression(std::string_view zone);

}  // namespace slicefarm::config
