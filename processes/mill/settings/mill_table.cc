#include "processes/mill/settings/mill_table.h"

#include <algorithm>
#include <iterator>

#include "common/config/table/bind.h"
#include "processes/mill/model/milling_options.h"

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
       .doc =
           "Shape and measures in mm and degrees; D is the diameter, TIP that at which the upper "
           "cone begins, ANGLE half of that at a cone's tip",
       .field = Bind<&MillSettings::how, &MillingOptions::cutter>()},
      Number("stepdown", {"mm", 0.001, 1000}, "1", "Most between two levels of roughing",
             Bind<&MillSettings::how, &MillingOptions::stepdown_mm>()),
      {.key = "stepover",
       .kind = Kind::kPercent,
       .unit = "% of the cutter's diameter",
       .min = 1,
       .max = 50,
       .standard = "40%",
       .doc = "Between two ways of a level of roughing",
       .field = Bind<Scale::kPercent, &MillSettings::how, &MillingOptions::stepover_share>()},
      Number("allowance", {"mm", 0, 100}, "0.2", "What roughing leaves around the part",
             Bind<&MillSettings::how, &MillingOptions::allowance_mm>()),
      Number("minimum_width", {"mm", 0, 1000}, "0.05",
             "Ways for the tip that are narrower are left to finishing",
             Bind<&MillSettings::how, &MillingOptions::minimum_width_mm>()),
      Flag("finishing", "1", "Ways that touch the part after roughing",
           Bind<&MillSettings::how, &MillingOptions::finishing>()),
      Number("finish_stepdown", {"mm", 0.001, 1000}, "0.25", "Most between two waterlines",
             Bind<&MillSettings::how, &MillingOptions::finish_stepdown_mm>()),
      Number("finish_stepover", {"mm", 0.001, 500}, "0.25",
             "Between the parallel ways of rest areas, where the part is flat",
             Bind<&MillSettings::how, &MillingOptions::finish_stepover_mm>()),
      Number("rest_angle", {"degrees", 0, 80}, "45",
             "Flatter than this the part is finished by parallel ways in place of waterlines",
             Bind<&MillSettings::how, &MillingOptions::rest_angle_deg>()),
      Flag("finish_floor", "0", "Parallel ways on the stock's floor beside the part, too",
           Bind<&MillSettings::how, &MillingOptions::finish_floor>()),
      Number("sampling", {"mm", 0.001, 100}, "0.1",
             "Distance of the fibers by which waterlines are found; what is narrower is not seen",
             Bind<&MillSettings::how, &MillingOptions::sampling_mm>()),
      Number("tolerance", {"mm", 0.002, 1}, "0.01",
             "Between ways and those that touch the part exactly",
             Bind<&MillSettings::how, &MillingOptions::tolerance_mm>()),
      {.key = "stock",
       .kind = Kind::kText,
       .standard = "",
       .doc = "Name of the object that is the stock; it lies with its middle where the parts' is, "
              "unless it has a place. Empty: a box around the parts",
       .field = Bind<&MillSettings::stock>()},
      Number("stock_margin", {"mm", 0, 1000}, "1", "Of the box of stock, at its sides and top",
             Bind<&MillSettings::how, &MillingOptions::stock_margin_mm>()),
      Number("bottom", {"mm", 0, 10'000}, "0", "How high above the stock's bottom the tip stays",
             Bind<&MillSettings::how, &MillingOptions::bottom_mm>()),
      Flag("open_mesh", "0", "Meshes may be surfaces that enclose nothing",
           Bind<&MillSettings::how, &MillingOptions::open_mesh>()),
  };
}

