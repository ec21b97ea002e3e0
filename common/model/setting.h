#pragma once

#include <cstdint>
#include <string>

namespace slicefarm {

/// Origin of a setting. A profile is a whole file, and slicefarm may not know many of its keys. A
/// request contains only settings that a person chose.
enum class Source : uint8_t { kProfile, kRequest };

/// Key and value of a config.ini, as text. Newlines in the value are written as `\n`.
struct Setting {
  std::string key;
  std::string value;
  Source source = Source::kRequest;

  friend bool operator==(const Setting&, const Setting&) = default;
};

}  // namespace slicefarm
