#include "processes/mill/settings/mill_table.h"

#include <algorithm>
#include <iterator>

#include "common/config/table/bind.h"
#include "processes/mill/model/milling_options.h"
#include "processes/mill/settings/needs.h"

namespace slicefarm::config::mill {
namespace {

template <class Enum>
Choice Named(std::string_view name, Enum value) {
  return {name, static_cast<int>(value)};
}

struct Bounds {
  std::string_view unit;
  double min = 0;
  double max = 0;
};

SettingSpec Number(std::string_view key, Bounds bounds, std::string_view standard,
                   std::string_view doc, Field field) {
  return {.key = key,
          .unit = bounds.unit,
          .min = bounds.min,
          .max = bounds.max,
          .standard = standard,
          .doc = doc,
          .field = field};
}

SettingSpec Count(std::string_view key, Bounds bounds, std::string_view standard,
                  std::string_view doc, Field field) {
  SettingSpec spec = Number(key, bounds, standard, doc, field);
  spec.kind = Kind::kInteger;
  return spec;
}

SettingSpec Flag(std::string_view key, std::string_view standard, std::string_view doc,
                 Field field) {
  return {.key = key, .kind = Kind::kFlag, .standard = standard, .doc = doc, .field = field};
}

std::vector<SettingSpec> StrategySettings() {
  return {
      {.key = "cutter",
       .kind = Kind::kCutter,
       .standard = "ball:4",
       .doc = "Shape of the cutter with its measures in mm and degrees. D: diameter. CORNER: "
              "corner radius. TIP: diameter at the tip. ANGLE: half angle of a cone",
       .field = Bind<&MillSettings::how, &MillingOptions::cutter>()},
      Number("stepdown", {"mm", 0.001, 1000}, "1",
             "Largest height between neighbouring roughing levels; smaller: less load on the "
             "cutter, more levels",
             Bind<&MillSettings::how, &MillingOptions::stepdown_mm>()),
      {.key = "stepover",
       .kind = Kind::kPercent,
       .unit = "% of the cutter's diameter",
       .min = 1,
       .max = 50,
       .standard = "40%",
       .doc = "Distance between neighbouring roughing passes, as a percentage of the cutter's "
              "diameter",
       .field = Bind<Scale::kPercent, &MillSettings::how, &MillingOptions::stepover_share>()},
      Number("allowance", {"mm", 0, 100}, "0.2",
             "Thickness of the material that roughing leaves around the part for the finishing "
             "passes; 0: none",
             Bind<&MillSettings::how, &MillingOptions::allowance_mm>()),
      Number("minimum_width", {"mm", 0, 1000}, "0.05",
             "Width by which a passage must be wider than the cutter so that roughing mills it; "
             "narrower passages are left to finishing",
             Bind<&MillSettings::how, &MillingOptions::minimum_width_mm>()),
      Flag("finishing", "1",
           "Add finishing passes, which touch the part, after roughing; 0: only roughing, so that "
           "`allowance` remains on the part",
           Bind<&MillSettings::how, &MillingOptions::finishing>()),
      Needing({&needs::kFinishing},
              Number("finish_stepdown", {"mm", 0.001, 1000}, "0.25",
                     "Largest height between neighbouring waterline passes of finishing; smaller: "
                     "smoother walls, more passes",
                     Bind<&MillSettings::how, &MillingOptions::finish_stepdown_mm>())),
      Needing({&needs::kFinishing},
              Number("finish_stepover", {"mm", 0.001, 500}, "0.25",
                     "Distance between neighbouring parallel finishing passes in flat areas; "
                     "smaller: smoother surfaces, more passes",
                     Bind<&MillSettings::how, &MillingOptions::finish_stepover_mm>())),
      Needing({&needs::kFinishing},
              Number("rest_angle", {"degrees", 0, 80}, "45",
                     "Slope of the part's surface, measured from horizontal, below which finishing "
                     "uses parallel passes instead of waterline passes",
                     Bind<&MillSettings::how, &MillingOptions::rest_angle_deg>())),
      Needing({&needs::kFinishing},
              Flag("finish_floor", "0",
                   "Finish the floor of the stock beside the part as well, with parallel passes; "
                   "0: only the part",
                   Bind<&MillSettings::how, &MillingOptions::finish_floor>())),
      Number("sampling", {"mm", 0.001, 100}, "0.1",
             "Distance between the points at which waterline passes are computed; smaller: finer "
             "details, but more computing time. Narrower details may be missed",
             Bind<&MillSettings::how, &MillingOptions::sampling_mm>()),
      Number("tolerance", {"mm", 0.002, 1}, "0.01",
             "Largest deviation of a written toolpath from the computed one; larger: fewer moves",
             Bind<&MillSettings::how, &MillingOptions::tolerance_mm>()),
      {.key = "stock",
       .kind = Kind::kText,
       .standard = "",
       .doc = "Name of the object that is the stock; it is centred on the parts unless it has its "
              "own position. Empty: the stock is a box around the parts",
       .field = Bind<&MillSettings::stock>()},
      Needing({&needs::kBoxStock},
              Number("stock_margin", {"mm", 0, 1000}, "1",
                     "Distance by which the box of the stock extends beyond the parts at the sides "
                     "and at the top",
                     Bind<&MillSettings::how, &MillingOptions::stock_margin_mm>())),
      Number("bottom", {"mm", 0, 10'000}, "0",
             "Smallest height of the cutter's tip above the bottom of the stock; 0: the cutter may "
             "reach the bottom",
             Bind<&MillSettings::how, &MillingOptions::bottom_mm>()),
      Flag(
          "open_mesh", "0",
          "Accept meshes that are open surfaces, such as a relief; 0: a mesh must enclose a volume",
          Bind<&MillSettings::how, &MillingOptions::open_mesh>()),
  };
}

std::vector<SettingSpec> MachineSettings() {
  return {
      {.key = "direction",
       .kind = Kind::kChoice,
       .standard = "climb",
       .doc = "Cutting direction. climb: the stock is on the right of the toolpath, as seen along "
              "the feed. conventional: on the left",
       .choices = {Named("climb", CutDirection::kClimb),
                   Named("conventional", CutDirection::kConventional)},
       .field =
           Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::direction>(),
       .needs = {&needs::kProgram}},
      {.key = "entry",
       .kind = Kind::kChoice,
       .standard = "helix",
       .doc = "Entry of the cutter into the stock. helix: a helix where it fits, elsewhere a ramp. "
              "ramp: sloping along the toolpath. plunge: straight down",
       .choices = {Named("helix", EntryKind::kHelix), Named("ramp", EntryKind::kRamp),
                   Named("plunge", EntryKind::kPlunge)},
       .field = Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::entry>(),
       .needs = {&needs::kProgram}},
      Needing({&needs::kSlopedEntry}, Number("ramp_angle", {"degrees", 0.1, 60}, "3",
                                             "Slope of ramps and helices, measured from horizontal",
                                             Bind<&MillSettings::how, &MillingOptions::machining,
                                                  &MachiningOptions::ramp_angle_deg>())),
      Needing({&needs::kHelix}, Number("helix_radius", {"mm", 0, 250}, "0",
                                       "Radius of the helix on which the cutter's tip enters the "
                                       "stock; 0: half the cutter's radius",
                                       Bind<&MillSettings::how, &MillingOptions::machining,
                                            &MachiningOptions::helix_radius_mm>())),
      Needing({&needs::kFinishing},
              Number("lead_in_radius", {"mm", 0, 100}, "1",
                     "Radius of the quarter circles on which the cutter moves onto and off "
                     "finishing passes; 0: no quarter circles",
                     Bind<&MillSettings::how, &MillingOptions::machining,
                          &MachiningOptions::lead_in_radius_mm>())),
      Needing(
          {&needs::kProgram},
          Flag("arcs", "1", "Write arcs and helices as G2 and G3; 0: as short lines",
               Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::arcs>())),
      Number("safe_height", {"mm", 0.1, 1000}, "5",
             "Height above the top of the stock at which rapid moves cannot touch anything",
             Bind<&MillSettings::how, &MillingOptions::machining,
                  &MachiningOptions::safe_height_mm>()),
      Number(
          "clearance", {"mm", 0.05, 1000}, "0.5",
          "Height above the remaining stock at which rapid moves pass over it",
          Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::clearance_mm>()),
      Needing({&needs::kProgram}, Number("feed", {"mm/min", 0.1, 1e6}, "800",
                                         "Feed while cutting, except on downward moves",
                                         Bind<&MillSettings::how, &MillingOptions::machining,
                                              &MachiningOptions::feed_mm_min>())),
      Needing({&needs::kProgram}, Number("plunge_feed", {"mm/min", 0.1, 1e6}, "300",
                                         "Feed of downward moves, including ramps and helices",
                                         Bind<&MillSettings::how, &MillingOptions::machining,
                                              &MachiningOptions::plunge_feed_mm_min>())),
      Needing({&needs::kProgram},
              Number("rapid", {"mm/min", 0.1, 1e6}, "3000",
                     "Speed of the machine's rapid moves (G0), for the estimated time only",
                     Bind<&MillSettings::how, &MillingOptions::machining,
                          &MachiningOptions::rapid_mm_min>())),
      Needing({&needs::kProgram}, Count("spindle", {"rpm", 1, 1e6}, "12000", "Speed of the spindle",
                                        Bind<&MillSettings::how, &MillingOptions::machining,
                                             &MachiningOptions::spindle_rpm>())),
      {.key = "coolant",
       .kind = Kind::kChoice,
       .standard = "off",
       .doc = "Coolant while cutting. off: none. mist: M7. flood: M8",
       .choices = {Named("off", Coolant::kOff), Named("mist", Coolant::kMist),
                   Named("flood", Coolant::kFlood)},
       .field = Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::coolant>(),
       .needs = {&needs::kProgram}},
      Needing({&needs::kProgram}, Count("tool_number", {"", 0, 99'999}, "1",
                                        "Number of the cutter in the machine's tool table",
                                        Bind<&MillSettings::how, &MillingOptions::machining,
                                             &MachiningOptions::tool_number>())),
      Number("tool_length", {"mm", 0, 1000}, "0",
             "Length of the cutter below its holder. A job with toolpaths deeper than this is "
             "refused, because the holder would touch the stock. 0: unknown length, no check",
             Bind<&MillSettings::how, &MillingOptions::machining,
                  &MachiningOptions::tool_length_mm>()),
      Needing({&needs::kProgram}, Number("machine_max_acceleration_x", {"mm/s2", 1, 1e6}, "500",
                                         "Acceleration limit of the x axis",
                                         Bind<&MillSettings::how, &MillingOptions::machining,
                                              &MachiningOptions::max_acceleration_mm_s2, 0>())),
      Needing({&needs::kProgram}, Number("machine_max_acceleration_y", {"mm/s2", 1, 1e6}, "500",
                                         "Acceleration limit of the y axis",
                                         Bind<&MillSettings::how, &MillingOptions::machining,
                                              &MachiningOptions::max_acceleration_mm_s2, 1>())),
      Needing({&needs::kProgram}, Number("machine_max_acceleration_z", {"mm/s2", 1, 1e6}, "300",
                                         "Acceleration limit of the z axis",
                                         Bind<&MillSettings::how, &MillingOptions::machining,
                                              &MachiningOptions::max_acceleration_mm_s2, 2>())),
      Needing({&needs::kProgram}, Number("jerk_limit", {"mm/s3", 1, 1e8}, "20000",
                                         "Largest change of the machine's acceleration per second",
                                         Bind<&MillSettings::how, &MillingOptions::machining,
                                              &MachiningOptions::jerk_mm_s3>())),
      Needing({&needs::kProgram},
              Flag("corner_feeds", "0",
                   "Reduce the feed in curves and on short moves to the speed that the machine "
                   "reaches within its acceleration limits and jerk_limit; 0: `feed` everywhere",
                   Bind<&MillSettings::how, &MillingOptions::machining,
                        &MachiningOptions::corner_feeds>())),
  };
}

std::vector<SettingSpec> OutputSettings() {
  return {
      {.key = "origin",
       .kind = Kind::kChoice,
       .standard = "model",
       .doc = "Zero point of the program's coordinates. model: the origin of the first object's "
              "file. bed: the origin of the bed, at its surface. stock_top: the corner of the "
              "stock's bounding box with the smallest x and y, at its top",
       .choices = {Named("model", MillOrigin::kModel), Named("bed", MillOrigin::kBed),
                   Named("stock_top", MillOrigin::kStockTop)},
       .field = Bind<&MillSettings::origin>()},
      {.key = "dialect",
       .kind = Kind::kChoice,
       .standard = "linuxcnc",
       .doc = "Controller for which the milling program is written",
       .choices = {Named("linuxcnc", MillDialect::kLinuxCnc), Named("grbl", MillDialect::kGrbl)},
       .field = Bind<&MillSettings::dialect>(),
       .needs = {&needs::kProgram}},
      {.key = "output_format",
       .kind = Kind::kChoice,
       .standard = "gcode",
       .doc = "File that is written. gcode: a milling program. svg: a picture of output_step",
       .choices = {Named("gcode", MillFormat::kGcode), Named("svg", MillFormat::kSvg)},
       .field = Bind<&MillSettings::format>()},
      Needing(
          {&needs::kDrawing},
          Count("output_step", {"", 0, 1e6}, "0",
                "Step of the job that the svg picture shows, counted from 0: first the roughing "
                "and finishing levels from the top down, then the rows of parallel passes",
                Bind<&MillSettings::output_step>())),
  };
}

}  // namespace

std::vector<SettingSpec> MillTable() {
  std::vector<SettingSpec> all = StrategySettings();
  for (const auto& section : {MachineSettings, OutputSettings})
    std::ranges::move(section(), std::back_inserter(all));
  return all;
}

}  // namespace slicefarm::config::mill
