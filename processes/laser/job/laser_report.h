#pragma once

#include <vector>

#include "processes/laser/model/exposed_layer.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// What a report tells of lasers: `exposure`, with `recoating_s` and the times by layer as
/// `layers_s`.
struct LaserReport : OwnReport {
  ExposureReport exposure;
  double recoating_s = 0;       ///< of print_time_s
  std::vector<double> layer_s;  ///< recoating included

  void AddTo(nlohmann::ordered_json& json) const override;
};

}  // namespace slicefarm::coordinator
