#include "services/infill/algo/lines/shortened.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::shortened_test {
namespace {

struct Case {
  const char* name;
  double start_mm, end_mm;
  const char* expected;
};

TEST(Shortened, EndsAreCutOff) {
  const Polyline line = MakeLineOrDie("(0 0, 4 0, 4 3, 9 3)");
  const Case cases[] = {
      {"Nothing", 0, 0, "(0 0, 4 0, 4 3, 9 3)"},
      {"WithinTheEndEdges", 1, 2, "(1 0, 4 0, 4 3, 7 3)"},
      {"WholeEdges", 4, 5, "(4 0, 4 3)"},
      {"ToTheMiddle", 5, 6, "(4 1, 4 2)"},
      {"Within one edge", 0.5, 9, "(0.5 0, 3 0)"},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(Shortened(line, 12e6, c.start_mm * 1e6, c.end_mm * 1e6), MakeLineOrDie(c.expected))
        << c.name;
  }
}

TEST(Shortened, WhatIsTooShortBecomesAPoint) {
  const Polyline line = MakeLineOrDie("(0 0, 4 0)");
  EXPECT_EQ(Shortened(line, 4e6, 6e6, 2e6), (Polyline{{3'000'000, 0}}));
  EXPECT_EQ(Shortened(line, 4e6, 4e6, 0), (Polyline{{4'000'000, 0}}));
}

TEST(Shortened, LengthsAddUp) {
  Polyline line;
  for (int i = 0; i < 40; ++i) line.push_back({i * 300'000, (i * i % 7) * 200'000});
  const double length = Length(line);
  for (double start = 0; start < length / 2; start += 377'000)
    EXPECT_NEAR(Length(Shortened(line, length, start, length / 3)), length * 2 / 3 - start, 10);
}

}  // namespace
}  // namespace slicefarm::infill::shortened_test
