#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "services/cli/console/program_fixture_test.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"

namespace slicefarm::cli::presets_program_test {
namespace {

using testing::HasSubstr;

/// Fixture with a vendor's folder of OrcaSlicer and a bundle of PrusaSlicer.
class PresetsProgram : public Program {
 protected:
  PresetsProgram() {
    for (const char* kind : {"machine", "process", "filament"})
      std::filesystem::create_directories(Path(std::string("orca/Acme/") + kind));
    Put("orca/Acme.json", R"({"machine_list": [{"sub_path": "machine/base.json"},
                                               {"sub_path": "machine/one.json"}],
                              "process_list": [{"sub_path": "process/p.json"}],
                              "filament_list": [{"sub_path": "filament/f.json"}]})");
    Put("orca/Acme/machine/base.json",
        R"({"type": "machine", "name": "base", "instantiation": "false", "nozzle_diameter": ["0.4"],
            "gcode_flavor": "klipper", "printable_area": ["0x0", "120x0", "120x120", "0x120"]})");
    Put("orca/Acme/machine/one.json",
        R"({"type": "machine", "name": "Acme One", "instantiation": "true", "inherits": "base",
            "machine_start_gcode": "START BED=[bed_temperature_initial_layer_single]",
            "default_print_profile": "0.20mm @One", "default_filament_profile": ["PLA @One"]})");
    Put("orca/Acme/process/p.json",
        R"({"type": "process", "name": "0.20mm @One", "instantiation": "true", "wall_loops": "4",
            "layer_height": "0.2", "sparse_infill_pattern": "grid",
            "compatible_printers": ["Acme One"]})");
    Put("orca/Acme/filament/f.json",
        R"({"type": "filament", "name": "PLA @One", "instantiation": "true",
            "nozzle_temperature": ["211"], "hot_plate_temp_initial_layer": ["61"],
            "compatible_printers": ["Acme One"]})");
    Put("prusa.ini",
        "[vendor]\nname = Acme\n[printer_model:A]\nname = Acme A\n"
        "[print:*base*]\nlayer_height = 0.25\n[print:Normal @A]\ninherits = *base*\n"
        "compatible_printers_condition = printer_model==\"A\"\n"
        "[filament:PLA]\ntemperature = 207\n"
        "[printer:Acme A]\nprinter_model = A\nnozzle_diameter = 0.4\n"
        "bed_shape = 0x0,90x0,90x90,0x90\ngcode_flavor = marlin2\n"
        "start_gcode = A S[first_layer_bed_temperature]\n"
        "default_print_profile = Normal @A\ndefault_filament_profile = PLA\n");
  }

  Outcome SliceWith(const std::string& source, Arguments more) {
    Arguments arguments = {"slice",           Path("cube.obj"), "-o",
                           Path("out.gcode"), "--presets",      Path(source)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Run(arguments);
  }
};

