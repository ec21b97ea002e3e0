#include "common/base/error.h"

#include <gtest/gtest.h>

#include <set>

namespace slicefarm::error_test {
namespace {

TEST(Error, CarriesReasonAndMetadata) {
  const absl::Status status =
      MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange, "layer_height",
                {{"setting", "layer_height"}, {"got", "9 mm\nand more"}, {"empty", ""}});
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  const ErrorDetail detail = DetailOf(status);
  EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(detail.metadata.at("setting"), "layer_height");
  EXPECT_EQ(detail.metadata.at("got"), "9 mm\nand more");
  EXPECT_EQ(detail.metadata.at("empty"), "");
}

TEST(Error, HostileMetadataCannotForgeEntries) {
  const absl::Status status = MakeError(absl::StatusCode::kInternal, Reason::kInternal, "x",
                                        {{"got", std::string("a\0reason\0b", 10)}});
  EXPECT_EQ(DetailOf(status).metadata.size(), 1u);
}

TEST(Error, LimitIsQuoted) {
  const absl::Status status = LimitError(Reason::kMeshTooLarge, "triangles", 10, 11);
  EXPECT_EQ(status.message(), "triangles: 11, at most 10 are accepted");
  EXPECT_EQ(DetailOf(status).metadata.at("limit"), "10");
}

TEST(Error, ForeignErrorsGetAReasonThatSuits) {
  EXPECT_EQ(DetailOf(absl::CancelledError("")).reason, Reason::kCancelled);
  EXPECT_EQ(DetailOf(absl::UnauthenticatedError("")).reason, Reason::kUnauthenticated);
  EXPECT_EQ(DetailOf(absl::PermissionDeniedError("")).reason, Reason::kPermissionDenied);
  EXPECT_EQ(DetailOf(absl::UnknownError("")).reason, Reason::kInternal);
}

TEST(Reason, NamesAreUniqueAndReadBack) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Reason::kInternal); ++i) {
    const auto reason = static_cast<Reason>(i);
    EXPECT_EQ(ReasonFromName(ReasonName(reason)), reason) << i;
    EXPECT_TRUE(names.insert(ReasonName(reason)).second) << ReasonName(reason);
  }
  EXPECT_EQ(ReasonFromName("NO_SUCH"), std::nullopt);
}

TEST(MakeError, NulDoesNotShiftTheMetadata) {
  const std::string nul(1, '\0');
  const absl::Status status = MakeError(absl::StatusCode::kInternal, Reason::kInternal, "bad",
                                        {{"a" + nul + "b", "x" + nul + "y"}, {"limit", "4"}});
  const std::map<std::string, std::string> want = {{"a b", "x y"}, {"limit", "4"}};
  EXPECT_EQ(DetailOf(status).metadata, want);
}

}  // namespace
}  // namespace slicefarm::error_test
