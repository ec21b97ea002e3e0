#include "services/motion/algo/toolpath/cooling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "common/base/portable_math.h"
#include "common/gcode/gcode_text.h"
#include "common/model/options/tool_row.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

constexpr int kMaxTrials = 12;
/// Largest difference of a layer's time from the wanted time, as a share.
constexpr double kTolerance = 0.002;

/// Group of beads to slow down. With consistent_surface there are two groups: kSurface is the two
/// outermost walls and the beads just before them, kInner is all other beads. Without
/// consistent_surface, kAll is used.
enum class Beads : uint8_t { kAll, kInner, kSurface };

/// Feed rates at full speed, indexed by the moves of one toolpath.
struct FullSpeeds {
  std::vector<int32_t> feed_rates;
  std::vector<bool> inner;  ///< true for beads of Beads::kInner
  bool keeps_outer_walls = false;
};

/// Returns true for the inner beads. Beads that end no more than `transition_mm` before a surface
/// bead count as surface, because the nozzle's flow settles there.
std::vector<bool> InnerBeads(const Toolpath& path, double transition_mm) {
  std::vector<bool> inner(path.moves.size(), false);
  double to_surface_mm = std::numeric_limits<double>::infinity();
  for (size_t i = path.moves.size(); i-- > 0;) {
    const Move& move = path.moves[i];
    if (move.kind != MoveKind::kPrint) continue;
    if (move.of_surface) {
      to_surface_mm = 0;
      continue;
    }
    inner[i] = to_surface_mm >= transition_mm;
    if (i == 0) continue;
    const Move& before = path.moves[i - 1];
    to_surface_mm += Hypot(move.x_um - before.x_um, move.y_um - before.y_um) / kUmPerMm;
  }
  return inner;
}

using Layer = std::vector<FullSpeeds>;  // speeds by toolpath

Layer FullSpeedsOf(const CoolingOptions& cooling, std::span<const Toolpath> paths) {
  Layer layer;
  for (const Toolpath& path : paths) {
    FullSpeeds& own = layer.emplace_back();
    own.feed_rates.reserve(path.moves.size());
    for (const Move& move : path.moves) own.feed_rates.push_back(move.feed_rate);
    own.keeps_outer_walls = cooling.keep_outer_walls;
    if (cooling.consistent_surface) own.inner = InnerBeads(path, cooling.transition_mm);
  }
  return layer;
}

/// Returns true if a move is one of the beads to slow down.
bool IsAmong(Beads beads, const FullSpeeds& full, std::span<const Move> moves, size_t move) {
  if (moves[move].kind != MoveKind::kPrint) return false;
  if (full.keeps_outer_walls && moves[move].feature == Feature::kExternalPerimeter) return false;
  return beads == Beads::kAll || full.inner[move] == (beads == Beads::kInner);
}

/// Sets the feed rates of the selected beads to `share` of the full feed rates, but at least to
/// `least`. A bead with a full feed rate below `least` keeps it.
void SetSpeeds(const FullSpeeds& full, Beads beads, double share, int32_t least, Toolpath& path) {
  for (size_t i = 0; i < full.feed_rates.size(); ++i) {
    Move& move = path.moves[i];
    if (!IsAmong(beads, full, path.moves, i)) continue;
    const int32_t rate = full.feed_rates[i];
    const auto slowed = static_cast<int32_t>(std::lround(rate * share));
    move.feed_rate = std::max(slowed, std::min(least, rate));
  }
}

void SetSpeeds(const Layer& full, Beads beads, double share, int32_t least,
               std::span<Toolpath> paths) {
  for (size_t i = 0; i < paths.size(); ++i) SetSpeeds(full[i], beads, share, least, paths[i]);
}

int32_t FastestBead(const Layer& full, Beads beads, std::span<const Toolpath> paths) {
  int32_t fastest = 0;
  for (size_t p = 0; p < paths.size(); ++p)
    for (size_t i = 0; i < paths[p].moves.size(); ++i)
      if (IsAmong(beads, full[p], paths[p].moves, i))
        fastest = std::max(fastest, paths[p].moves[i].feed_rate);
  return fastest;
}

/// Returns true if the first layer has a fan speed of its own.
bool HasFirstFan(const CoolingOptions& cooling) {
  return cooling.first_layer_fan_percent >= 0 && cooling.disable_fan_first_layers == 0;
}

/// Returns the fan speed in percent for one of the first layers: 0 or first_layer_fan_speed at
/// first, then a speed that grows layer by layer up to `percent`.
int32_t Grown(const CoolingOptions& cooling, int32_t layer_index, int32_t percent) {
  const int32_t full = cooling.full_fan_speed_layer;
  if (HasFirstFan(cooling)) {
    const int32_t first = cooling.first_layer_fan_percent;
    if (layer_index == 0) return first;
    if (layer_index + 1 >= full) return percent;
    const double share = static_cast<double>(layer_index) / (full - 1);
    return static_cast<int32_t>(std::lround(first + (percent - first) * share));
  }
  // If the fan speed grows over the first layers, the fan is off in the very first one.
  const int32_t off = std::max(cooling.disable_fan_first_layers, full > 0 ? 1 : 0);
  if (layer_index < off) return 0;
  if (layer_index + 1 >= full) return percent;
  const double share = static_cast<double>(layer_index + 1 - off) / (full - off);
  return static_cast<int32_t>(std::lround(percent * share));
}

