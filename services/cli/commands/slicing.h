#pragma once

#include <string>
#include <vector>

#include "common/model/calibration_table.h"
#include "services/cli/console/exit_code.h"
#include "services/cli/console/interrupt.h"
#include "services/cli/job/job_options.h"
#include "services/cli/models/given_models.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

inline constexpr int kMaxThreads = 256;

/// Options of commands that slice on this machine.
struct SliceOptions {
  JobOptions job;
  std::string output;
  int threads = 0;                    ///< 0: one per processor
  CalibrationTable calibration = {};  ///< values that the print compares, for the report
};

/// Adds the option --threads.
void AddThreadsOption(CLI::App& app, int& threads);

/// Makes the plates that can be made, and prints their summaries. Returns the first error's code.
/// `settings`: settings of the job, which follow the settings of the plates.
ExitCode SlicePlates(const SliceOptions& options, GivenModels models,
                     const std::vector<Setting>& settings, Interrupt& interrupt);

}  // namespace slicefarm::cli
