#include "common/config/presets/target_printer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/config/presets/preset_files_test.h"
#include "common/config/projects/project.h"

namespace slicefarm::config::presets::target_printer_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const PresetSet& Acme() {
  static const auto* const set = new PresetSet(*ReadPresets(OrcaFolder()));
  return *set;
}

const PresetSet& Bundle() {
  static const auto* const set = new PresetSet(*ReadPresets(Files({{"b.ini", R"([vendor]
name = B
[print:0.20mm NORMAL]
layer_height = 0.2
perimeters = 2
[print:0.30mm DRAFT]
layer_height = 0.3
[filament:PLA]
filament_type = PLA
temperature = 207
[filament:ABS]
filament_type = ABS
temperature = 255
[printer:B]
nozzle_diameter = 0.4
bed_shape = 0x0,180x0,180x180,0x180
max_layer_height = 0.25
machine_max_acceleration_x = 1234
start_gcode = B
default_print_profile = 0.20mm NORMAL
default_filament_profile = PLA
)"}})));
  return *set;
}

/// Project of OrcaSlicer for a bed of 100 mm, with an object at (50, 50).
Project OrcaProject() {
  Project project;
  project.dialect = SettingsDialect::kOrca;
  project.settings = {
      {"print_settings_id", "0.20mm Standard @Other"},
      {"filament_settings_id", R"(["Acme PLA @Other"])"},
      {"filament_type", R"(["PLA"])"},
      {"different_settings_to_system",
       R"(["wall_loops;exclude_object","nozzle_temperature","machine_start_gcode"])"},
      {"nozzle_diameter", R"(["0.4"])"},
      {"printable_area", R"(["0x0","100x0","100x100","0x100"])"},
      {"layer_height", "0.2"},
      {"wall_loops", "7"},
      {"sparse_infill_density", "99%"},
      {"exclude_object", "1"},
      {"nozzle_temperature", R"(["280"])"},
      {"machine_start_gcode", "OTHER"},
      {"machine_max_acceleration_x", R"(["77"])"}};
  project.objects.resize(1);
  project.objects[0].name = "a";
  project.objects[0].settings = {{"sparse_infill_density", "33%"}, {"layer_height", "0.9"}};
  project.objects[0].parts.resize(1);
  project.objects[0].instances.resize(1);
  project.objects[0].instances[0].to_plate(0, 3) = 50;
  project.objects[0].instances[0].to_plate(1, 3) = 50;
  return project;
}

/// Values of a job under PrusaSlicer's names.
class Values {
 public:
  Values(const Project& project, const PresetSet& set, const PresetNames& names)
      : made_(ForPrinter(project, 0, set, names)) {
    EXPECT_TRUE(made_.ok()) << made_.status();
    if (made_.ok()) job_ = JobOfProject(made_->project, 0);
    EXPECT_TRUE(job_.ok()) << job_.status();
  }
  std::string operator[](std::string_view key) const { return In(job_->settings, key); }
  std::string OfObject(std::string_view key) const { return In(job_->objects[0].settings, key); }
  const std::vector<std::string>& notes() const { return made_->notes; }
  const Instance& instance() const { return job_->objects[0].instances[0]; }
  const TargetedProject& made() const { return *made_; }

 private:
  static std::string In(const std::vector<Setting>& settings, std::string_view key) {
    std::string value = "(none)";
    for (const Setting& setting : settings)
      if (setting.key == key) value = setting.value;
    return value;
  }

  absl::StatusOr<TargetedProject> made_;
  absl::StatusOr<ProjectJob> job_ = ProjectJob();
};

TEST(ForPrinter, KeepsTheDesignersChangesAndTakesTheRestFromThePresets) {
  const Values job(OrcaProject(), Acme(), {"Acme One 0.4", "", ""});
  EXPECT_EQ(job["perimeters"], "7");
  EXPECT_NE(job["fill_density"], "99%") << "not changed by the designer";
  EXPECT_EQ(job["temperature"], "225,230");
  EXPECT_EQ(job["bed_shape"], "0x0,220x0,220x220,0x220");
  EXPECT_EQ(job["bed_temperature"], "55") << "of the printer's plate";
  EXPECT_NE(job["start_gcode"], "OTHER");
  EXPECT_NE(job["machine_max_acceleration_x"], "77");
  EXPECT_EQ(job["printer_settings_id"], "Acme One 0.4");
  EXPECT_EQ(job.OfObject("fill_density"), "33%");
  EXPECT_EQ(job.OfObject("layer_height"), "(none)");
  EXPECT_THAT(job.notes(), Contains(HasSubstr("belongs to the printer): exclude_object, "
                                              "machine_start_gcode")));
  EXPECT_THAT(job.notes(), Contains(HasSubstr("filament): nozzle_temperature")));
  EXPECT_THAT(job.notes(), Contains(HasSubstr("layers of 0.9 mm are higher than")));
}

TEST(ForPrinter, ConvertsAProjectOfAnotherProgram) {
  const Values job(OrcaProject(), Bundle(), {"B", "", ""});
  EXPECT_EQ(job["perimeters"], "7");
  EXPECT_EQ(job["temperature"], "207");
  EXPECT_EQ(job["machine_max_acceleration_x"], "1234");
  EXPECT_EQ(job["start_gcode"], "B");
  EXPECT_EQ(job.OfObject("fill_density"), "33%");
}

TEST(ForPrinter, ConvertsAProjectOfPrusaSlicer) {
  Project project;
  project.settings = {{"print_settings_id", "Mine"}, {"perimeters", "6"},
                      {"perimeter_speed", "11"},     {"bed_shape", "0x0,9x0,9x9,0x9"},
                      {"temperature", "199"},        {"layer_height", "0.2"}};
  project.objects.resize(1);
  project.objects[0].instances.resize(1);
  const Values job(project, Acme(), {"Acme One 0.4", "", ""});
  EXPECT_EQ(job["perimeters"], "6");
  const std::vector<Setting>& settings = job.made().project.settings;
  EXPECT_EQ(std::ranges::count(settings, "perimeters", &Setting::key), 1)
      << "a report would name the preset's value as overridden";
  EXPECT_NE(job["perimeter_speed"], "11");
  EXPECT_EQ(job["temperature"], "225,230");
  EXPECT_THAT(job.notes(), Contains(HasSubstr("does not list the settings")));
}

TEST(ForPrinter, ChoosesTheProcessAndTheFilamentThatCorrespond) {
  Project project = OrcaProject();
  project.settings.push_back({"layer_height", "0.3"});
  project.settings.push_back({"filament_type", R"(["ABS"])"});
  const Values job(project, Bundle(), {"B", "", ""});
  EXPECT_EQ(job.made().presets.process->name, "0.30mm DRAFT");
  EXPECT_EQ(job.made().presets.filament->name, "ABS");
  project.settings.push_back({"layer_height", "0.28"});
  const Values other(project, Bundle(), {"B", "", ""});
  EXPECT_EQ(other.made().presets.process->name, "0.20mm NORMAL") << "the default";
  EXPECT_THAT(other.notes(), Contains(HasSubstr("layer height of 0.28 mm")));
  const Values named(project, Bundle(), {"B", "0.30mm DRAFT", "PLA"});
  EXPECT_EQ(named.made().presets.process->name, "0.30mm DRAFT");
  EXPECT_EQ(named.made().presets.filament->name, "PLA");
}

TEST(ForPrinter, LeavesOutALayerHeightThatTheNozzleCannotPrint) {
  Project project = OrcaProject();
  project.settings.push_back({"layer_height", "0.28"});
  project.settings.push_back({"different_settings_to_system", R"(["layer_height","",""])"});
  const Values job(project, Bundle(), {"B", "", ""});
  EXPECT_EQ(job["layer_height"], "0.2");
  EXPECT_THAT(
      job.notes(),
      Contains(HasSubstr(
          "layers of 0.28 mm are higher than the printer's largest layer height of 0.25 mm")));
}

struct BedCase {
  std::string name;
  std::string area;  ///< bed of the project
  double x;          ///< position of the object on the new bed of 220 mm
  bool placed = true;
};

class BedTest : public testing::TestWithParam<BedCase> {};

TEST_P(BedTest, DecidesWhereTheObjectsAre) {
  Project project = OrcaProject();
  project.settings.push_back({"printable_area", GetParam().area});
  const Values job(project, Acme(), {"Acme One 0.4", "", ""});
  EXPECT_EQ(job.instance().placed, GetParam().placed);
  EXPECT_EQ(job.instance().to_plate(0, 3), GetParam().x);
  const bool noted = std::ranges::any_of(job.notes(), [](const std::string& line) {
    return line.ends_with("the objects are arranged again");
  });
  EXPECT_NE(noted, GetParam().placed);
}

INSTANTIATE_TEST_SUITE_P(
    Beds, BedTest,
    testing::Values(BedCase{"Equal", R"(["0x0","220x0","220x220","0x220"])", 50},
                    BedCase{"Smaller", R"(["0x0","100x0","100x100","0x100"])", 110},
                    BedCase{"OriginInTheMiddle", R"(["-50x-50","50x-50","50x50","-50x50"])", 160},
                    BedCase{"Wider", R"(["0x0","300x0","300x100","0x100"])", 50, false},
                    BedCase{"Round", R"(["50x0","100x50","50x100","0x50"])", 50, false}),
    [](const auto& info) { return info.param.name; });

TEST(ForPrinter, RefusesAPrinterThatDoesNotExist) {
  EXPECT_EQ(DetailOf(ForPrinter(OrcaProject(), 0, Bundle(), {"C", "", ""}).status()).reason,
            Reason::kProfileNotFound);
  EXPECT_EQ(DetailOf(ForPrinter(OrcaProject(), 3, Bundle(), {"B", "", ""}).status()).reason,
            Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::config::presets::target_printer_test
