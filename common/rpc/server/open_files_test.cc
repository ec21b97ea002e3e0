#include "common/rpc/server/open_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace slicefarm::rpc::open_files_test {
namespace {

TEST(OpenFiles, TheLimitIsRaisedToWhatIsAllowed) {
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit low = {.rlim_cur = 128, .rlim_max = before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &low), 0);
  RaiseOpenFilesLimit();
  rlimit after = {};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &after), 0);
  EXPECT_EQ(after.rlim_cur, before.rlim_max);
  setrlimit(RLIMIT_NOFILE, &before);
}

}  // namespace
}  // namespace slicefarm::rpc::open_files_test
