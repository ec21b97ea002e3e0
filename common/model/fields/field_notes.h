#pragma once

#include <string>
#include <vector>

#include "common/model/fields/density_field.h"
#include "common/model/options/fill_patterns.h"

namespace slicefarm {

/// Returns notes for the job's report if the infill's density in cells of 5 mm differs from the
/// field by more than 5 % on average. There are two causes: dithered cells are either filled or
/// empty, or the lines for the field's low densities are too far apart. `spacing_mm`: spacing of
/// adjacent lines at density 1.
std::vector<std::string> FieldNotes(const DensityField& field, FillPattern pattern,
                                    double spacing_mm);

/// Returns the largest line distance, in mm, at which a pattern's density in cells of 5 mm is
/// within 5 % of the requested density on average. The values were measured with uniform densities,
/// by the plastic in 196 cells of a box 16 mm high. Returns 0 if the pattern was not measured, or
/// if it adapts its line distances to the field.
double MostEvenPitchMm(FillPattern pattern);

}  // namespace slicefarm
