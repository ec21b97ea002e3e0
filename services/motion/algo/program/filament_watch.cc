#include "services/motion/algo/program/filament_watch.h"

#include <cmath>

#include "absl/strings/str_format.h"

namespace slicefarm::motion {

std::optional<std::string> FilamentWatch::Add(const ProgramMove& move, bool custom) {
  const double mm = move.Filament();
  if (!custom && !begun_) {
    begun_ = true;
    first_depth_mm_ = depth_mm_;
  }
  if (!custom) printed_mm_ += mm;
  if (mm == 0) return std::nullopt;
  std::optional<std::string> wrong;
  if (longest_mm_ > 0 && !move.InPlane() && std::abs(mm) > longest_mm_)
    wrong = absl::StrFormat("%.2f mm of filament at once, at most %.2f", mm, longest_mm_);
  if (mm > 0 && !custom) {
    auto more = move.InPlane() ? Print() : Restart(mm);
    if (!wrong) wrong = std::move(more);
  }
  depth_mm_ = std::max(0.0, depth_mm_ - mm);
  // A remainder from a short restart or from rounding is set to 0, so that it does not add up.
  if (mm > 0 && depth_mm_ <= slack_mm_) depth_mm_ = 0;
  if (!custom) last_depth_mm_ = depth_mm_;
  return wrong;
}

std::optional<std::string> FilamentWatch::Print() {
  fresh_ = false;
  if (depth_mm_ <= slack_mm_) return std::nullopt;
  auto wrong = absl::StrFormat("prints while the filament is retracted by %.3f mm", depth_mm_);
  depth_mm_ = 0;
  return wrong;
}

std::optional<std::string> FilamentWatch::Restart(double mm) {
  if (fresh_ || depth_mm_ > 0 || mm <= slack_mm_) return std::nullopt;
  return absl::StrFormat("pushes %.3f mm of filament without a preceding retraction", mm);
}

void FilamentWatch::ChangeTool(bool custom) {
  if (!custom) {
    printed_mm_ += depth_mm_;
    last_depth_mm_ = 0;
  }
  depth_mm_ = 0;
  fresh_ = true;
}

}  // namespace slicefarm::motion
