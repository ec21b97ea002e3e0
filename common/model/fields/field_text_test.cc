#include "common/model/fields/field_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/limits.h"

namespace slicefarm::field_text_test {
namespace {

TEST(FieldText, CanonicalTextsComeBackAsTheyAre) {
  for (
      const char* text : {
          R"({"kind":"height","table":[[0,0.2]]})",
          R"({"kind":"height","table":[[-1,0.2],[5.5,1]],"law":"simp","steepness":2})",
          R"({"kind":"surface_distance","near":0.6,"far":0.15,"length":8})",
          R"({"kind":"voxels","count":[2,1,1],"origin":[0,1,2],"spacing":[1,2,3],"values":[0,1]})",
          R"({"kind":"height","table":[[0,1]],"law":"heaviside","threshold":0.3,"dither":"floyd_steinberg","cell":1.5})",
      }) {
    const auto field = ParseDensityField(text);
    ASSERT_TRUE(field.ok()) << field.status() << text;
    EXPECT_EQ(PrintDensityField(*field), text);
  }
  const char* stress =
      R"({"kind":"voxels","count":[1,2,1],"origin":[0,0,0],"spacing":[1,1,1],"stress":[1,0,0.5,-2e+06,3,0],"smoothing":4})";
  const auto field = ParseStressField(stress);
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(field->yy.values, (std::vector<double>{0, 3}));
  EXPECT_EQ(PrintStressField(*field), stress);
  const char* materials =
      R"({"parts":[{"kind":"height","table":[[0,0.4],[9,1]]},{"kind":"height","table":[[0,0.6],[9,0]]}],"step":0.1})";
  const auto mix = ParseMaterialField(materials);
  ASSERT_TRUE(mix.ok()) << mix.status();
  EXPECT_EQ(PrintMaterialField(*mix), materials);
}

TEST(FieldText, AConstantIsATableOfOneHeight) {
  const auto field = ParseDensityField(R"({"kind": "constant", "density": 0.25})");
  ASSERT_TRUE(field.ok());
  EXPECT_EQ(field->UniformAt(3), 0.25);
  const auto stress = ParseStressField(R"({"kind": "constant", "stress": [1, 2, 3]})");
  ASSERT_TRUE(stress.ok());
  EXPECT_EQ(stress->xy.At({4, 5, 6}), 3);
}

TEST(FieldText, SaysWhichRuleADensityFieldBreaks) {
  const struct {
    const char* text;
    const char* says;
  } cases[] = {
      {"nonsense", "is not JSON"},
      {"[1]", "must be a JSON object"},
      {"{}", "'kind' is missing"},
      {R"({"kind":"cubes"})", "must be one of constant"},
      {R"({"kind":"constant"})", "'density' is missing"},
      {R"({"kind":"constant","density":1.2})", "it must be 0 to 1"},
      {R"({"kind":"constant","density":1e999})", "is not JSON"},
      {R"({"kind":"constant","density":"a"})", "not finite"},
      {R"({"kind":"constant","density":0.2,"laww":"simp"})", "unknown entry 'laww'"},
      {R"({"kind":"constant","density":0.2,"law":"cubic"})", "must be one of linear"},
      {R"({"kind":"constant","density":0.2,"dither":"x"})", "must be one of none"},
      {R"({"kind":"constant","density":0.2,"cell":0.1})", "it must be 0.5 to 100"},
      {R"({"kind":"height","table":[]})", "has no rows"},
      {R"({"kind":"height","table":[[0,0.1],[0,0.2]]})", "must increase"},
      {R"({"kind":"height","table":[[0,0.1,3]]})", "must have 2"},
      {R"({"kind":"height","table":[[0,-0.1]]})", "it must be 0 to 1"},
      {R"({"kind":"surface_distance","near":0.1,"far":0.2})", "'length' is missing"},
      {R"({"kind":"voxels","count":[2,2],"origin":[0,0,0],"spacing":[1,1,1],"values":[0]})",
       "must have 3"},
      {R"({"kind":"voxels","count":[2,2,1],"origin":[0,0,0],"spacing":[1,1,1],"values":[0]})",
       "values has 1 numbers: it must have 4"},
      {R"({"kind":"voxels","count":[2,0.5,1],"origin":[0,0,0],"spacing":[1,1,1],"values":[0]})",
       "it must be 1 to"},
      {R"({"kind":"voxels","count":[1,1,1],"origin":[0,0,0],"spacing":[1,0,1],"values":[0]})",
       "spacing has 0"},
      {R"({"kind":"voxels","count":[999,999,9],"origin":[0,0,0],"spacing":[1,1,1],"values":[0]})",
       "are allowed"},
      {R"({"kind":"voxels","count":[1,1,1],"origin":[0,0,0],"spacing":[1,1,1],"values":[null]})",
       "not finite"},
  };
  for (const auto& c : cases) {
    const auto field = ParseDensityField(c.text);
    ASSERT_FALSE(field.ok()) << c.text;
    EXPECT_NE(field.status().message().find(c.says), std::string::npos)
        << c.text << ": " << field.status().message();
  }
}

TEST(FieldText, StressesAreThreeForEachNode) {
  for (
      const char* text : {
          R"({"kind":"constant","stress":[1,2]})",
          R"({"kind":"constant","stress":[1,2,3],"smoothing":1.5})",
          R"({"kind":"constant","stress":[1,2,3],"smoothing":101})",
          R"({"kind":"voxels","count":[2,1,1],"origin":[0,0,0],"spacing":[1,1,1],"stress":[1,2,3]})",
      })
    EXPECT_FALSE(ParseStressField(text).ok()) << text;
}

TEST(FieldText, StressesSayADirectionSomewhere) {
  const auto voxels = [](const char* stress) {
    return ParseStressField(fmt::format(
        R"({{"kind":"voxels","count":[2,1,1],"origin":[0,0,0],"spacing":[1,1,1],"stress":{}}})",
        stress));
  };
  EXPECT_TRUE(voxels("[1,1,0, 1,1,0.5]").ok());
  EXPECT_TRUE(voxels("[1,1,0, 2,1,0]").ok());
  EXPECT_THAT(std::string(voxels("[1,1,0, 2,2,0]").status().message()),
              testing::HasSubstr("the same in all directions everywhere"));
  EXPECT_FALSE(ParseStressField(R"({"kind":"constant","stress":[0,0,0]})").ok());
}

TEST(FieldText, SharesOfMaterialsSumToOne) {
  const auto parts = [](const char* a, const char* b) {
    return ParseMaterialField(fmt::format(R"({{"parts":[{},{}]}})", a, b)).status();
  };
  const char* quarter = R"({"kind":"constant","density":0.25})";
  EXPECT_TRUE(parts(quarter, R"({"kind":"constant","density":0.75})").ok());
  EXPECT_FALSE(parts(quarter, R"({"kind":"constant","density":0.74})").ok());
  EXPECT_FALSE(parts(quarter, R"({"kind":"height","table":[[1,0.75]]})").ok());
  EXPECT_FALSE(parts(quarter, R"({"kind":"constant","density":0.75,"law":"simp"})").ok());
  EXPECT_FALSE(ParseMaterialField(R"({"parts":[{"kind":"constant","density":1}]})").ok());
  EXPECT_FALSE(ParseMaterialField(R"({"step":0.1})").ok());
  const char* near = R"({"kind":"surface_distance","near":0.5,"far":0.5,"length":3})";
  EXPECT_FALSE(parts(near, near).ok());
}

}  // namespace
}  // namespace slicefarm::field_text_test
