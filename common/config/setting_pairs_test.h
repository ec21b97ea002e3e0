#pragma once

#include <string>
#include <utility>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config {

using Pairs = std::vector<std::pair<std::string, std::string>>;  ///< pairs of key and value

inline std::vector<Setting> Settings(const Pairs& pairs, Source source = Source::kRequest) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : pairs) settings.push_back({key, value, source});
  return settings;
}

}  // namespace slicefarm::config
