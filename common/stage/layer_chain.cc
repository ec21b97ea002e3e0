#include "common/stage/layer_chain.h"

#include <fmt/format.h>

#include <utility>

#include "common/base/error.h"
#include "common/base/stopwatch.h"

namespace slicefarm {

void StageTimes::Add(const StageTimes& other) {
  slicing_s += other.slicing_s;
  beading_s += other.beading_s;
  infill_s += other.infill_s;
  ordering_s += other.ordering_s;
  motion_s += other.motion_s;
}

namespace {

/// With fewer layers around the range than the stages look at, the bytes would be others.
absl::Status CheckHalo(const Neighbourhood& all, int32_t halo) {
  const LayerRange wanted = all.range.Grown(halo, all.layer_count);
  const int32_t first = all.layers.empty() ? 0 : all.layers.front().frame.index;
  const int32_t last = first + static_cast<int32_t>(all.layers.size());
  if (first <= wanted.first && last >= wanted.last) return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
      fmt::format("layers [{}, {}) came, and the settings want those of [{}, {}) for the range",
                  first, last, wanted.first, wanted.last),
      {{"field", "layer"}});
}

/// `all` with a halo of at most `halo` layers: a stage elsewhere is sent no outlines that it does
/// not look at. REQUIRES: CheckHalo.
Neighbourhood Trimmed(const Neighbourhood& all, int32_t halo) {
  const LayerRange kept = all.range.Grown(halo, all.layer_count);
  const int32_t sent_from = all.layers.front().frame.index;
  return {all.range, all.layer_count, all.layers.subspan(kept.first - sent_from, kept.size())};
}

}  // namespace

absl::StatusOr<RangeResult> LayerChain::Run(const StageCall& call, const RangeTask& task) const {
  RangeResult result;
  const Neighbourhood neighbourhood{task.range, task.layer_count, task.layers};
  const JobSettings& settings = *task.settings;
  if (absl::Status ok = CheckHalo(neighbourhood, HaloLayers(settings)); !ok.ok()) return ok;

  auto walled = Timed(result.times.beading_s, [&] {
    return beading_.Bead(call, Trimmed(neighbourhood, BeadingHaloLayers(settings)),
                         settings.beading);
  });
  if (!walled.ok()) return walled.status();
  auto filled = Timed(result.times.infill_s, [&] {
    return infill_.Fill(call, *std::move(walled), neighbourhood, settings.infill);
  });
  if (!filled.ok()) return filled.status();
  auto ordered = Timed(result.times.ordering_s, [&] {
    return ordering_.Order(call, *std::move(filled), task.plans, settings.ordering);
  });
  if (!ordered.ok()) return ordered.status();
  auto programs = Timed(result.times.motion_s, [&] {
    return motion_.Program(call, *std::move(ordered), settings.motion);
  });
  if (!programs.ok()) return programs.status();
  result.programs = *std::move(programs);
  return result;
}

}  // namespace slicefarm
