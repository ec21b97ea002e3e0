#pragma once

#include <string>

#include "processes/mill/model/milled_program.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Part `milling` of the report of a milling job: its phases, the stock and the check for gouges.
struct MillJobReport : ProcessReport {
  MillReport report;
  MillLayout layout;
  std::string cutter;

  void AddTo(nlohmann::ordered_json& json) const override;
};

}  // namespace slicefarm::coordinator
