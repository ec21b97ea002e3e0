#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/process_settings.h"
#include "common/config/row_table.h"
#include "common/model/options/settings.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::fdm {

/// Settings of the regions of a plate for FDM: one row for each different set of region settings.
class RegionTable : public RegionRows {
 public:
  absl::StatusOr<int32_t> RowOf(const JobRows& settings) override;
  /// Turns the directions of lines, if the settings of the row ask for it.
  absl::StatusOr<int32_t> TurnedRow(int32_t row, double angle_rad) override;
  int64_t size() const override { return std::ssize(table_.rows()); }
  void PutInto(JobSettings& plate) const override { FdmOf(plate).regions = table_.rows(); }

 private:
  RowTable<RegionRow> table_;
  std::vector<RegionRow> wall_classes_;  ///< rows reduced by WallsOf, one per wall_class
};

}  // namespace slicefarm::config::fdm
