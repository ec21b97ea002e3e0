#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/rpc/client/client_security.h"
#include "services/cli/console/console.h"
#include "services/cli/console/interrupt.h"
#include "services/cli/farm/jobs_client.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// Address and security settings of the coordinator.
struct ServerOptions {
  std::string server = "127.0.0.1:50050";
  rpc::ClientSecurity security;
  double patience_s = 30;
};

/// Adds the options to a command.
void AddServerOptions(CLI::App& app, ServerOptions& options);

/// Returns the options of a JobsClient. `interrupt`: at Ctrl-C its token ends the calls, and the
/// program may take longer than 0.3 seconds to end (Interrupt::WaitForEnd). Null: Ctrl-C does not
/// end the calls.
JobsClientOptions ClientOptions(const ServerOptions& options, Interrupt* interrupt);

/// Reads the texts of `--label key=value`, which may be repeated. Errors: REQUEST_MALFORMED.
absl::StatusOr<std::map<std::string, std::string>> ReadLabels(
    const std::vector<std::string>& texts);

/// Output files for the results of a job. An empty name means that this result is not wanted.
struct ResultFiles {
  std::string gcode;
  std::string report;
  std::string trace = {};
};

/// Fetches the wanted results of a job. The files appear only when all results are complete and
/// their digests are correct. Returns the file with the G-code.
absl::StatusOr<std::string> FetchResults(JobsClient& client, const v1::Job& job,
                                         const ResultFiles& files);

/// Returns lines such as "2 jobs wait for a worker: ...", one for each value of Job.waits_for.
template <typename Jobs>
std::vector<std::string> WaitsOf(const Jobs& jobs) {
  std::map<std::string, int> counts;
  for (const v1::Job& job : jobs)
    if (!job.waits_for().empty()) ++counts[job.waits_for()];
  std::vector<std::string> lines;
  for (const auto& [what, count] : counts)
    lines.push_back(std::to_string(count) + (count == 1 ? " job waits for " : " jobs wait for ") +
                    what);
  return lines;
}

/// Shows the progress of a job.
void ShowProgress(ProgressBar& bar, const v1::Job& job);

/// Returns "queued", "running", ...
std::string StateName(v1::JobState state);

/// Returns the exit code for the outcome of a job that has ended. Bad settings and bad meshes have
/// their own codes; other failures have kJobFailed.
ExitCode JobExitCode(const absl::Status& outcome);

/// Prints the reason why a job ended without result, and returns JobExitCode. `model`: the model
/// with the bad mesh, if it is known.
ExitCode FailJob(const v1::Job& job, const std::string& model = "");

}  // namespace slicefarm::cli
