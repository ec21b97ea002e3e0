#pragma once

#include <string>
#include <vector>

#include "common/model/fields/density_field.h"
#include "common/model/options/fill_patterns.h"

namespace slicefarm {

/// What a job's report says of a field that infill cannot follow to 5 % on average in cells of
/// 5 mm: because cells are filled or empty, or because a pattern's lines are too far apart where
/// the field asks for little. `spacing_mm`: of lines that lie side by side.
std::vector<std::string> FieldNotes(const DensityField& field, FillPattern pattern,
                                    double spacing_mm);

/// How far apart lines of a pattern may be, mm, to be as dense as asked for in cells of 5 mm, to 5
/// % on average. Measured with densities that are the same everywhere, by the plastic in 196 cells
/// of a box of 16 mm height. 0: nothing is known of it, or its lines are graded.
double MostEvenPitchMm(FillPattern pattern);

}  // namespace slicefarm
