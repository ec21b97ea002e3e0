#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// Returns the message to a receiver: `{"type": "job.ended", "job": {...}}`. The job is as in
/// GetJob but without settings, including the settings of its projects, objects, parts and height
/// ranges.
std::string WebhookBody(const JobRecord& job);

/// Returns `t=SECONDS,v1=HEX`, with one `v1` per secret. HEX is the HMAC-SHA256 (RFC 2104) of
/// `SECONDS.BODY`. A receiver computes the HMAC with its own secret and accepts the message if one
/// `v1` is equal. The receiver should also refuse messages that are some minutes old.
std::string WebhookSignature(const std::vector<std::string>& secrets, int64_t time_s,
                             const std::string& body);

}  // namespace slicefarm::coordinator
