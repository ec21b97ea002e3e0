#pragma once

#include <string>
#include <vector>

namespace slicefarm {

/// Source of settings, such as a preset with its file, and the keys of its settings.
struct SettingSource {
  std::string source;  ///< text for people: `printer preset "MK4" (PrusaResearch.ini)`
  std::vector<std::string> keys;

  friend bool operator==(const SettingSource&, const SettingSource&) = default;
};

}  // namespace slicefarm
