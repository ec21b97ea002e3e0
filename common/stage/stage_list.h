#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

namespace slicefarm {

/// The stages (stages.h), of all processes.
enum class Stage : uint8_t {
  kSlicing,
  kPlanning,
  kBeading,
  kInfill,
  kOrdering,
  kMotion,
  kExposure,
  kPlacing,  ///< a method of the slicing service
  kMilling,
  kTexture,
};

struct StageInfo {
  Stage stage;
  std::string_view name;  ///< as services, flags, reports and metrics write it
};

/// All stages, in the order of Stage and of reports.
inline constexpr StageInfo kStages[] = {
    {Stage::kSlicing, "slicing"},   {Stage::kPlanning, "planning"}, {Stage::kBeading, "beading"},
    {Stage::kInfill, "infill"},     {Stage::kOrdering, "ordering"}, {Stage::kMotion, "motion"},
    {Stage::kExposure, "exposure"}, {Stage::kPlacing, "placing"},   {Stage::kMilling, "milling"},
    {Stage::kTexture, "texture"},
};

inline constexpr size_t kStageCount = std::size(kStages);

constexpr std::string_view StageName(Stage stage) {
  return kStages[static_cast<size_t>(stage)].name;
}

/// The stage of that name, or none.
constexpr std::optional<Stage> FindStage(std::string_view name) {
  for (const StageInfo& info : kStages)
    if (info.name == name) return info.stage;
  return std::nullopt;
}

/// What each stage took, in seconds of wall time as the caller sees it. A stage that a process
/// lacks takes none.
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
