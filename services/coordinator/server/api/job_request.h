#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/plate.h"
#include "common/wire/scene_wire.h"

namespace slicefarm::coordinator {

enum class JobMode { kPrint, kQuote };

/// What a client asks for: objects, and settings as text.
struct JobRequest {
  JobMode mode = JobMode::kPrint;
  Process process = kDefaultProcess;
  SubmittedScene scene;
  std::vector<config::Setting> settings;
  std::vector<std::string> without_effect = {};  ///< as the client knows: the report names it
};

/// A request that can be worked on.
struct ResolvedJob {
  JobRequest request;
  config::ResolvedPlate plate;
  std::string settings_digest;  ///< of the effective settings
  std::string action_digest;    ///< of all that the result depends on, build and tenant included
  /// Actions whose results serve as this one's, its own last: a print is a quote, too.
  std::vector<std::string> serving_actions;
};

/// Objects, names and copies within their bounds. Errors: REQUEST_MALFORMED, REQUEST_TOO_LARGE.
absl::Status CheckRequest(const JobRequest& request);
absl::Status CheckLabels(const std::map<std::string, std::string>& labels);
absl::Status CheckRequestId(const std::string& request_id);

/// CheckRequest, and the plate resolved. `result_tenant`: whose results the job may take and
/// leave (job_results.h). Errors also: those of config::ResolvePlate.
absl::StatusOr<ResolvedJob> ResolveJob(JobRequest request, std::string_view build_id,
                                       std::string_view result_tenant,
                                       const CancelToken& cancel = {});

}  // namespace slicefarm::coordinator
