#include "services/motion/algo/toolpath/jerks.h"

#include <algorithm>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion {
namespace {

/// Limits a jerk to the jerk of both axes. A limit of 0 has no effect.
double Limited(double jerk_mm_s, const MachineLimits& limits) {
  for (const double limit : {limits.max_jerk_mm_s[0], limits.max_jerk_mm_s[1]})
    if (limit > 0) jerk_mm_s = std::min(jerk_mm_s, limit);
  return jerk_mm_s;
}

double FirstAboveZero(std::initializer_list<double> values) {
  const auto* const found = std::ranges::find_if(values, [](double value) { return value > 0; });
  return found == values.end() ? 0 : *found;
}

}  // namespace

Jerks JerksFor(const MotionOptions& options, Ground ground) {
  const JerkOptions& jerk = options.jerk;
  Jerks result;
  if (jerk.default_mm_s <= 0) return result;
  result.written = true;
  const bool first = ground == Ground::kBed;
  const double of_layer = first ? jerk.first_layer_mm_s : 0;
  for (size_t i = 0; i < result.print.size(); ++i)
    result.print[i] = Limited(FirstAboveZero({of_layer, jerk.feature_mm_s[i], jerk.default_mm_s}),
                              options.limits);
  const double travel =
      first ? FirstAboveZero({jerk.first_layer_travel_mm_s, of_layer, jerk.travel_mm_s})
            : jerk.travel_mm_s;
  result.travel = Limited(travel, options.limits);
  result.z = options.limits.max_jerk_mm_s[2];
  result.e = options.limits.max_jerk_mm_s[3];
  return result;
}

}  // namespace slicefarm::motion