TEST_F(PresetsProgram, SlicesWithOrcaSlicersPresets) {
  const Outcome outcome = SliceWith("orca", {"--printer", "Acme One", "--process", "0.20mm"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  const std::string gcode = Text("out.gcode");
  EXPECT_THAT(gcode, HasSubstr("START BED=61"));
  EXPECT_THAT(gcode, HasSubstr("; perimeters = 4\n"));
  EXPECT_THAT(gcode, HasSubstr("; temperature = 211\n"));
  EXPECT_THAT(gcode, HasSubstr("; bed_shape = 0x0,120x0,120x120,0x120\n"));
}

TEST_F(PresetsProgram, SlicesWithPrusaSlicersBundle) {
  const Outcome outcome = SliceWith("prusa.ini", {"--printer", "Acme A", "--filament", "PLA"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  const std::string gcode = Text("out.gcode");
  EXPECT_THAT(gcode, HasSubstr("; layer_height = 0.25\n"));
  EXPECT_THAT(gcode, HasSubstr("; temperature = 207\n"));
}

TEST_F(PresetsProgram, SettingsByHandWin) {
  Put("my.ini", "temperature = 190\nperimeters = 3\n");
  const Outcome outcome = SliceWith(
      "orca", {"--printer", "Acme One", "--config", Path("my.ini"), "--set", "perimeters=1"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(Text("out.gcode"), HasSubstr("; perimeters = 1\n"));
  EXPECT_THAT(Text("out.gcode"), HasSubstr("; temperature = 190\n"));
}

/// Returns a project of Bambu Studio with two plates. Its designer changed the walls.
std::string ChangedProject() {
  namespace threemf = slicing::threemf;
  threemf::Files files = threemf::BambuFiles();
  const std::string walls = R"("wall_loops": "3")";
  for (auto& [name, text] : files)
    if (const size_t at = text.find(walls); at != std::string::npos)
      text.replace(at, walls.size(),
                   R"("wall_loops": "6", "print_settings_id": "0.20mm Standard @BBL",
                      "different_settings_to_system": ["wall_loops", "nozzle_temperature", ""])");
  return threemf::Zipped(files);
}

TEST_F(PresetsProgram, SlicesAProjectAsDesignedForAnotherPrinter) {
  Put("project.3mf", ChangedProject());
  const Outcome outcome =
      Run({"slice", Path("project.3mf"), "--plate", "1", "-o", Path("a.gcode"), "--presets",
           Path("orca"), "--printer", "Acme One", "--report", Path("r.json")});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  const std::string gcode = Text("a.gcode");
  EXPECT_THAT(gcode, HasSubstr("START BED=61"));
  for (const char* line :
       {"\n; perimeters = 6\n", "\n; temperature = 211\n",
        "\n; bed_shape = 0x0,120x0,120x120,0x120\n", "\n; fill_pattern = grid\n"})
    EXPECT_THAT(gcode, HasSubstr(line));
  EXPECT_THAT(
      outcome.err,
      HasSubstr("settings of the project that are not used (belongs to the printer's filament): "
                "nozzle_temperature"));
  EXPECT_THAT(outcome.err, HasSubstr("the objects are arranged again"));
  const auto report = nlohmann::json::parse(Text("r.json"), nullptr, false);
  EXPECT_LT(report["meshes"][0]["max_mm"][0], 120);
  std::map<std::string, std::string> sources;
  for (const auto& each : report["setting_sources"])
    for (const auto& key : each["keys"]) sources[key] = each["source"];
  EXPECT_EQ(sources["perimeters"], "project");
  EXPECT_THAT(sources["bed_shape"], testing::StartsWith("printer preset \"base\" ("));
  EXPECT_THAT(sources["temperature"], testing::StartsWith("filament preset \"PLA @One\" ("));
  EXPECT_EQ(sources["seam_position"], "default of the presets' program");
}

TEST_F(PresetsProgram, AsksForPresetsWithAPrinter) {
  const Outcome outcome =
      Run({"slice", Path("cube.obj"), "-o", Path("a.gcode"), "--printer", "Acme One"});
  EXPECT_EQ(outcome.code, ExitCode::kUsage);
  EXPECT_THAT(outcome.err, HasSubstr("--presets DIR|FILE is needed"));
}

TEST_F(PresetsProgram, RefusesAProjectThatIsLargerThanThePrinter) {
  Put("project.3mf", ChangedProject());
  const Outcome outcome =
      Run({"slice", Path("project.3mf"), "--plate", "1", "-o", Path("a.gcode"), "--presets",
           Path("orca"), "--printer", "Acme One", "--arrange", "--scale", "20"});
  EXPECT_NE(outcome.code, ExitCode::kOk);
  EXPECT_THAT(outcome.err, HasSubstr("error: "));
  EXPECT_FALSE(Exists("a.gcode"));
}

TEST_F(PresetsProgram, ShowsValuesWithTheirSources) {
  const Outcome outcome = Run({"presets", "show", "Acme One", "--json", "--presets", Path("orca")});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  const auto shown = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0]["settings"]["gcode_flavor"]["value"], "klipper");
  EXPECT_EQ(shown[0]["settings"]["gcode_flavor"]["preset"], "base");
  const Outcome job =
      Run({"presets", "show", "--json", "--presets", Path("orca"), "--printer", "Acme One"});
  ASSERT_EQ(job.code, ExitCode::kOk) << job.err;
  const auto settings = nlohmann::json::parse(job.out, nullptr, false)["settings"];
  EXPECT_EQ(settings["wall_loops"]["preset"], "0.20mm @One");
  EXPECT_EQ(settings["wall_generator"]["preset"], "default");
}

TEST_F(PresetsProgram, ListsPresetsThatAreMadeForAPrinter) {
  const Outcome outcome =
      Run({"presets", "list", "--presets", Path("prusa.ini"), "--printer", "Acme A"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_EQ(outcome.out,
            "printer   Acme A  (Acme)\nprocess   Normal @A  (Acme)\nfilament  PLA  (Acme)\n");
}

struct ErrorCase {
  std::string name;
  Arguments arguments;
  ExitCode code;
  std::string message;
};

class PresetsError : public PresetsProgram, public testing::WithParamInterface<ErrorCase> {};

TEST_P(PresetsError, NamesTheMistake) {
  const Outcome outcome = SliceWith("orca", GetParam().arguments);
  EXPECT_EQ(outcome.code, GetParam().code);
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().message));
  EXPECT_FALSE(Exists("out.gcode"));
}

INSTANTIATE_TEST_SUITE_P(Presets, PresetsError,
                         testing::Values(ErrorCase{"NoPrinter", {}, ExitCode::kUsage, "--printer"},
                                         ErrorCase{"WrongPrinter",
                                                   {"--printer", "Acme On"},
                                                   ExitCode::kNotFound,
                                                   "do you mean \"Acme One\"?"},
                                         ErrorCase{"WrongFilament",
                                                   {"--printer", "Acme One", "--filament", "PLO"},
                                                   ExitCode::kNotFound,
                                                   "do you mean \"PLA\"?"},
                                         ErrorCase{
                                             "NoSuchFolder",
                                             {"--printer", "Acme One", "--presets", "/nowhere"},
                                             ExitCode::kUsage,
                                             "/nowhere"}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::cli::presets_program_test
