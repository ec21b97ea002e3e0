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

/// Which coordinator to speak with.
struct ServerOptions {
  std::string server = "127.0.0.1:50050";
  rpc::ClientSecurity security;
  double patience_s = 30;
};

void AddServerOptions(CLI::App& app, ServerOptions& options);

/// `interrupt` ends the calls, and then waits for the end of the program; null: Ctrl-C does not end the calls.
JobsClientOptions ClientOptions(const ServerOptions& options, Interrupt* interrupt);

/// Of `--label key=value`, which may be repeated. Errors: REQUEST_MALFORMED.
absl::StatusOr<std::map<std::string, std::string>> ReadLabels(
    const std::vector<std::string>& texts);

/// Where the results of a job go; empty: not wanted.
struct ResultFiles {
  std::string gcode;
  std::string report;
  std::string trace = {};
};

/// Fetches what is wanted of a job. Files appear when all are complete, and what the job's result
/// says they are. Returns where the G-code went.
absl::StatusOr<std::string> FetchResults(JobsClient& client, const v1::Job& job,
                                         const ResultFiles& files);

/// What jobs wait for, a line for all that wait for the same: "2 jobs wait for a worker: ...".
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

/// Shows how far a job is.
void ShowProgress(ProgressBar& bar, const v1::Job& job);

/// "queued", "running", ...
std::string StateName(v1::JobState state);

/// The exit code of a job that ended: as its error says for bad settings and bad meshes, kJobFailed
/// for other failures.
ExitCode JobExitCode(const absl::Status& outcome);

/// Prints why a job ended without result, and gives JobExitCode. `model`: whose fault a bad mesh
/// is, if that is known.
ExitCode FailJob(const v1::Job& job, const std::string& model = "");

}  // namespace slicefarm::cli
