#include "common/model/fields/field_notes.h"

#include <gtest/gtest.h>

namespace slicefarm::field_notes_test {
namespace {

constexpr double kSpacingMm = 0.4;

DensityField FromTo(double low, double high) { return {.at_mm = {0, 10}, .values = {low, high}}; }

TEST(FieldNotes, AreNoneForWhatIsExact) {
  EXPECT_TRUE(FieldNotes(FromTo(0.2, 0.5), FillPattern::kGyroid, kSpacingMm).empty());
  EXPECT_TRUE(FieldNotes(FromTo(0.02, 0.5), FillPattern::kGrid, kSpacingMm).empty());
}

TEST(FieldNotes, NameTheDensityBelowWhichLinesAreTooFarApart) {
  const auto notes = FieldNotes(FromTo(0.1, 0.5), FillPattern::kGyroid, kSpacingMm);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("below 13 %, lines of fill_pattern = gyroid are more than 3 mm"),
            std::string::npos)
      << notes[0];
  EXPECT_EQ(FieldNotes(FromTo(0.2, 0.5), FillPattern::kSchwarzD, kSpacingMm).size(), 1u);
}

TEST(FieldNotes, SayThatDitheringIsRightOnAverageOnly) {
  DensityField field = FromTo(0.2, 0.5);
  field.dither = Dither::kFloydSteinberg;
  field.cell_mm = 3;
  for (const FillPattern pattern : {FillPattern::kGyroid, FillPattern::kGrid}) {
    const auto notes = FieldNotes(field, pattern, kSpacingMm);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("cells of 3 mm"), std::string::npos) << notes[0];
  }
}

}  // namespace
}  // namespace slicefarm::field_notes_test
