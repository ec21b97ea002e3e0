#include "processes/fdm/settings/region_table.h"

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::config::fdm {

RegionTable::Walls RegionTable::WallsOf(const JobSettings& settings) {
  Walls walls{FdmOf(settings).beading.front(), FdmOf(settings).ordering.walls.front(),
              FdmOf(settings).motion.speeds.front()};
  walls.beading.wall_class = 0;
  for (const Feature feature :
       {Feature::kInternalInfill, Feature::kSolidInfill, Feature::kTopSolidInfill,
        Feature::kBridgeInfill, Feature::kSkirt, Feature::kSupport, Feature::kSupportInterface,
        Feature::kIroning, Feature::kSolidOverBridge})
    walls.speeds.speed_mm_s[static_cast<size_t>(feature)] = 0;
  return walls;
}

int32_t RegionTable::ClassOf(const Walls& walls) {
  for (size_t i = 0; i < classes_.size(); ++i)
    if (classes_[i] == walls) return static_cast<int32_t>(i);
  classes_.push_back(walls);
  return static_cast<int32_t>(classes_.size() - 1);
}

absl::StatusOr<int32_t> RegionTable::RowOf(const JobSettings& settings) {
  BeadingOptions beading = FdmOf(settings).beading.front();
  beading.wall_class = ClassOf(WallsOf(settings));
  for (size_t i = 0; i < beading_.size(); ++i) {
    if (beading_[i] == beading && infill_[i] == FdmOf(settings).infill.front() &&
        order_[i] == FdmOf(settings).ordering.walls.front() &&
        speeds_[i] == FdmOf(settings).motion.speeds.front())
      return static_cast<int32_t>(i);
  }
  const int64_t rows = std::ssize(beading_) + 1;
  if (rows > limits::kMaxRegionSettings)
    return LimitError(Reason::kRequestTooLarge, "different sets of settings of regions",
                      limits::kMaxRegionSettings, rows);
  beading_.push_back(beading);
  infill_.push_back(FdmOf(settings).infill.front());
  order_.push_back(FdmOf(settings).ordering.walls.front());
  speeds_.push_back(FdmOf(settings).motion.speeds.front());
  return static_cast<int32_t>(rows - 1);
}

void RegionTable::PutInto(JobSettings& settings) const {
  FdmOf(settings).beading = beading_;
  FdmOf(settings).infill = infill_;
  FdmOf(settings).ordering.walls = order_;
  FdmOf(settings).motion.speeds = speeds_;
}

}  // namespace slicefarm::config::fdm