std::vector<SettingSpec> MachineSettings() {
  return {
      {.key = "direction",
       .kind = Kind::kChoice,
       .standard = "climb",
       .doc = "Which way the cutter goes round: climb has the stock on the right of the way",
       .choices = {Named("climb", CutDirection::kClimb),
                   Named("conventional", CutDirection::kConventional)},
       .field = Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::direction>()},
      {.key = "entry",
       .kind = Kind::kChoice,
       .standard = "helix",
       .doc =
           "How the cutter goes down into stock; a helix needs room beside the way, else it is a "
           "ramp along the way",
       .choices = {Named("helix", EntryKind::kHelix), Named("ramp", EntryKind::kRamp),
                   Named("plunge", EntryKind::kPlunge)},
       .field = Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::entry>()},
      Number("ramp_angle", {"degrees", 0.1, 60}, "3", "Of ramps and helices",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::ramp_angle_deg>()),
      Number("helix_radius", {"mm", 0, 250}, "0", "Of the tip's way; 0: half the cutter's radius",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::helix_radius_mm>()),
      Number("lead_in_radius", {"mm", 0, 100}, "1",
             "Of quarter circles onto and off finishing ways; 0: none",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::lead_in_radius_mm>()),
      Flag("arcs", "1", "Arcs and helices as G2 and G3; 0: as lines",
           Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::arcs>()),
      Number("safe_height", {"mm", 0.1, 1000}, "5",
             "Above the stock, where rapid moves are always free",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::safe_height_mm>()),
      Number("clearance", {"mm", 0.05, 1000}, "0.5",
             "Between a rapid move and the stock that is left",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::clearance_mm>()),
      Number("feed", {"mm/min", 0.1, 1e6}, "800", "Speed of cutting",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::feed_mm_min>()),
      Number("plunge_feed", {"mm/min", 0.1, 1e6}, "300",
             "Speed downwards, of ramps and helices too",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::plunge_feed_mm_min>()),
      Number("rapid", {"mm/min", 0.1, 1e6}, "3000",
             "Speed of the machine's rapid moves: for times only",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::rapid_mm_min>()),
      Count("spindle", {"rpm", 1, 1e6}, "12000", "Turns of the spindle",
            Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::spindle_rpm>()),
      {.key = "coolant",
       .kind = Kind::kChoice,
       .standard = "off",
       .doc = "M7 for mist, M8 for flood",
       .choices = {Named("off", Coolant::kOff), Named("mist", Coolant::kMist),
                   Named("flood", Coolant::kFlood)},
       .field = Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::coolant>()},
      Count("tool_number", {"", 0, 99'999}, "1", "Of the cutter in the machine's table of tools",
            Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::tool_number>()),
      Number("tool_length", {"mm", 0, 1000}, "0",
             "Of the cutter below its holder; deeper it must not go. 0: not known",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::tool_length_mm>()),
      Number("machine_max_acceleration_x", {"mm/s2", 1, 1e6}, "500", "Of the machine's x axis",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::max_acceleration_mm_s2, 0>()),
      Number("machine_max_acceleration_y", {"mm/s2", 1, 1e6}, "500", "Of the machine's y axis",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::max_acceleration_mm_s2, 1>()),
      Number("machine_max_acceleration_z", {"mm/s2", 1, 1e6}, "300", "Of the machine's z axis",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::max_acceleration_mm_s2, 2>()),
      Number("jerk_limit", {"mm/s3", 1, 1e8}, "20000", "Change of the machine's acceleration",
             Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::jerk_mm_s3>()),
      Flag("corner_feeds", "0",
           "Feeds are lowered where acceleration and jerk let the machine go no faster: in curves "
           "and on short moves",
           Bind<&MillSettings::how, &MillingOptions::machining, &MachiningOptions::corner_feeds>()),
  };
}

std::vector<SettingSpec> OutputSettings() {
  return {
      {.key = "origin",
       .kind = Kind::kChoice,
       .standard = "model",
       .doc = "Where X0 Y0 Z0 of the program are: where the first object's file has them (model), "
              "at the bed's, or at the corner of the stock's top with the least x and y",
       .choices = {Named("model", MillOrigin::kModel), Named("bed", MillOrigin::kBed),
                   Named("stock_top", MillOrigin::kStockTop)},
       .field = Bind<&MillSettings::origin>()},
      {.key = "dialect",
       .kind = Kind::kChoice,
       .standard = "linuxcnc",
       .doc = "Which controller reads the program",
       .choices = {Named("linuxcnc", MillDialect::kLinuxCnc), Named("grbl", MillDialect::kGrbl)},
       .field = Bind<&MillSettings::dialect>()},
      {.key = "output_format",
       .kind = Kind::kChoice,
       .standard = "gcode",
       .doc = "A program, or a picture of one step (svg)",
       .choices = {Named("gcode", MillFormat::kGcode), Named("svg", MillFormat::kSvg)},
       .field = Bind<&MillSettings::format>()},
      Count("output_step", {"", 0, 1e6}, "0",
            "The step of a picture, from 0: levels of roughing and of finishing from the top down, "
            "then rows of rest areas",
            Bind<&MillSettings::output_step>()),
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
