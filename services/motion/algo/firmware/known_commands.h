#pragma once

#include <algorithm>
#include <span>

#include "services/motion/algo/text/gcode_line.h"

namespace slicefarm::motion {

/// Numbers of the G and M commands that a firmware supports, ascending. T (select a tool) is always
/// supported.
struct KnownCommands {
  std::span<const int> g;
  std::span<const int> m;

  /// Returns true if the firmware supports the command of the line.
  bool Contain(const GcodeLine& line) const {
    const std::span<const int> numbers = line.letter == 'G' ? g : m;
    return line.letter == 'T' || ((line.letter == 'G' || line.letter == 'M') &&
                                  std::ranges::binary_search(numbers, line.number));
  }
};

}  // namespace slicefarm::motion
