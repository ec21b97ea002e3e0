#pragma once

#include <cstdint>
#include <string>

namespace slicefarm {

/// Who asks: a whole profile, of which many keys may mean nothing here, or a person who names what
/// they want.
enum class Source : uint8_t { kProfile, kRequest };

/// A key of a config.ini and its value, as text: newlines as `\n`.
struct Setting {
  std::string key;
  std::string value;
  Source source = Source::kRequest;

  friend bool operator==(const Setting&, const Setting&) = default;
};

}  // namespace slicefarm
