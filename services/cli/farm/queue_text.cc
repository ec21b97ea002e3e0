#include "services/cli/farm/queue_text.h"

#include <fmt/core.h>
#include <google/protobuf/util/time_util.h>

#include "common/base/duration_text.h"

namespace slicefarm::cli {

std::string EndText(const v1::Job& job, std::chrono::system_clock::time_point now) {
  using google::protobuf::util::TimeUtil;
  if (!job.has_estimated_end_time()) return "";
  const int64_t end_us = TimeUtil::TimestampToMicroseconds(job.estimated_end_time());
  const auto now_us = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
  const double left_s = static_cast<double>(end_us - now_us.count()) / 1e6;
  return left_s < 1 ? "soon" : fmt::format("in about {}", DurationText(left_s));
}

std::string QueueText(const v1::Job& job, std::chrono::system_clock::time_point now) {
  if (job.queue_position() == 0) return "";
  const std::string end = EndText(job, now);
  return fmt::format("place {} in the queue{}", job.queue_position(),
                     end.empty() ? "" : ", done " + end);
}

}  // namespace slicefarm::cli
