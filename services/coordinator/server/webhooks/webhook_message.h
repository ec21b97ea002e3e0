#pragma once

#include <cstdint>
#include <string>

#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// What a receiver is told: `{"type": "job.ended", "job": {...}}`, the job as GetJob has it,
/// without its settings.
std::string WebhookBody(const JobRecord& job);

/// `t=SECONDS,v1=HEX`: HMAC-SHA256 (RFC 2104) of `SECONDS.BODY`. A receiver computes it again, and
/// refuses times that are not of the last minutes.
std::string WebhookSignature(const std::string& secret, int64_t time_s, const std::string& body);

}  // namespace slicefarm::coordinator
