#pragma once

#include <string>
#include <vector>

#include "services/texture/algo/output/engrave_program.h"
#include "services/texture/algo/output/engrave_report.h"

namespace slicefarm::cli {

/// What a report of an engraving tells.
struct EngraveJobReport {
  texture::MapReport map;
  std::vector<texture::LayerNumbers> layers;
  texture::ProgramFacts program;  ///< no moves: no program was made
  std::vector<std::string> warnings;
  double map_seconds = 0;
  double path_seconds = 0;
};

/// As JSON: distortion and spacing with p1, p50 and p99, each layer's height and lengths.
std::string EngraveReportJson(const EngraveJobReport& report);

}  // namespace slicefarm::cli
