#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/plate.h"
#include "common/model/calibration_table.h"
#include "common/model/setting_source.h"
#include "common/wire/scene_wire.h"

namespace slicefarm::coordinator {

/// Output of a job: a program, or only an estimate.
enum class JobMode { kPrint, kQuote };

/// Request of a client: objects, and settings as text.
struct JobRequest {
  JobMode mode = JobMode::kPrint;
  Process process = kDefaultProcess;
  SubmittedScene scene;
  std::vector<config::Setting> settings;
  /// Settings that have no effect according to the client; the report lists them.
  std::vector<std::string> without_effect = {};
  /// Warnings of the project that contains the objects.
  std::vector<std::string> warnings = {};
  std::vector<config::MissingFeature> missing = {};  ///< missing features that the project requests
  std::vector<std::string> allowed = {};             ///< features that may be missing
  /// True if the job is for no particular printer.
  bool generic = false;
  /// Sources of the settings of a job with presets, for the report.
  std::vector<SettingSource> sources = {};
  CalibrationTable calibration = {};  ///< values that the print compares, for the report
};

/// Request with resolved settings and its digests.
struct ResolvedJob {
  JobRequest request;
  config::ResolvedPlate plate;
  std::string settings_digest;  ///< digest of the effective settings
  /// Digest of all data that determines the result, including build and tenant. Jobs with equal
  /// digests have equal results.
  std::string action_digest;
  /// Action digests under which a result for this job may be stored, ending with its own. For
  /// example, the result of a print also serves a quote.
  std::vector<std::string> serving_actions;
};

/// Checks the limits of objects, names and copies. Errors: REQUEST_MALFORMED, REQUEST_TOO_LARGE.
absl::Status CheckRequest(const JobRequest& request);
/// Checks the number, the length and the characters of labels. Errors: REQUEST_MALFORMED,
/// REQUEST_TOO_LARGE.
absl::Status CheckLabels(const std::map<std::string, std::string>& labels);
/// Checks the length and the characters of a request id. Errors: REQUEST_MALFORMED,
/// REQUEST_TOO_LARGE.
absl::Status CheckRequestId(const std::string& request_id);

/// Checks that the request may become a job. Existing jobs are not checked again. Errors:
/// REQUEST_MALFORMED for a feature name in `allowed` that does not exist; PRINTER_MISSING if the
/// settings name no machine and the job is not generic; NOT_SUPPORTED for a missing feature that is
/// not allowed.
absl::Status CheckAcceptable(const ResolvedJob& job);

/// Checks the request (CheckRequest) and resolves its plate. `result_tenant`: tenant under which
/// the results are searched and stored (job_results.h). Errors: see CheckRequest and
/// config::ResolvePlate.
absl::StatusOr<ResolvedJob> ResolveJob(JobRequest request, std::string_view build_id,
                                       std::string_view result_tenant,
                                       const CancelToken& cancel = {});

}  // namespace slicefarm::coordinator
