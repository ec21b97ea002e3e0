#include "services/motion/algo/program/heat_waits.h"

#include <algorithm>

namespace slicefarm::motion {

bool HeatWaits::Waits(const GcodeLine& line) {
  return line.Is('M', 109) || line.Is('M', 116) || line.Is('M', 190) || line.Is('M', 191);
}

void HeatWaits::Heater::Set(double celsius, double now_s) {
  from_c = std::min(to_c, from_c + rate_c_s * (now_s - since_s));
  if (celsius < from_c) from_c = celsius;
  to_c = celsius;
  since_s = now_s;
}

double HeatWaits::Heater::WaitS(double now_s) const {
  return std::max(0.0, since_s + (to_c - from_c) / rate_c_s - now_s);
}

std::optional<double> HeatWaits::Read(const GcodeLine& line, double now_s) {
  const bool of_nozzle = line.Is('M', 104) || line.Is('M', 109);
  const bool of_bed = line.Is('M', 140) || line.Is('M', 190);
  Heater& heater = of_bed ? bed_ : nozzle_;
  const auto target = line['S'] ? line['S'] : line['R'];
  if ((of_nozzle || of_bed) && target) heater.Set(*target, now_s);
  if (!Waits(line)) return 0;
  if (!(of_nozzle || of_bed) || heater.rate_c_s <= 0) return std::nullopt;
  return heater.WaitS(now_s);
}

}  // namespace slicefarm::motion
