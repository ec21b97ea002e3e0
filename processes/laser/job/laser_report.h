#pragma once

#include <vector>

#include "processes/laser/model/exposed_layer.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Part `exposure` of the report of a laser job. It contains `recoating_s`, and the time of each
/// layer as `layers_s`.
struct LaserReport : ProcessReport {
  ExposureReport exposure;
  double recoating_s = 0;       ///< part of print_time_s that is spent on recoating
  std::vector<double> layer_s;  ///< time of each layer, including recoating

  void AddTo(nlohmann::ordered_json& json) const override;
};

}  // namespace slicefarm::coordinator
