#include "services/motion/algo/firmware/jerk.h"

#include "common/kinematics/jerk_planner.h"
#include "services/motion/algo/firmware/marlin.h"

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
