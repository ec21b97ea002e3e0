#include "common/base/cancel_scope.h"

#include <gtest/gtest.h>

#include <thread>

namespace slicefarm::cancel_scope_test {
namespace {

CancelToken Always(bool cancelled) {
  return CancelToken([cancelled] { return cancelled; });
}

TEST(CancelScope, TheInnermostOfTheThreadCounts) {
  EXPECT_FALSE(CancelScope::Current().Cancelled());
  const CancelScope outer(Always(true));
  EXPECT_TRUE(CancelScope::Current().Cancelled());
  {
    const CancelScope inner(Always(false));
    EXPECT_FALSE(CancelScope::Current().Cancelled());
  }
  EXPECT_TRUE(CancelScope::Current().Cancelled());
  std::thread([] { EXPECT_FALSE(CancelScope::Current().Cancelled()); }).join();
}

}  // namespace
}  // namespace slicefarm::cancel_scope_test
