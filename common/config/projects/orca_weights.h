#pragma once

#include <string_view>

namespace slicefarm::config {

/// How much a setting of OrcaSlicer's or Bambu Studio's matters that has no effect here.
enum class OrcaWeight {
  kPrint,    ///< the part, its material or its temperatures come out otherwise: worth a warning
  kDetail,   ///< what is left: worth a line in the report
  kNothing,  ///< with this value it asks for nothing
};

/// `value`: as the file has it, lists with brackets.
OrcaWeight WeightOf(std::string_view key, std::string_view value);

}  // namespace slicefarm::config
