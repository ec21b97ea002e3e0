#pragma once

#include <string_view>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config {

/// Where the setting may be given, as PrusaSlicer has it.
Scope ScopeOf(std::string_view key);

/// "the job", "an object", "a region".
std::string_view ScopeName(Scope scope);

}  // namespace slicefarm::config
