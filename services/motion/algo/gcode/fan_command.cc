#include "services/motion/algo/gcode/fan_command.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicefarm::motion {
namespace {

constexpr int32_t kFullPercent = 100;
/// Largest rise without a time at full speed.
constexpr int32_t kSmallRise = 10;

}  // namespace

void WriteFan(int32_t percent, GcodeText& out) {
  if (percent <= 0) {
    out << "M107\n";
    return;
  }
  out << "M106 S";
  out.Integer(std::lround(std::min(percent, kFullPercent) * 2.55)) << '\n';
}

void FanCommand::Set(int32_t percent, GcodeText& out) {
  const int32_t before = std::exchange(percent_, percent);
  if (percent == before) return;
  const int32_t rise = percent - before;
  const bool kicks =
      limits_.kickstart_s > 0 && before >= 0 && rise > kSmallRise && percent < kFullPercent;
  if (!kicks) {
    kick_s_ = 0;
    return WriteFan(percent, out);
  }
  if (kick_s_ <= 0) WriteFan(kFullPercent, out);
  kick_s_ = std::max(0.0, kick_s_) + limits_.kickstart_s * rise / kFullPercent;
}

void FanCommand::Pass(double time_s, GcodeText& out) {
  if (kick_s_ <= 0) return;
  kick_s_ -= time_s;
  if (kick_s_ <= 0) WriteFan(percent_, out);
}

void FanCommand::Finish(GcodeText& out) {
  if (std::exchange(kick_s_, 0) > 0) WriteFan(percent_, out);
}

}  // namespace slicefarm::motion
