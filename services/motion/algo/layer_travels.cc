#include "services/motion/algo/layer_travels.h"

#include "common/base/text.h"
#include "common/gcode/gcode_text.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/pass_change.h"
#include "services/motion/algo/program/gcode_machine.h"
#include "services/motion/algo/toolpath/lifts.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/toolpath/toolpath.h"
#include "services/motion/algo/toolpath/travel_ramp.h"

namespace slicefarm::motion {

LayerTravels::LayerTravels(const MotionOptions& options)
    : options_(options), travels_(options.travel_area) {}

std::vector<Point> LayerTravels::Corners(Point from, Point to) const {
  const Point offset = options_.tool().offset;
  std::vector<Point> corners = travels_.Between(from + offset, to + offset);
  for (Point& corner : corners) corner = corner - offset;
  return corners;
}

std::string LayerTravels::MovesTo(const std::vector<Point>& corners) const {
  GcodeText out;
  for (const Point corner : corners) {
    out << "G1 X";
    out.Micrometers(ToUm(corner.x)) << " Y";
    out.Micrometers(ToUm(corner.y)) << " F";
    out.Integer(FeedRate(TravelSpeed(options_))) << '\n';
  }
  return out.Take();
}

std::string LayerTravels::To(const LayerSummary& layer, Point from) const {
  const std::vector<Point> corners = Corners(from, layer.entry);
  if (corners.empty()) return {};
  const bool lifts = LiftsToStart(options_.tool().retraction, layer.frame);
  const Coord lift_nm = lifts ? FromMm(LiftOf(options_.tool().retraction)) : 0;
  return MoveToHeight(layer.frame.print_z_nm + lift_nm, options_) + MovesTo(corners);
}

Point LayerTravels::After(std::string_view gcode, Point from) const {
  if (options_.travel_area.empty()) return from;
  GcodeMachine machine(FirmwareOf(options_.flavor), SetupOf(options_));
  const auto mm = [](Coord nm) { return ToMm(static_cast<double>(nm)); };
  machine.Resume({mm(from.x), mm(from.y), 0}, TravelSpeed(options_), 0);
  for (const std::string_view line : Split(gcode, "\n")) machine.Read(ParseGcodeLine(line));
  return {FromMm(machine.position()[kX]), FromMm(machine.position()[kY])};
}

}  // namespace slicefarm::motion
