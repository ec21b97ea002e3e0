#pragma once

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/calibration_table.h"
#include "services/cli/console/exit_code.h"
#include "services/cli/console/interrupt.h"
#include "services/cli/farm/jobs_client.h"
#include "services/cli/farm/server_options.h"
#include "services/cli/job/job_options.h"
#include "services/cli/models/given_models.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// Options of commands that slice on a farm.
struct SubmitOptions {
  JobOptions job;
  ServerOptions server;
  std::string output;
  std::vector<std::string> labels;
  std::vector<std::string> profiles;
  std::string priority = "normal";
  double deadline_s = 0;  ///< 0: no deadline
  std::string webhook;
  bool quote = false;
  bool check = false;
  bool orient = false;
  std::string traceparent;
  bool detach = false;
  bool json = false;
  CalibrationTable calibration = {};  ///< values that the print compares, for the report
  std::vector<std::string> reported;  ///< warnings that were printed before the job was made
};

/// Checks that a job that is not waited for has no output files. Errors: REQUEST_MALFORMED.
absl::Status CheckDetach(const SubmitOptions& options);

/// Returns the options of the farm's client.
JobsClientOptions OptionsOfClient(const SubmitOptions& options, Interrupt& interrupt);

/// Returns the settings of a job as the farm resolves them: with its presets, profiles and
/// overlays. Sends a cube instead of the plate's objects, and creates no job. Errors: the farm's.
absl::StatusOr<std::vector<Setting>> SettingsOnFarm(const SubmitOptions& options,
                                                    const GivenPlate& plate,
                                                    const std::vector<Setting>& settings,
                                                    JobsClient& client);

/// Creates a job for each plate, or for `--check` only checks it. Waits for the jobs and fetches
/// their results, except with `--detach`. Prints ids, summaries and errors. `settings`: settings of
/// the jobs, which follow the settings of the plates.
ExitCode SubmitModels(SubmitOptions options, const GivenModels& models,
                      const std::vector<Setting>& settings, JobsClient& client,
                      Interrupt& interrupt);

/// Adds the options that name presets and profiles of the farm.
void AddFarmSettingOptions(CLI::App& app, SubmitOptions& options);

}  // namespace slicefarm::cli
