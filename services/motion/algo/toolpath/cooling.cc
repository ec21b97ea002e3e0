#include "services/motion/algo/toolpath/cooling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

constexpr int kMaxTrials = 12;
/// The layer's time may miss the wanted one by this share.
constexpr double kTolerance = 0.002;

/// Sets the beads' feed rates to `share` of the full ones.
void SetSpeeds(const std::vector<int32_t>& full, double share, int32_t least, Toolpath& path) {
  for (size_t i = 0; i < full.size(); ++i) {
    Move& move = path.moves[i];
    if (move.kind != MoveKind::kPrint) continue;
    const auto slowed = static_cast<int32_t>(std::lround(full[i] * share));
    move.feed_rate = std::max(slowed, std::min(least, full[i]));
  }
}

using FeedRates = std::vector<std::vector<int32_t>>;  // by toolpath

FeedRates FeedRatesOf(std::span<const Toolpath> paths) {
  FeedRates rates;
  for (const Toolpath& path : paths) {
    std::vector<int32_t>& own = rates.emplace_back();
    own.reserve(path.moves.size());
    for (const Move& move : path.moves) own.push_back(move.feed_rate);
  }
  return rates;
}

void SetSpeeds(const FeedRates& full, double share, int32_t least, std::span<Toolpath> paths) {
  for (size_t i = 0; i < paths.size(); ++i) SetSpeeds(full[i], share, least, paths[i]);
}

int32_t FastestBead(std::span<const Toolpath> paths) {
  int32_t fastest = 0;
  for (const Toolpath& path : paths) {
    for (const Move& move : path.moves) {
      if (move.kind == MoveKind::kPrint) fastest = std::max(fastest, move.feed_rate);
    }
  }
  return fastest;
}

/// Off in the first layers; its share then grows layer by layer.
int32_t Grown(const CoolingOptions& cooling, int32_t layer_index, int32_t percent) {
  const int32_t full = cooling.full_fan_speed_layer;
  // A fan that grows begins with none in the first layer.
  const int32_t off = std::max(cooling.disable_fan_first_layers, full > 0 ? 1 : 0);
  if (layer_index < off) return 0;
  if (layer_index + 1 >= full) return percent;
  const double share = static_cast<double>(layer_index + 1 - off) / (full - off);
  return static_cast<int32_t>(std::lround(percent * share));
}

/// By the layer's time alone.
int32_t FullFan(const CoolingOptions& cooling, double layer_time_s) {
  const int32_t least = cooling.fan_always_on ? cooling.min_fan_percent : 0;
  if (!cooling.enabled || layer_time_s >= cooling.fan_below_layer_time_s) return least;
  if (layer_time_s <= cooling.slowdown_below_layer_time_s) return cooling.max_fan_percent;
  const double share = (cooling.fan_below_layer_time_s - layer_time_s) /
                       (cooling.fan_below_layer_time_s - cooling.slowdown_below_layer_time_s);
  const double percent =
      cooling.min_fan_percent + share * (cooling.max_fan_percent - cooling.min_fan_percent);
  return static_cast<int32_t>(std::lround(percent));
}

double Sum(std::span<const double> times) {
  return std::accumulate(times.begin(), times.end(), 0.0);
}

}  // namespace

std::span<const double> SlowDown(const CoolingOptions& cooling, std::span<const Stretch> program,
                                 LayerTiming& timing, std::span<Toolpath> paths) {
  std::span<const double> times = timing.Times(program);
  const double full_time = Sum(times);
  const double wanted = cooling.slowdown_below_layer_time_s;
  if (!cooling.enabled || full_time >= wanted || full_time <= 0) return times;
  const FeedRates full = FeedRatesOf(paths);
  const int32_t least = FeedRate(cooling.min_print_speed_mm_s);
  // Time falls as the share grows. The secant in 1 / share is nearly straight; the bounds keep it
  // honest.
  double low = 0;
  double high = 1;
  double share = full_time / wanted;
  for (int i = 0; i < kMaxTrials; ++i) {
    SetSpeeds(full, share, least, paths);
    times = timing.Times(program);
    const double time = Sum(times);
    if (std::abs(time - wanted) <= kTolerance * wanted) break;
    if (time < wanted && FastestBead(paths) <= least) break;
    (time > wanted ? low : high) = share;
    const double next = share * time / wanted;
    share = next > low && next < high ? next : (low + high) / 2;
  }
  return times;
}

int32_t FanPercent(const CoolingOptions& cooling, int32_t layer_index, double layer_time_s) {
  return Grown(cooling, layer_index, FullFan(cooling, layer_time_s));
}

int32_t BridgeFanPercent(const CoolingOptions& cooling, int32_t layer_index, int32_t fan_percent) {
  return std::max(fan_percent, Grown(cooling, layer_index, cooling.bridge_fan_percent));
}

std::optional<OverhangFans> OverhangFanPercent(const CoolingOptions& cooling, int32_t layer_index) {
  if (!cooling.dynamic_fan) return std::nullopt;
  OverhangFans fans = {};
  for (size_t i = 0; i < fans.size(); ++i)
    fans[i] = Grown(cooling, layer_index, cooling.overhang_fan_percent[i]);
  return fans;
}

}  // namespace slicefarm::motion
