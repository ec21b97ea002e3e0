#include "common/model/fields/field_notes.h"

#include <fmt/core.h>

namespace slicefarm {

double MostEvenPitchMm(FillPattern pattern) {
  switch (pattern) {
    case FillPattern::kGyroid:
      return 3;
    case FillPattern::kFischerKochS:
      return 2.7;
    case FillPattern::kHoneycombCells:
    case FillPattern::kHoneycomb3d:
    case FillPattern::kArchimedean:
    case FillPattern::kPeano:
      return 2;
    case FillPattern::kHilbert:
      return 1.7;
    case FillPattern::kSchwarzD:
    case FillPattern::kHoneycomb:
    case FillPattern::kOctagram:
    case FillPattern::kConcentric:
    case FillPattern::kFermat:
      return 1;
    default:
      return 0;
  }
}

std::vector<std::string> FieldNotes(const DensityField& field, FillPattern pattern,
                                    double spacing_mm) {
  std::vector<std::string> notes;
  if (field.dither != Dither::kNone) {
    notes.push_back(
        fmt::format("density_field: with dither, cells of {:g} mm have the requested density only "
                    "on average; for a density within 5 % in each 5 mm, omit dither",
                    field.cell_mm));
    return notes;
  }
  const double most = MostEvenPitchMm(pattern);
  if (most > 0 && field.Least() * most < spacing_mm)
    notes.push_back(fmt::format(
        "density_field: below {:.0f} %, lines of fill_pattern = {} are more than {:g} mm apart, so "
        "that the density of 5 mm cells deviates by more than 5 % on average",
        100 * spacing_mm / most, InfoOf(pattern).name, most));
  return notes;
}

}  // namespace slicefarm
