#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf::file_location_test {
namespace {

TEST(WithLocation, AddsPartAndLine) {
  const absl::Status status =
      WithLocation({"a.model", 7}, LimitError(Reason::kMeshTooLarge, "things", 3, 4));
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  const ErrorDetail detail = DetailOf(status);
  EXPECT_EQ(detail.reason, Reason::kMeshTooLarge);
  EXPECT_EQ(detail.metadata,
            (std::map<std::string, std::string>{
                {"got", "4"}, {"limit", "3"}, {"line", "7"}, {"part", "a.model"}}));
  EXPECT_TRUE(std::string(status.message()).ends_with("(a.model, line 7)")) << status;
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::file_location_test
