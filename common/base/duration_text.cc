#include "common/base/duration_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace slicefarm {

std::string DurationText(double seconds) {
  int64_t left = std::llround(std::clamp(seconds, 0.0, 1e12));
  struct Unit {
    int64_t seconds;
    char letter;
  };
  std::string text;
  for (const Unit unit : {Unit{86'400, 'd'}, Unit{3'600, 'h'}, Unit{60, 'm'}, Unit{1, 's'}}) {
    const int64_t count = left / unit.seconds;
    left %= unit.seconds;
    if (count == 0 && text.empty() && unit.letter != 's') continue;
    if (!text.empty()) text += ' ';
    text += std::to_string(count) + unit.letter;
  }
  return text;
}

}  // namespace slicefarm
