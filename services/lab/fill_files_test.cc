#include "services/lab/fill_files.h"

#include <gtest/gtest.h>

namespace slicefarm::lab::fill_files_test {
namespace {

TEST(FillFiles, APathIsALine) {
  Path open, closed;
  open.points = {{0, 0}, {1'500'000, -2}};
  closed.points = {{0, 0}, {1'000'000, 0}, {0, 1'000'000}};
  closed.closed = true;
  EXPECT_EQ(PrintFill({open, closed}),
            "2 0.000000 0.000000 1.500000 -0.000002\n"
            "4 0.000000 0.000000 1.000000 0.000000 0.000000 1.000000 0.000000 0.000000\n");
  EXPECT_EQ(PrintFill({}), "");
}

}  // namespace
}  // namespace slicefarm::lab::fill_files_test
