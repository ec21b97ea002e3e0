#include "services/cli/farm/queue_text.h"

#include <google/protobuf/util/time_util.h>
#include <gtest/gtest.h>

namespace slicefarm::cli::queue_text_test {
namespace {

constexpr std::chrono::system_clock::time_point kNow{std::chrono::seconds(1'000)};

struct QueueTextCase {
  std::string name;
  int position;
  double end_s;  // seconds from now; 0: not known
  std::string queue, end;
};

class QueueTextTest : public testing::TestWithParam<QueueTextCase> {};

TEST_P(QueueTextTest, SaysWhatIsKnown) {
  v1::Job job;
  job.set_queue_position(GetParam().position);
  if (GetParam().end_s != 0) {
    *job.mutable_estimated_end_time() = google::protobuf::util::TimeUtil::MillisecondsToTimestamp(
        1'000'000 + static_cast<int64_t>(GetParam().end_s * 1000));
  }
  EXPECT_EQ(QueueText(job, kNow), GetParam().queue);
  EXPECT_EQ(EndText(job, kNow), GetParam().end);
}

INSTANTIATE_TEST_SUITE_P(
    Jobs, QueueTextTest,
    testing::Values(QueueTextCase{"Nothing", 0, 0, "", ""},
                    QueueTextCase{"PlaceAlone", 3, 0, "place 3 in the queue", ""},
                    QueueTextCase{"Both", 12, 130, "place 12 in the queue, done in about 2m 10s",
                                  "in about 2m 10s"},
                    QueueTextCase{"Runs", 0, 8, "", "in about 8s"},
                    QueueTextCase{"IsDue", 0, 0.4, "", "soon"},
                    QueueTextCase{"IsLate", 1, -60, "place 1 in the queue, done soon", "soon"}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::cli::queue_text_test
