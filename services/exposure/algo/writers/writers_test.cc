#include "services/exposure/algo/writers/writers.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/exposure/algo/writers/number_text.h"
#include "services/exposure/algo/writers/sample_layers_test.h"

namespace slicefarm::exposure::writers_test {
namespace {

TEST(NumberText, Rounds) {
  const auto mm = [](Coord nm, int decimals) {
    std::string text;
    AppendMm(text, nm, decimals);
    return text;
  };
  EXPECT_EQ(mm(1'500'000, 6), "1.5");
  EXPECT_EQ(mm(-1'500'001, 6), "-1.500001");
  EXPECT_EQ(mm(0, 4), "0");
  EXPECT_EQ(mm(49, 4), "0");
  EXPECT_EQ(mm(-49, 4), "0");
  EXPECT_EQ(mm(50, 4), "0.0001");
  EXPECT_EQ(mm(-50, 4), "-0.0001");
  EXPECT_EQ(mm(999'999'950, 4), "1000");
  EXPECT_EQ(mm(10'000'000, 0), "10");
  EXPECT_EQ(mm(10'060'000, 2), "10.06");
}

}  // namespace
}  // namespace slicefarm::exposure::writers_test
