#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

namespace slicefarm {

/// Stages (stages.h) of all processes.
enum class Stage : uint8_t {
  kSlicing,
  kPlanning,
  kBeading,
  kInfill,
  kOrdering,
  kMotion,
  kExposure,
  kPlacing,  ///< stage for meshes; a method of the slicing service
  kMilling,
  kTexture,
};

/// Name of a stage.
struct StageInfo {
  Stage stage;
  std::string_view name;  ///< name in services, flags, reports and metrics
};

/// Table of all stages, in the order of Stage and of reports.
inline constexpr StageInfo kStages[] = {
    {Stage::kSlicing, "slicing"},   {Stage::kPlanning, "planning"}, {Stage::kBeading, "beading"},
    {Stage::kInfill, "infill"},     {Stage::kOrdering, "ordering"}, {Stage::kMotion, "motion"},
    {Stage::kExposure, "exposure"}, {Stage::kPlacing, "placing"},   {Stage::kMilling, "milling"},
    {Stage::kTexture, "texture"},
};

inline constexpr size_t kStageCount = std::size(kStages);

/// Returns the name of a stage, such as "slicing".
constexpr std::string_view StageName(Stage stage) {
  return kStages[static_cast<size_t>(stage)].name;
}

/// Returns the stage of that name, or nullopt.
constexpr std::optional<Stage> FindStage(std::string_view name) {
  for (const StageInfo& info : kStages)
    if (info.name == name) return info.stage;
  return std::nullopt;
}

/// Wall time of each stage in seconds, as measured by the caller. For a stage that the process does
/// not have, it is 0.
class StageTimes {
 public:
  double& operator[](Stage stage) { return seconds_[static_cast<size_t>(stage)]; }
  double operator[](Stage stage) const { return seconds_[static_cast<size_t>(stage)]; }

  void Add(const StageTimes& other) {
    for (const StageInfo& info : kStages) (*this)[info.stage] += other[info.stage];
  }

  friend bool operator==(const StageTimes&, const StageTimes&) = default;

 private:
  std::array<double, kStageCount> seconds_ = {};
};

}  // namespace slicefarm
