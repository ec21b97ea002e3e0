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
  std::vector<std::string> warnings = {};        ///< of the project that the objects are from
  std::vector<config::MissingFeature> missing = {};  ///< that the project asks for
  std::vector<std::string> allowed = {};             ///< features that may be missing
  bool generic = false;                              ///< the job is for no particular printer
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

/// Whether the request may become a job: REQUEST_MALFORMED for a name that may not be allowed;
/// PRINTER_MISSING if the settings name no machine and the job does not say that it needs none;
/// NOT_SUPPORTED for what is missing and not allowed. Jobs that are there are not asked again.
absl::Status CheckAcceptable(const ResolvedJob& job);

/// CheckRequest, and the plate resolved. `result_tenant`: whose results the job may take and
/// leave (job_results.h). Errors also: those of config::ResolvePlate.
absl::StatusOr<ResolvedJob> ResolveJob(JobRequest request, std::string_view build_id,
                                       std::string_view result_tenant,
                                       const CancelToken& cancel = {});

}  // namespace slicefarm::coordinator
