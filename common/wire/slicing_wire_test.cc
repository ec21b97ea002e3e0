#include "common/wire/slicing_wire.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "common/base/error.h"

namespace slicefarm {
namespace {

// Found by fuzz_slicing: the sum of both has no room in 64 bits.
TEST(SliceInputReader, MoreBytesThanCanBeCountedAreRefused) {
  v1::SliceStart start;
  start.add_objects()->set_size_bytes(124);
  start.add_objects()->set_size_bytes(INT64_MAX);
  const absl::Status status = SliceInputReader::Begin(start).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kMeshTooLarge) << status;
  EXPECT_EQ(DetailOf(status).metadata.at("got"), std::to_string(INT64_MAX));
}

}  // namespace
}  // namespace slicefarm
