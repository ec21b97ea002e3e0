#include "services/motion/algo/firmware/jerk.h"

#include "services/motion/algo/firmware/marlin.h"
#include "services/motion/algo/kinematics/jerk_planner.h"

namespace slicefarm::motion {
namespace {

class JerkFirmware : public MarlinFirmware {
 public:
  std::string_view name() const override { return "jerk"; }
  std::unique_ptr<Planner> MakePlanner(const MachineLimits& limits) const override {
    return std::make_unique<JerkPlanner>(limits);
  }
};

}  // namespace

const Firmware& JerkLimited() {
  static const JerkFirmware firmware;
  return firmware;
}

}  // namespace slicefarm::motion
