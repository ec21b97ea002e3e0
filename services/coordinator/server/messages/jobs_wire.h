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

constexpr int32_t kDefaultPageSize = 50;  ///< of lists, for requests that say none

/// jobs.proto <-> what the coordinator keeps. Errors: REQUEST_MALFORMED naming the field; those of
/// common/wire/support/mesh_wire.h.

absl::StatusOr<JobRequest> FromProto(const v1::JobSpec& spec);

/// Takes out all settings and what has no effect: lists of jobs would be too long with them.
void ClearSettings(v1::JobSpec& spec);

absl::StatusOr<Priority> FromProto(v1::JobPriority priority);
/// Microseconds since 1970. Errors: also for times before that.
absl::StatusOr<int64_t> FromProto(const google::protobuf::Timestamp& time);

/// What JobRecord.spec holds, and back. Equal specs give equal bytes.
std::string SpecBytes(const v1::JobSpec& spec);
absl::StatusOr<JobRequest> ReadSpec(const std::string& bytes);

v1::JobState ToProto(JobState state);
v1::JobError ToProto(const JobError& error);
v1::Cost ToProto(const Cost& cost);
v1::Preflight ToProto(const Preflight& preflight, const Cost& cost);

/// A page of a list: jobs without their settings, as many as fit into a message. The token holds
/// the last job of the page before; it is opaque to clients.
absl::StatusOr<ListQuery> FromProto(const v1::ListJobsRequest& request);
v1::ListJobsResponse ToProto(const std::vector<JobRecord>& jobs, const ListQuery& query);

/// Errors: also for a mask that names nothing, or what cannot be changed.
absl::StatusOr<JobChanging> FromProto(const v1::UpdateJobRequest& request);

v1::Job ToProto(const JobRecord& job);
/// The job as of then, without its spec.
v1::JobEvent ToProto(const JobEventRecord& event, const JobRecord& job);

/// When what is watched begins. Errors: also for a cursor that is none.
absl::StatusOr<int64_t> WatchedFrom(const v1::WatchJobsRequest& request, int64_t now_us);

v1::Webhook ToProto(const WebhookRecord& webhook);

v1::Upload ToProto(const std::string& digest, const BlobStatus& status);

}  // namespace slicefarm::coordinator
