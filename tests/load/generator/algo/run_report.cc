#include "tests/load/generator/algo/run_report.h"

#include <algorithm>

namespace slicefarm::load {

double RunReport::TotalSeconds() const {
  return std::max(seconds, static_cast<double>(record.end_ns) / 1e9);
}

double RunReport::AchievedRps() const {
  return static_cast<double>(record.succeeded()) / TotalSeconds();
}

}  // namespace slicefarm::load
