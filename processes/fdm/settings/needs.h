#pragma once

#include <string>
#include <vector>

#include "common/config/draft.h"
#include "common/model/options/settings.h"

namespace slicefarm::config {

/// The settings that were given and have no effect because another setting switches off what they
/// are about, as `key = value: needs ...`. A profile gives every setting there is, so of a profile
/// only those count that differ from their standard.
std::vector<std::string> UnmetNeeds(const Draft& draft, const JobSettings& settings);

}  // namespace slicefarm::config
