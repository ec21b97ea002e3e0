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

/// Coordinator to connect to.
struct ServerOptions {
  std::string server = "127.0.0.1:50050";
  rpc::ClientSecurity security;
  double patience_s = 30;
};

/// Adds the options to a command.
void AddServerOptions(CLI::App& app, ServerOptions& options);

/// Returns the client's options. `interrupt` ends the calls, and then waits for the end of the
/// program; null: Ctrl-C does not end the calls.
JobsClientOptions ClientOptions(const ServerOptions& options, Interrupt* interrupt);

/// Reads the texts of `--label key=value`, which may be repeated. Errors: REQUEST_MALFORMED.
absl::StatusOr<std::map<std::string, std::string>> ReadLabels(
    const std::vector<std::string>& texts);

/// Files for the results of a job; empty: not wanted.
struct ResultFiles {
  std::string gcode;
  std::string report;
  std::string trace = {};
};

/// Fetches the wanted results of a job. Files appear when all results are complete and equal to the
/// job's result. Returns the file with the G-code.
absl::StatusOr<std::string> FetchResults(JobsClient& client, const v1::Job& job,
                                         const ResultFiles& files);

/// Returns one line for each thing that jobs wait for: "2 jobs wait for a worker: ...".
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

/// Returns the exit code of a job that ended. Bad settings and bad meshes have their own codes, and
/// other failures have kJobFailed.
ExitCode JobExitCode(const absl::Status& outcome);

/// Prints the reason why a job ended without result, and returns JobExitCode. `model`: the model
/// with the bad mesh, if it is known.
ExitCode FailJob(const v1::Job& job, const std::string& model = "");

}  // namespace slicefarm::cli
