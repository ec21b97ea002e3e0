#include "services/milling/algo/waterline/refine.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace slicefarm::milling {
namespace {

constexpr int kMaxRefineDepth = 16;

/// Returns a crossing of the contour between a and b, on a fiber through the middle of the chord
/// ab. The contour leads from a to b with the gouged area on its left.
std::optional<Crossing> Between(const Crossing& a, const Crossing& b, const LevelPush& level) {
  const double dx = b.x - a.x, dy = b.y - a.y, reach = std::sqrt(dx * dx + dy * dy);
  const bool column = std::abs(dx) >= std::abs(dy);
  const double across = column ? (a.x + b.x) / 2 : (a.y + b.y) / 2;
  const double middle = column ? (a.y + b.y) / 2 : (a.x + b.x) / 2;
  const bool high = column ? dx < 0 : dy > 0;
  const FiberFrame& frame = column ? level.y : level.x;
  const IntervalSet gouged = PushLocally(frame, level.cutter, level.triangles, {across, level.z_mm},
                                         middle - reach, middle + reach);
  const Interval* nearest = nullptr;
  double off = reach;
  for (const Interval& i : gouged.items()) {
    const double away = std::abs((high ? i.high : i.low) - middle);
    if (away < off) off = away, nearest = &i;
  }
  if (nearest == nullptr) return std::nullopt;
  const double end = high ? nearest->high : nearest->low;
  return Crossing{.x = column ? across : end,
                  .y = column ? end : across,
                  .source = high ? nearest->high_source : nearest->low_source,
                  .axis = column ? FiberAxis::kY : FiberAxis::kX,
                  .high = high};
}

/// Appends the refined crossings between `from` and `to`, without both.
void AppendBetween(const Crossing& from, const Crossing& to, const LevelPush& level,
                   const Refinement& how, int depth, WovenLoop& loop) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
  if (depth == 0 || !(length > 2 * how.least_step_mm)) return;
  const auto between = Between(from, to, level);
  if (!between) return;
  const double off = std::abs(dx * (between->y - from.y) - dy * (between->x - from.x)) / length;
  if (off <= how.tolerance_mm) return;
  AppendBetween(from, *between, level, how, depth - 1, loop);
  loop.push_back(*between);
  AppendBetween(*between, to, level, how, depth - 1, loop);
}

}  // namespace

WovenLoop Refined(const WovenLoop& loop, const LevelPush& level, const Refinement& how,
                  const CancelToken& cancel) {
  WovenLoop refined;
  for (size_t i = 0; i < loop.size() && !cancel.Cancelled(); ++i) {
    refined.push_back(loop[i]);
    AppendBetween(loop[i], loop[(i + 1) % loop.size()], level, how, kMaxRefineDepth, refined);
  }
  return refined;
}

}  // namespace slicefarm::milling
