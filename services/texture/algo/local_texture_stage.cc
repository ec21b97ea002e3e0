#include "services/texture/algo/local_texture_stage.h"

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "services/texture/algo/engrave_job.h"
#include "services/texture/algo/output/csv_text.h"
#include "services/texture/algo/output/engrave_report.h"
#include "services/texture/algo/surface_mapping.h"
#include "services/texture/algo/whole_file.h"

namespace slicefarm::texture {
namespace {

/// Map of a surface, made by the first call that needs it. A cancelled call leaves no map.
struct MapSlot {
  std::timed_mutex mutex;
  std::optional<MappedSurface> map;
};

/// Interval at which a call that waits for another call's map checks for cancellation.
constexpr std::chrono::milliseconds kLookEvery(20);

/// Locks the slot. Errors: Cancelled.
absl::StatusOr<std::unique_lock<std::timed_mutex>> Locked(MapSlot& slot,
                                                          const CancelToken& cancel) {
  std::unique_lock lock(slot.mutex, std::defer_lock);
  while (!lock.try_lock_for(kLookEvery))
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
  return lock;
}

/// Returns the job, prepared once for all calls. The preparation ignores cancellation, because
/// other calls use its result too.
absl::StatusOr<const EngraveJob*> JobOf(const StageCall& call, const Shared<EngraveInput>& input) {
  if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
  const absl::StatusOr<EngraveJob>& job = input.Once(PrepareEngraving);
  if (!job.ok()) return job.status();
  return &*job;
}

absl::StatusOr<EngravedLayer> LayerOf(const EngraveJob& job, const LayerPath& path) {
  EngravedLayer layer{.numbers = NumbersOf(path), .program = {}, .text = {}};
  if (job.format == EngraveFormat::kCsv) {
    layer.text = CsvRows(path);
    return layer;
  }
  EngraveProgram program(job.program, SafeHeight(job.plan, job.program));
  auto text = program.Layer(path);
  if (!text.ok()) return text.status();
  layer.text = *std::move(text);
  layer.program = program.facts();
  return layer;
}

/// Returns the number of pieces of the job's file.
int32_t PieceCountOf(const EngraveJob& job) {
  return IsWhole(job.format) ? 1 : job.plan.layer_count();
}

absl::StatusOr<std::vector<EngravedLayer>> LayersOf(const EngraveJob& job, LayerRange range,
                                                    const CancelToken& cancel) {
  const auto paths = LayerPaths(job.plan, range.first, range.last, cancel);
  if (!paths.ok()) return paths.status();
  std::vector<EngravedLayer> layers;
  for (const LayerPath& path : *paths) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    auto layer = LayerOf(job, path);
    if (!layer.ok()) return layer.status();
    layers.push_back(*std::move(layer));
  }
  return layers;
}

class LocalTexture : public TextureStage {
 public:
  absl::StatusOr<MappedSurface> Map(const StageCall& call,
                                    const Shared<SurfaceInput>& surface) const override {
    const auto& slot =
        surface.Once([](const SurfaceInput&) { return std::make_unique<MapSlot>(); });
    const auto lock = Locked(*slot, call.cancel);
    if (!lock.ok()) return lock.status();
    if (slot->map) return *slot->map;
    auto map = MapSurface(*surface, call.cancel);
    if (map.ok()) slot->map = *map;
    return map;
  }

  absl::StatusOr<EngraveLayout> LayOut(const StageCall& call,
                                       const Shared<EngraveInput>& input) const override {
    const auto job = JobOf(call, input);
    if (!job.ok()) return job.status();
    const auto map = MapReportOf((*job)->plan, call.cancel);
    if (!map.ok()) return map.status();
    EngraveLayout layout{(*job)->plan.layer_count(), "", "", *map};
    if ((*job)->format == EngraveFormat::kCsv) layout.header = kCsvHeader;
    if ((*job)->format == EngraveFormat::kGcode) {
      EngraveProgram program((*job)->program, SafeHeight((*job)->plan, (*job)->program));
      layout.header = program.Start();
      layout.footer = program.End();
    }
    return layout;
  }

  absl::StatusOr<std::vector<EngravedLayer>> Engrave(const StageCall& call,
                                                     const Shared<EngraveInput>& input,
                                                     LayerRange range) const override {
    const auto job = JobOf(call, input);
    if (!job.ok()) return job.status();
    if (range.first < 0 || range.first > range.last || range.last > PieceCountOf(**job))
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                       "the job has no such range of layers");
    if (!IsWhole((*job)->format)) return LayersOf(**job, range, call.cancel);
    std::vector<EngravedLayer> pieces(static_cast<size_t>(range.size()));
    for (EngravedLayer& piece : pieces) {
      auto file = WholeFile(**job, call.cancel);
      if (!file.ok()) return file.status();
      piece.text = *std::move(file);
    }
    return pieces;
  }
};

}  // namespace

std::unique_ptr<TextureStage> MakeLocalTexture() { return std::make_unique<LocalTexture>(); }

}  // namespace slicefarm::texture
