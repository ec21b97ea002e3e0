#include "common/stage/layer_chain.h"

#include <chrono>
#include <utility>

namespace slicefarm {
namespace {

/// Adds the time from its birth to its death to `*seconds`.
class Timer {
 public:
  explicit Timer(double* seconds) : seconds_(seconds) {}
  ~Timer() { *seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double* seconds_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

void StageTimes::Add(const StageTimes& other) {
  slicing_s += other.slicing_s;
  beading_s += other.beading_s;
  infill_s += other.infill_s;
  ordering_s += other.ordering_s;
  motion_s += other.motion_s;
}

absl::StatusOr<RangeResult> LayerChain::Run(const StageCall& call, const RangeTask& task) const {
  RangeResult result;
  const Neighbourhood neighbourhood{task.range, task.layer_count, task.layers};
  const JobSettings& settings = *task.settings;
  const auto timed = [](double* seconds, auto&& stage) {
    Timer timer(seconds);
    return stage();
  };

  auto walled = timed(&result.times.beading_s,
                      [&] { return beading_.Bead(call, neighbourhood, settings.beading); });
  if (!walled.ok()) return walled.status();
  auto filled = timed(&result.times.infill_s, [&] {
    return infill_.Fill(call, *std::move(walled), neighbourhood, settings.infill);
  });
  if (!filled.ok()) return filled.status();
  auto ordered = timed(&result.times.ordering_s, [&] {
    return ordering_.Order(call, *std::move(filled), task.plans, settings.ordering);
  });
  if (!ordered.ok()) return ordered.status();
  auto programs = timed(&result.times.motion_s, [&] {
    return motion_.Program(call, *std::move(ordered), settings.motion);
  });
  if (!programs.ok()) return programs.status();
  result.programs = *std::move(programs);
  return result;
}

}  // namespace slicefarm
