#include "services/texture/algo/output/csv_text.h"

#include <gtest/gtest.h>

namespace slicefarm::texture::csv_text_test {
namespace {

TEST(CsvRows, NumbersPathsByTheirLinks) {
  LayerPath path{.layer = 3};
  const auto add = [&](double x, bool on) { path.points.push_back({{x, 0.1, -2}, {0, 0, 1}, on}); };
  for (const auto& [x, on] :
       {std::pair(0.0, false), {1.0, true}, {2.5, true}, {3.0, false}, {4.0, false}, {5.0, true}})
    add(x, on);
  EXPECT_EQ(CsvRows(path),
            "0,3,0,0.1,-2,0,0,1,0\n"
            "0,3,1,0.1,-2,0,0,1,1\n"
            "0,3,2.5,0.1,-2,0,0,1,1\n"
            "1,3,3,0.1,-2,0,0,1,0\n"
            "1,3,4,0.1,-2,0,0,1,0\n"
            "1,3,5,0.1,-2,0,0,1,1\n");
}

}  // namespace
}  // namespace slicefarm::texture::csv_text_test