/// Returns the fan speed in percent that the layer's time requires, regardless of the first layers.
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

namespace {

/// Slows a layer's beads down.
class Slowing {
 public:
  Slowing(const CoolingOptions& cooling, std::span<const MoveSpan> program, LayerTiming& timing,
          std::span<Toolpath> paths)
      : program_(program),
        timing_(timing),
        paths_(paths),
        full_(FullSpeedsOf(cooling, paths)),
        least_(FeedRate(cooling.min_print_speed_mm_s)),
        wanted_s_(cooling.slowdown_below_layer_time_s) {}

  /// Slows the beads down until the layer takes the wanted time, or they have reached the smallest
  /// speed. `time_s`: the layer's time at full speed. Returns the time of each move.
  ///
  /// The layer's time decreases when the share grows, and is nearly linear in 1 / share. So the
  /// secant method is used, with bounds for safety.
  std::span<const double> Slow(Beads beads, double time_s) {
    std::span<const double> times;
    double low = 0;
    double high = 1;
    double share = time_s / wanted_s_;
    for (int i = 0; i < kMaxTrials; ++i) {
      SetSpeeds(full_, beads, share, least_, paths_);
      times = timing_.Times(program_);
      const double time = Sum(times);
      if (std::abs(time - wanted_s_) <= kTolerance * wanted_s_) break;
      if (time < wanted_s_ && FastestBead(full_, beads, paths_) <= least_) break;
      (time > wanted_s_ ? low : high) = share;
      const double next =
          beads == Beads::kAll ? share * time / wanted_s_ : NextShare(time_s, share, time);
      share = next > low && next < high ? next : (low + high) / 2;
    }
    return times;
  }

 private:
  /// Returns the next share to try. It is on the secant of the time over 1 / share, through full
  /// speed and the last trial. A simple proportion is not enough, because a part of the layer's
  /// time does not depend on the share.
  double NextShare(double full_s, double share, double time_s) const {
    const double slope = (time_s - full_s) / (1 / share - 1);
    return slope > 0 ? slope / (wanted_s_ - full_s + slope) : share / 2;
  }

  const std::span<const MoveSpan> program_;
  LayerTiming& timing_;
  const std::span<Toolpath> paths_;
  const Layer full_;
  const int32_t least_;
  const double wanted_s_;
};

}  // namespace

std::span<const double> SlowDown(const CoolingOptions& cooling, std::span<const MoveSpan> program,
                                 LayerTiming& timing, std::span<Toolpath> paths) {
  std::span<const double> times = timing.Times(program);
  const double full_time = Sum(times);
  const double wanted = cooling.slowdown_below_layer_time_s;
  if (!cooling.enabled || full_time >= wanted || full_time <= 0) return times;
  Slowing slowing(cooling, program, timing, paths);
  if (!cooling.consistent_surface) return slowing.Slow(Beads::kAll, full_time);
  times = slowing.Slow(Beads::kInner, full_time);
  const double time = Sum(times);
  const bool done = time >= wanted * (1 - kTolerance);
  return done ? times : slowing.Slow(Beads::kSurface, time);
}

int32_t FanPercent(const CoolingOptions& cooling, int32_t layer_index, double layer_time_s) {
  return Grown(cooling, layer_index, FullFan(cooling, layer_time_s));
}

int32_t BridgeFanPercent(const CoolingOptions& cooling, int32_t layer_index, int32_t fan_percent) {
  const bool is_first = layer_index == 0 && HasFirstFan(cooling);
  if (!cooling.bridge_fan || is_first) return fan_percent;
  return std::max(fan_percent, Grown(cooling, layer_index, cooling.bridge_fan_percent));
}

int32_t CooledRest(const CoolingOptions& cooling) {
  if (cooling.overhang_fan_share >= 1) return -1;
  return static_cast<int32_t>(std::lround((1 - cooling.overhang_fan_share) * kFullRest));
}

bool IsOffBefore(const CoolingOptions& cooling, int32_t layer_index) {
  constexpr int32_t kFull = 100;
  return layer_index == 0 || Grown(cooling, layer_index - 1, kFull) == 0;
}

LineFans LineFanPercent(const CoolingOptions& cooling, int32_t layer_index) {
  const bool is_first = layer_index == 0 && HasFirstFan(cooling);
  if (is_first || layer_index < cooling.disable_fan_first_layers) return {};
  LineFans fans = {.interface_percent = cooling.interface_fan_percent,
                   .ironing_percent = cooling.ironing_fan_percent};
  if (cooling.bridge_fan) fans.internal_bridge_percent = cooling.internal_bridge_fan_percent;
  return fans;
}

std::optional<OverhangFans> OverhangFanPercent(const CoolingOptions& cooling, int32_t layer_index,
                                               int32_t fan_percent) {
  if (!cooling.dynamic_fan) return std::nullopt;
  OverhangFans fans = {};
  for (size_t i = 0; i < fans.size(); ++i)
    fans[i] = std::max(fan_percent, Grown(cooling, layer_index, cooling.overhang_fan_percent[i]));
  return fans;
}

}  // namespace slicefarm::motion
