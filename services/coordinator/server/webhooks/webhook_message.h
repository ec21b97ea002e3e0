#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// What a receiver is told: `{"type": "job.ended", "job": {...}}`, the job as GetJob has it,
/// without settings: not the job's, nor those of projects, objects, parts and height ranges.
std::string WebhookBody(const JobRecord& job);

/// `t=SECONDS,v1=HEX`, with one `v1` for each secret: HMAC-SHA256 (RFC 2104) of `SECONDS.BODY`. A
/// receiver computes it again with the secret that it knows, takes the message if one `v1` is
/// equal, and refuses times that are not of the last minutes.
std::string WebhookSignature(const std::vector<std::string>& secrets, int64_t time_s,
                             const std::string& body);

}  // namespace slicefarm::coordinator
