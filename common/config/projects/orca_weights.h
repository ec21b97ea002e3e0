#pragma once

#include <string_view>

namespace slicefarm::config {

/// Importance of a setting of OrcaSlicer or Bambu Studio that has no effect in slicefarm.
enum class OrcaWeight {
  kPrint,    ///< change of the part, its material or its temperatures: needs a warning
  kDetail,   ///< any other change: needs a line in the report
  kNothing,  ///< no change: the value requests nothing
};

/// Returns the importance of a setting. `value`: the text of the file, including the brackets of a
/// list.
OrcaWeight WeightOf(std::string_view key, std::string_view value);

/// Returns the reason why a setting has no effect, for reports.
std::string_view WhyIdle(std::string_view key);

}  // namespace slicefarm::config
