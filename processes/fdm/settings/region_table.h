#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/process_settings.h"
#include "common/model/options/settings.h"

namespace slicefarm::config::fdm {

/// The tables of beading, infill, ordering and motion.
class RegionTable : public RegionRows {
 public:
  absl::StatusOr<int32_t> RowOf(const JobSettings& settings) override;
  int64_t size() const override { return std::ssize(beading_); }
  void PutInto(JobSettings& settings) const override;

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
  std::vector<WallOrder> order_;
  std::vector<RegionSpeeds> speeds_;
  std::vector<Walls> classes_;
};

}  // namespace slicefarm::config::fdm
