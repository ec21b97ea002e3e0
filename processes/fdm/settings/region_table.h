#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/settings.h"

namespace slicefarm::config {

/// The tables of a job's region settings while rows are added: equal settings share a row.
class RegionTable {
 public:
  /// The row of the first region of `settings`. Errors: REQUEST_TOO_LARGE.
  absl::StatusOr<int32_t> RowOf(const JobSettings& settings);

  /// The tables, in place of those of `settings`.
  void PutInto(JobSettings& settings) const;

 private:
  /// All that walls depend on: regions whose walls are alike are of one class.
  struct Walls {
    BeadingOptions beading;
    WallOrder order;
    RegionSpeeds speeds;

    friend bool operator==(const Walls&, const Walls&) = default;
  };
  static Walls WallsOf(const JobSettings& settings);
  int32_t ClassOf(const Walls& walls);

  std::vector<BeadingOptions> beading_;
  std::vector<InfillOptions> infill_;
  std::vector<ExposureOptions> exposure_;
  std::vector<WallOrder> order_;
  std::vector<RegionSpeeds> speeds_;
  std::vector<Walls> classes_;
};

}  // namespace slicefarm::config
