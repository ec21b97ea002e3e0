#pragma once

#include <cstdint>

#include "absl/status/statusor.h"
#include "services/coordinator/algo/pipeline/preflight.h"
#include "services/coordinator/server/messages/job_request.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/jobs/webhook_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

constexpr int32_t kDefaultPageSize = 50;  ///< page size of lists, if a request gives none

// Conversions between jobs.proto and the coordinator's types. Errors: REQUEST_MALFORMED with the
// name of the field; for meshes, see common/wire/support/mesh_wire.h.

/// Converts the spec of a job.
absl::StatusOr<JobRequest> FromProto(const v1::JobSpec& spec);

/// Removes all settings and the list of settings without effect. With them, lists of jobs would be
/// too long.
void ClearSettings(v1::JobSpec& spec);
/// Removes the settings of the spec and the shares of the result, for the same reason.
void ClearDetails(v1::Job& job);

/// Converts a priority; unspecified means normal.
absl::StatusOr<Priority> FromProto(v1::JobPriority priority);
/// Returns the time in microseconds since 1970. Errors: also for times before 1970.
absl::StatusOr<int64_t> FromProto(const google::protobuf::Timestamp& time);

/// Returns the bytes of JobRecord.spec. Equal specs have equal bytes.
std::string SpecBytes(const v1::JobSpec& spec);
/// Reads the bytes of JobRecord.spec.
absl::StatusOr<JobRequest> ReadSpec(const std::string& bytes);

/// Converts the state of a job.
v1::JobState ToProto(JobState state);
/// Converts the error of a failed job.
v1::JobError ToProto(const JobError& error);
/// Converts the result of a preflight.
v1::Preflight ToProto(const Preflight& preflight, const Cost& cost);

/// Converts a request for a page of a list. The page token contains the last job of the previous
/// page and is opaque to clients.
absl::StatusOr<ListQuery> FromProto(const v1::ListJobsRequest& request);
/// Makes one page of the jobs that a list query found: as many jobs as fit into a message, without
/// their settings.
v1::ListJobsResponse ToProto(const std::vector<JobRecord>& jobs, const ListQuery& query);

/// Converts the changes of a job. Errors: also REQUEST_MALFORMED for a mask without fields or with
/// a field that cannot be changed.
absl::StatusOr<JobChanging> FromProto(const v1::UpdateJobRequest& request);

/// Converts a job with its spec and the shares of its result.
v1::Job ToProto(const JobRecord& job);
/// Converts an event. `job`: record of the event's job, which may be newer. The job in the answer
/// has the state of the event and no spec.
v1::JobEvent ToProto(const JobEventRecord& event, const JobRecord& job);

/// Returns the time from which events are watched. Errors: also for an invalid cursor.
absl::StatusOr<int64_t> WatchedFrom(const v1::WatchJobsRequest& request, int64_t now_us);

/// Converts a webhook with its attempts.
v1::Webhook ToProto(const WebhookRecord& webhook);

/// Converts the state of an upload.
v1::Upload ToProto(const std::string& digest, const BlobStatus& status);

}  // namespace slicefarm::coordinator
