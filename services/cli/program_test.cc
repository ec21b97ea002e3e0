// The program itself, run as a process: exit codes, what it prints where, and what it leaves
// behind.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "services/cli/exit_code.h"
#include "services/cli/fake_coordinator_test.h"
#include "services/cli/files.h"
#include "services/cli/program_fixture_test.h"
#include "services/cli/render/gcode_layer.h"
#include "services/cli/render/layer_drawing.h"
#include "services/cli/render/picture_test.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"
#include "slicefarm/v1/profiles.grpc.pb.h"

namespace slicefarm::cli::program_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// A bar of 20 x 10 x 5 mm.
constexpr char kBar[] =
    "v 0 0 0\nv 20 0 0\nv 20 10 0\nv 0 10 0\nv 0 0 5\nv 20 0 5\nv 20 10 5\nv 0 10 5\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST_F(Program, HelpNamesEveryCommandAndExitCode) {
  const Outcome help = Run({"--help"});
  EXPECT_EQ(help.code, ExitCode::kOk);
  for (const char* command :
       {"slice", "submit", "watch", "list", "get", "cancel", "delete", "trace", "webhook", "render",
        "decompose", "settings", "health", "token", "tsp", "version"}) {
    EXPECT_THAT(help.out, HasSubstr(std::string("\n  ") + command + " "));
    const Outcome own = Run({command, "--help"});
    EXPECT_EQ(own.code, ExitCode::kOk) << command;
    EXPECT_THAT(own.out, HasSubstr(std::string("slicefarm ") + command)) << command;
  }
  for (int code = 0; code <= 10; ++code) {
    EXPECT_THAT(help.out, HasSubstr("\n  " + std::to_string(code) + (code < 10 ? "  " : " ")));
  }
}

TEST_F(Program, MakesTokensAndTheirEntries) {
  const Outcome outcome = Run({"token", "--scope", "read", "--expires", "2027-01-31T12:00:00Z"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  const std::string token = outcome.out.substr(0, outcome.out.find('\n'));
  EXPECT_THAT(token, testing::MatchesRegex("sf_[0-9a-f]{64}"));
  const auto entry = nlohmann::json::parse(outcome.out.substr(token.size()));
  EXPECT_EQ(entry["sha256"], Sha256Hex(token));
  EXPECT_EQ(entry["scopes"], nlohmann::json({"read"}));
  EXPECT_EQ(entry["expires"], "2027-01-31T12:00:00Z");
  EXPECT_NE(Run({"token"}).out, Run({"token"}).out);
  EXPECT_EQ(Run({"token", "--scope", "write"}).code, ExitCode::kUsage);
  EXPECT_EQ(Run({"token", "--expires", "soon"}).code, ExitCode::kUsage);
}

/// A comb of 3 teeth: the shortest tour has 12 edges of length 1.
constexpr char kComb[] =
    "NAME : comb\nTYPE : TSP\nDIMENSION : 12\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n"
    "1 0 0\n2 2 1\n3 1 0\n4 1 1\n5 2 0\n6 3 0\n7 0 1\n8 3 1\n9 4 0\n10 4 1\n11 5 1\n12 5 0\nEOF\n";

TEST_F(Program, FindsAShortTour) {
  Put("comb.tsp", kComb);
  const Arguments tsp = {"tsp", Path("comb.tsp"), "--seconds",      "1", "--seed",
                         "3",   "--tour",         Path("comb.tour")};
  const Outcome outcome = Run(tsp);
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("name comb\nn 12\nlength 12\nlower_bound 12\nseconds "));
  const std::string tour = Text("comb.tour");
  EXPECT_THAT(tour, StartsWith("NAME : comb\nTYPE : TOUR\nDIMENSION : 12\nTOUR_SECTION\n"));
  EXPECT_EQ(Run(tsp).code, ExitCode::kOk);
  EXPECT_EQ(Text("comb.tour"), tour) << "the same seed";
  for (const char* start : {"nearest", "greedy", "insertion", "christofides"}) {
    const Outcome first =
        Run({"tsp", Path("comb.tsp"), "--start", start, "--moves", "none", "--local", "--bounds"});
    EXPECT_EQ(first.code, ExitCode::kOk) << start << first.err;
    EXPECT_THAT(first.out, HasSubstr("\nspanning_tree 11\nodd_matching ")) << start;
  }
  EXPECT_EQ(Run({"tsp", Path("comb.tsp"), "--start", "best"}).code, ExitCode::kUsage);
  EXPECT_EQ(Run({"tsp", Path("comb.tsp"), "--tour", Path("no/comb.tour")}).code,
            ExitCode::kOutputFailed);
  EXPECT_EQ(Run({"tsp", Path("none.tsp")}).code, ExitCode::kUsage);
  Put("bad.tsp", "TYPE : TSP\nDIMENSION : x\n");
  const Outcome bad = Run({"tsp", Path("bad.tsp")});
  EXPECT_EQ(bad.code, ExitCode::kUsage);
  EXPECT_THAT(bad.err, HasSubstr("bad.tsp: line "));
}

TEST_F(Program, DecomposesAPolygon) {
  Put("l.poly", "1\n6 out\n0 0\n2.5 0\n2.5 1\n1 1\n1 2\n0 2\n1 2 3 4 5 6\n");
  for (const char* method : {"bian", "optimal", "approximate"}) {
    const Outcome outcome =
        Run({"decompose", Path("l.poly"), "-o", Path("pieces.txt"), "--method", method});
    ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith("pieces 2\nreflex 1\n"));
    for (const char* row : {"min_angle_deg ", "worst_shape ", "seconds "})
      EXPECT_THAT(outcome.out, HasSubstr(row));
    EXPECT_THAT(ReadFile(Path("pieces.txt"), 1000).value(), HasSubstr("2.5 0"));
  }
  Put("crossed.poly", "0 0\n1 0\n0 1\n1 1\n");
  EXPECT_EQ(Run({"decompose", Path("crossed.poly"), "-o", Path("none.txt")}).code,
            ExitCode::kUsage);
  EXPECT_FALSE(std::filesystem::exists(Path("none.txt")));
}

TEST_F(Program, SlicesACube) {
  const Outcome outcome = Slice({"--set", "layer_height=0.2", "--set", "first_layer_height=0.2"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("out.gcode: 50 layers"));
  EXPECT_THAT(outcome.out, HasSubstr("of filament"));
  EXPECT_THAT(outcome.err, IsEmpty());
  const std::string gcode = Text("out.gcode");
  EXPECT_THAT(gcode, StartsWith("; generated by slicefarm"));
  EXPECT_THAT(gcode, HasSubstr(";LAYER_CHANGE"));
  EXPECT_THAT(gcode, HasSubstr("; layer_height = 0.2"));
}

TEST_F(Program, GivesTheSameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(Slice({"--threads", "1"}).code, ExitCode::kOk);
  const std::string one = Text("out.gcode");
  for (const char* threads : {"2", "8"}) {
    ASSERT_EQ(Slice({"--threads", threads}).code, ExitCode::kOk);
    EXPECT_EQ(Text("out.gcode"), one);
  }
}

// What PrusaSlicer exports for these printers, in small: conditions on the names of the presets,
// pictures in QOI, notes. Each template must be filled in, and none of its marks may be left.
TEST_F(Program, SlicesWithProfilesInTheShapeOfRealOnes) {
  const std::pair<std::string, std::vector<std::string>> kProfiles[] = {
      {"shape_mk3s.ini",
       {"\nM907 E430 ; fine\n", "\nM900 K0.05 ; Somebody", "\nM117 1/50 0.2\n",
        ";0.2 of 210, 0.2 a layer\n", "; print_settings_id = 0.20mm QUALITY of ours\n",
        "; extruder_colour = #FF8000\n"}},
      {"shape_mk4.ini",
       {"\nM862.1 P0.4 A0 F1\n", "\nM572 S0.05 ; PETG", "\nM104 T0 S170\n",
        "; thumbnail_QOI begin 313x173 ", "; chamber_temperature = 20\n", "\nM117 0.2\n"}},
  };
  for (const auto& [name, parts] : kProfiles) {
    const Outcome outcome = Slice(
        {"--config", std::string(SLICEFARM_CORPUS) + "/config/" + name, "--set", "binary_gcode=0"});
    ASSERT_EQ(outcome.code, ExitCode::kOk) << name << ": " << outcome.err;
    const std::string gcode = Text("out.gcode");
    for (const std::string& part : parts) EXPECT_THAT(gcode, HasSubstr(part)) << name;
    EXPECT_THAT(gcode, Not(HasSubstr("\nM117 never"))) << name;
  }
}

TEST_F(Program, TakesTheSettingsOfItsOwnGcode) {
  ASSERT_EQ(Slice({"--set", "fill_density=35%", "--set", "perimeter_speed=47.5"}).code,
            ExitCode::kOk);
  const std::string first = Text("out.gcode");
  Put("first.gcode", first);
  const Outcome again = Slice({"--config", Path("first.gcode")});
  ASSERT_EQ(again.code, ExitCode::kOk) << again.err;
  EXPECT_EQ(Text("out.gcode"), first);
}

TEST_F(Program, WritesAReport) {
  Put("heights.ini", "colorprint_heights = 5\n");
  const Outcome outcome = Slice({"--report", Path("r.json"), "--config", Path("heights.ini"),
                                 "--allow", "colorprint_heights"});
  ASSERT_EQ(outcome.code, ExitCode::kOk);
  EXPECT_THAT(outcome.err, HasSubstr("warning: colorprint_heights = 5"));
  const auto report = nlohmann::json::parse(Text("r.json"));
  for (const char* key :
       {"meshes", "layers", "print_time_s", "print_time", "filament", "features", "travel",
        "stage_times_s", "warnings", "settings_without_effect", "settings_digest", "build_id"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  for (const char* key : {"mm", "mm3", "g"}) EXPECT_TRUE(report["filament"].contains(key)) << key;
  EXPECT_EQ(report["meshes"][0]["name"], "cube.obj");
  EXPECT_EQ(report["meshes"][0]["triangles"], 12);
  EXPECT_TRUE(report["meshes"][0]["closed"]);
  EXPECT_NEAR(report["meshes"][0]["volume_mm3"], 1000, 1e-6);
  EXPECT_THAT(report["settings_without_effect"][0], HasSubstr("colorprint_heights = 5"));
  EXPECT_THAT(report["warnings"][0], HasSubstr("colorprint_heights = 5"));
}

TEST_F(Program, PlacesThePart) {
  ASSERT_EQ(Slice({"--units", "cm", "--scale", "0.1,0.2,0.1", "--rotate-z", "90", "--center",
                   "50,60", "--center", "150,60", "--report", Path("r.json")})
                .code,
            ExitCode::kOk);
  const auto mesh = nlohmann::json::parse(Text("r.json"))["meshes"][0];
  EXPECT_THAT(mesh["min_mm"], testing::ElementsAre(40, 55, 0));
  EXPECT_THAT(mesh["max_mm"], testing::ElementsAre(60, 65, 10));
}

TEST_F(Program, NamesFilesAsTheirSettingsSay) {
  const std::string format = "output_filename_format=a/{filament_type[0]}_[input_filename_base]";
  std::filesystem::create_directory(Path("folder"));
  const Outcome folder = Run({"slice", Path("cube.obj"), "-o", Path("folder"), "--set", format,
                              "--report", Path("report.json")});
  ASSERT_EQ(folder.code, ExitCode::kOk) << folder.err;
  EXPECT_TRUE(Exists("folder/a_PLA_cube.gcode"));
  EXPECT_THAT(folder.out, HasSubstr("folder/a_PLA_cube.gcode"));
  EXPECT_EQ(nlohmann::json::parse(Text("report.json"))["file_name"], "a_PLA_cube.gcode");
  const Outcome beside = Run({"slice", Path("cube.obj"), "--set", "binary_gcode=1"});
  ASSERT_EQ(beside.code, ExitCode::kOk) << beside.err;
  EXPECT_THAT(Text("cube.bgcode"), StartsWith("GCDE"));
  for (const Arguments& reads :
       {Arguments{"check", Path("cube.bgcode"), "--flavor", "marlin"},
        Arguments{"render", Path("cube.bgcode"), "--layer", "1", "-o", Path("a.png")},
        Arguments{"slice", Path("cube.obj"), "-c", Path("cube.bgcode"), "-o", Path("b.bgcode")}})
    EXPECT_EQ(Run(reads).code, ExitCode::kOk) << reads[0];
  // Its settings call the file as the one that they are from.
  const Outcome same = Run({"slice", Path("cube.obj"), "-c", Path("cube.bgcode")});
  EXPECT_EQ(same.code, ExitCode::kUsage);
  EXPECT_THAT(same.err, HasSubstr("cube.bgcode is also an input"));
  const Outcome plates = Run({"slice", Path("cube.obj"), "--plates", "-o", Path("folder")});
  ASSERT_EQ(plates.code, ExitCode::kOk) << plates.err;
  EXPECT_TRUE(Exists("folder/cube-1.gcode"));
}

/// A project of two plates, of which the second is a vase; `plate` is refused for its walls.
std::string ProjectWithBadPlate(int plate) {
  namespace threemf = slicing::threemf;
  const std::string number = "key=\"plater_id\" value=\"" + std::to_string(plate) + "\"/>";
  threemf::Files files = threemf::BambuFiles();
  for (auto& [name, text] : files)
    if (const size_t at = text.find(number); at != std::string::npos)
      text.insert(at + number.size(), R"(<metadata key="wall_loops" value="-5"/>)");
  return threemf::Zipped(files);
}

TEST_F(Program, MakesThePlatesThatCanBeMade) {
  for (const int bad : {1, 2}) {
    Put("project.3mf", ProjectWithBadPlate(bad));
    const std::string output = "bad" + std::to_string(bad);
    const Arguments slice = {"slice", Path("project.3mf"), "--plates", "-o",
                             Path(output + ".gcode")};
    const Outcome outcome = Run(slice);
    EXPECT_EQ(outcome.code, ExitCode::kBadSettings) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("error: plate " + std::to_string(bad) + ": perimeters"));
    EXPECT_EQ(Exists(output + "-1.gcode"), bad != 1) << outcome.err;
    EXPECT_EQ(Exists(output + "-2.gcode"), bad != 2) << outcome.err;
    Arguments no_plates_fault = slice;
    no_plates_fault.insert(no_plates_fault.end(), {"--set", "perimeters=-4"});
    EXPECT_THAT(Run(no_plates_fault).err, StartsWith("error: perimeters = -4"));
  }
}

TEST_F(Program, PausesAtAHeight) {
  const Outcome outcome = Slice(
      {"--set", R"(custom_gcode_per_print_z=[{"z":1,"type":"pause","text":"insert the nut"}])"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(Text("out.gcode"), HasSubstr("\n;PAUSE_PRINT\nM117 insert the nut\nM601\n"));
}

TEST_F(Program, SlicesAPlateOfSeveralModels) {
  Put("bar.obj", kBar);
  const Outcome outcome =
      Slice({Path("bar.obj"), "--copies", "cube.obj=3", "--report", Path("r.json"), "--set",
             "layer_height=0.2", "--set", "first_layer_height=0.2", "--set",
             "gcode_label_objects=octoprint", "--object-set", "bar.obj:layer_height=0.1"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  const auto report = nlohmann::json::parse(Text("r.json"));
  ASSERT_EQ(report["meshes"].size(), 2);
  EXPECT_EQ(report["meshes"][0]["name"], "cube.obj");
  EXPECT_EQ(report["meshes"][1]["name"], "bar.obj");
  const std::string gcode = Text("out.gcode");
  for (const char* label :
       {"; printing object cube.obj id:0 copy 0\n", "; printing object cube.obj id:0 copy 2\n",
        "; printing object bar.obj id:1 copy 0\n"})
    EXPECT_THAT(gcode, HasSubstr(label));
  EXPECT_THAT(gcode, Not(HasSubstr("id:0 copy 3\n")));
  EXPECT_THAT(gcode, HasSubstr(";Z:5\n"));
  EXPECT_THAT(gcode, HasSubstr(";Z:4.9\n")) << "a layer of the bar alone";
  EXPECT_THAT(gcode, Not(HasSubstr(";Z:9.9\n"))) << "the cubes have none there";
}

TEST_F(Program, AModelThatIsNamedTwiceIsPrintedTwice) {
  ASSERT_EQ(Slice({"--copies", "cube.obj=2"}).code, ExitCode::kOk);
  const std::string copies = Text("out.gcode");
  ASSERT_EQ(Slice({Path("cube.obj")}).code, ExitCode::kOk);
  EXPECT_EQ(Text("out.gcode"), copies);
  ASSERT_EQ(Slice().code, ExitCode::kOk);
  EXPECT_NE(Text("out.gcode"), copies);
}

TEST_F(Program, TakesNegativeAngles) {
  EXPECT_EQ(Slice({"--rotate", "-90,0,0"}).code, ExitCode::kOk);
  EXPECT_EQ(Slice({"--rotate-z", "-45"}).code, ExitCode::kOk);
}

TEST_F(Program, TakesOptionsBeforeTheModel) {
  EXPECT_EQ(Run({"slice", "--set", "perimeters=1", "--set", "perimeters=2", Path("cube.obj"), "-o",
                 Path("out.gcode")})
                .code,
            ExitCode::kOk);
}

TEST_F(Program, WritesToStdoutWithoutAWordBesides) {
  const Outcome outcome = Run({"slice", Path("cube.obj"), "-o", "-"});
  ASSERT_EQ(outcome.code, ExitCode::kOk);
  EXPECT_THAT(outcome.out, StartsWith("; generated by slicefarm"));
  EXPECT_THAT(outcome.err, HasSubstr("layers"));
  ASSERT_EQ(Slice({"-q"}).code, ExitCode::kOk);
  EXPECT_EQ(outcome.out, Text("out.gcode"));
}

TEST_F(Program, IsQuietWhenAsked) {
  const Outcome outcome = Slice({"--quiet"});
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, IsEmpty());
}

struct FailureCase {
  std::string name;
  Arguments arguments;  ///< `@x` is the file x in the test's folder
  ExitCode code;
  std::string says;
};

class Failure : public Program, public testing::WithParamInterface<FailureCase> {};

TEST_P(Failure, HasItsExitCodeAndLeavesNoFile) {
  Put("truncated.stl", std::string(80, ' ') + std::string("\x05\0\0\0", 4) + std::string(60, 'x'));
  Put("empty.stl", "");
  Put("huge.obj", "v 0 0 0\nv 999 0 0\nv 0 999 0\nv 0 0 999\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  Put("bundle.ini", "[print:a]\nlayer_height = 0.2\n");
  Arguments arguments = GetParam().arguments;
  for (std::string& argument : arguments) {
    if (argument.starts_with('@')) argument = Path(argument.substr(1));
  }
  const Outcome outcome = Run(arguments);
  EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr(GetParam().says));
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    EXPECT_THAT(entry.path().filename().string(), Not(StartsWith("out.gcode")));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Slice, Failure,
    testing::Values(
        FailureCase{"NoCommand", {}, ExitCode::kUsage, "a command is missing"},
        FailureCase{"UnknownOption",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--banana"},
                    ExitCode::kUsage,
                    "--banana"},
        FailureCase{"NoSuchCommand", {"frobnicate"}, ExitCode::kUsage, "no command 'frobnicate'"},
        FailureCase{"NoOutputOfALaser",
                    {"slice", "@cube.obj", "--machine", "laser"},
                    ExitCode::kUsage,
                    "say which file the result goes to"},
        FailureCase{"NoModelFile",
                    {"slice", "@none.stl", "-o", "@out.gcode"},
                    ExitCode::kUsage,
                    "none.stl: No such file"},
        FailureCase{"NoConfigFile",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "-c", "@none.ini"},
                    ExitCode::kUsage,
                    "none.ini: No such file"},
        FailureCase{"SetWithoutValue",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--set", "perimeters"},
                    ExitCode::kUsage,
                    "key=value"},
        FailureCase{"UnknownSetting",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--set", "layer_hight=0.2"},
                    ExitCode::kBadSettings,
                    "do you mean layer_height?"},
        FailureCase{"SettingOutOfRange",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--set", "layer_height=90"},
                    ExitCode::kBadSettings,
                    "layer_height = 90 is out of range: it must be 0.01 to 5 mm"},
        FailureCase{"MalformedSetting",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--set", "layer_height=thin"},
                    ExitCode::kBadSettings,
                    "layer_height = 'thin'"},
        FailureCase{"Bundle",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--config", "@bundle.ini"},
                    ExitCode::kBadSettings,
                    "bundle.ini: line 1"},
        FailureCase{"TruncatedMesh",
                    {"slice", "@truncated.stl", "-o", "@out.gcode"},
                    ExitCode::kBadMesh,
                    "truncated.stl"},
        FailureCase{"EmptyMesh",
                    {"slice", "@empty.stl", "-o", "@out.gcode"},
                    ExitCode::kBadMesh,
                    "empty.stl"},
        FailureCase{
            "TooBig", {"slice", "@huge.obj", "-o", "@out.gcode"}, ExitCode::kBadMesh, "--scale"},
        FailureCase{"BadScale",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--scale", "0"},
                    ExitCode::kUsage,
                    "--scale 0"},
        FailureCase{"CopiesOfNoModel",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--copies", "other.obj=2"},
                    ExitCode::kUsage,
                    "--copies other.obj=2"},
        FailureCase{"CopiesAndCenter",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--copies", "cube.obj=2", "--center",
                     "50,50"},
                    ExitCode::kUsage,
                    "--copies and --center"},
        FailureCase{"SettingOfAnUnknownModel",
                    {"slice", "@cube.obj", "-o", "@out.gcode", "--object-set", "perimeters=2"},
                    ExitCode::kUsage,
                    "--object-set perimeters=2"},
        FailureCase{
            "SettingOfTheJobForAnObject",
            {"slice", "@cube.obj", "-o", "@out.gcode", "--object-set", "cube.obj:temperature=210"},
            ExitCode::kBadSettings,
            "temperature"},
        FailureCase{"SecondModelMissing",
                    {"slice", "@cube.obj", "@none.stl", "-o", "@out.gcode"},
                    ExitCode::kUsage,
                    "none.stl: No such file"},
        FailureCase{"OutputFolderMissing",
                    {"slice", "@cube.obj", "-o", "@none/out.gcode"},
                    ExitCode::kOutputFailed,
                    "none/out.gcode: No such file"},
        FailureCase{"DiskFull",
                    {"slice", "@cube.obj", "-o", "/dev/full"},
                    ExitCode::kOutputFailed,
                    "No space left"}),
    [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Others, Failure,
    testing::Values(
        FailureCase{"NobodyThere",
                    {"submit", "@cube.obj", "-o", "@out.gcode", "--server", "127.0.0.1:1",
                     "--patience", "0"},
                    ExitCode::kServerUnavailable,
                    "127.0.0.1:1"},
        FailureCase{"SubmitWithoutOutput", {"submit", "@cube.obj"}, ExitCode::kUsage, "--detach"},
        FailureCase{"Unhealthy",
                    {"health", "127.0.0.1:1", "--timeout", "5"},
                    ExitCode::kServerUnavailable,
                    "127.0.0.1:1"},
        FailureCase{"RenderNoGcode",
                    {"render", "@cube.obj", "--layer", "0", "-o", "@out.gcode.png"},
                    ExitCode::kUsage,
                    "LAYER_CHANGE"},
        FailureCase{"RenderUnknownFormat",
                    {"render", "@cube.obj", "--layer", "0", "-o", "@out.gcode.gif"},
                    ExitCode::kUsage,
                    ".png or .svg"},
        FailureCase{"NoSuchSetting", {"settings", "banana"}, ExitCode::kBadSettings, "banana"}),
    [](const auto& info) { return info.param.name; });

TEST_F(Program, StopsAtCtrlC) {
  // The model comes through a pipe, so that the signal meets the program while it works.
  ASSERT_EQ(mkfifo(Path("pipe.obj").c_str(), 0600), 0);
  std::signal(SIGPIPE, SIG_IGN);
  const pid_t pid =
      Start({"slice", Path("pipe.obj"), "-o", Path("out.gcode"), "--set", "layer_height=0.01"});
  std::ofstream pipe(Path("pipe.obj"));  // waits for the program to open its end
  ASSERT_EQ(kill(pid, SIGINT), 0);
  const auto pending = [&] {
    std::ifstream status("/proc/" + std::to_string(pid) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("ShdPnd:"))
        return std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1;
    }
    return 0ull;
  };
  while (pending() != 0) std::this_thread::yield();
  pipe << kCube;
  pipe.close();
  const Outcome outcome = Await(pid);
  EXPECT_EQ(outcome.code, ExitCode::kCancelled) << outcome.err;
  EXPECT_FALSE(Exists("out.gcode"));
}

/// The model never comes, and no computation is there to see the request.
TEST_F(Program, EndsWhereverItIs) {
  for (const int signal : {SIGINT, SIGTERM}) {
    std::filesystem::remove(Path("pipe.obj"));
    ASSERT_EQ(mkfifo(Path("pipe.obj").c_str(), 0600), 0);
    const pid_t pid = Start({"slice", Path("pipe.obj"), "-o", Path("out.gcode")});
    const std::ofstream pipe(Path("pipe.obj"));  // waits for the program to open its end
    ASSERT_EQ(kill(pid, signal), 0);
    const Outcome outcome = Await(pid);
    EXPECT_EQ(outcome.code, ExitCode::kCancelled) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("cancelled"));
    EXPECT_FALSE(Exists("out.gcode"));
  }
}

TEST_F(Program, RendersWhatItSliced) {
  ASSERT_EQ(Slice({"--set", "layer_height=0.2", "--set", "fill_density=0%", "--set",
                   "extrusion_width=0.5", "--set", "solid_infill_below_area=0"})
                .code,
            ExitCode::kOk);
  ASSERT_EQ(Run({"render", Path("out.gcode"), "--layer", "20", "-o", Path("l.png")}).code,
            ExitCode::kOk);
  const auto layer = ReadGcodeLayer(Text("out.gcode"), 20);
  ASSERT_TRUE(layer.ok());
  const Layout layout = LayOut(*layer, {});
  const Picture picture(Text("l.png"));
  // The cube lies on the middle of a bed of 200 by 200: its outer wall's middle runs 0.25 mm
  // inside.
  const Colour wall = picture.At(layout.ToPixel({100, 95.25}));
  EXPECT_NEAR(wall.red, FeatureColour("External perimeter").red, 0.01);
  EXPECT_NEAR(wall.green, FeatureColour("External perimeter").green, 0.01);
  EXPECT_NEAR(wall.blue, FeatureColour("External perimeter").blue, 0.01);
  const Colour middle = picture.At(layout.ToPixel({100, 100}));
  EXPECT_NEAR(middle.red + middle.green + middle.blue, 3, 0.01);
  const Colour outside = picture.At(layout.ToPixel({100, 94.8}));
  EXPECT_NEAR(outside.red + outside.green + outside.blue, 3, 0.01);

  ASSERT_EQ(
      Run({"render", Path("out.gcode"), "-l", "20", "--by", "width", "-o", Path("l.svg")}).code,
      ExitCode::kOk);
  EXPECT_THAT(Text("l.svg"), HasSubstr("<svg"));
}

TEST_F(Program, ListsSettings) {
  EXPECT_THAT(Run({"settings"}).out, HasSubstr("layer_height = 0.3\n"));
  const auto json = nlohmann::json::parse(Run({"settings", "--json", "perimeter_speed"}).out);
  ASSERT_EQ(json.size(), 3);
  EXPECT_EQ(json[1]["key"], "perimeter_speed");
  EXPECT_EQ(json[1]["unit"], "mm/s");
  EXPECT_EQ(json[1]["scope"], "region");
  Put("defaults.ini", Run({"settings", "--ini"}).out);
  ASSERT_EQ(Slice().code, ExitCode::kOk);
  const std::string gcode = Text("out.gcode");
  const Outcome same = Slice({"--config", Path("defaults.ini")});
  ASSERT_EQ(same.code, ExitCode::kOk) << same.err;
  EXPECT_EQ(Text("out.gcode"), gcode);
}

TEST_F(Program, SubmitsAndFetches) {
  FakeCoordinator server;
  const Outcome outcome =
      Run({"submit", Path("cube.obj"), "-o", Path("out.gcode"), "--report", Path("r.json"),
           "--server", server.address(), "--set", "perimeters=2", "--label", "queue=night"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_EQ(Text("out.gcode"), server.result);
  EXPECT_EQ(Text("r.json"), server.result);
  EXPECT_EQ(server.mesh, kCube);
  EXPECT_EQ(server.created.spec().settings(0).key(), "perimeters");
  EXPECT_EQ(server.created.spec().objects(0).name(), "cube.obj");
  EXPECT_EQ(server.created.labels().at("queue"), "night");
}

TEST_F(Program, SubmitsAPlateOfSeveralModels) {
  Put("bar.obj", kBar);
  FakeCoordinator server;
  const Outcome outcome = Run({"submit", Path("cube.obj"), Path("bar.obj"), Path("cube.obj"), "-o",
                               Path("out.gcode"), "--server", server.address(), "--copies",
                               "bar.obj=4", "--object-set", "bar.obj:perimeters=1"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_EQ(server.meshes.size(), 2) << "the same file is sent once";
  const v1::JobSpec& spec = server.created.spec();
  ASSERT_EQ(spec.objects_size(), 3);
  EXPECT_EQ(spec.objects(0).parts(0).mesh().sha256(), Sha256Hex(kCube));
  EXPECT_EQ(spec.objects(0).settings_size(), 0);
  EXPECT_EQ(spec.objects(1).parts(0).mesh().sha256(), Sha256Hex(kBar));
  EXPECT_EQ(spec.objects(1).name(), "bar.obj");
  EXPECT_EQ(spec.objects(1).instances_size(), 4);
  ASSERT_EQ(spec.objects(1).settings_size(), 1);
  EXPECT_EQ(spec.objects(1).settings(0).key(), "perimeters");
  EXPECT_EQ(spec.objects(1).settings(0).value(), "1");
  EXPECT_EQ(spec.objects(2).parts(0).mesh().sha256(), Sha256Hex(kCube));
  EXPECT_EQ(spec.settings_size(), 0);
}

TEST_F(Program, PrintsTheJobWhenDetached) {
  FakeCoordinator server;
  const Outcome outcome =
      Run({"submit", Path("cube.obj"), "--detach", "--server", server.address()});
  EXPECT_EQ(outcome.code, ExitCode::kOk);
  EXPECT_EQ(outcome.out, "job-1\n");
}

TEST_F(Program, PassesTheTraceOn) {
  FakeCoordinator server;
  const std::string given = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01";
  const auto submit = [&](const std::string& trace) {
    return Run({"submit", Path("cube.obj"), "--detach", "--server", server.address(),
                "--traceparent", trace});
  };
  const Outcome traced = submit(given);
  EXPECT_EQ(traced.code, ExitCode::kOk);
  EXPECT_EQ(traced.err, "");
  EXPECT_EQ(server.trace, ParseTraceparent(given));
  const Outcome broken = submit("00-nonsense");
  EXPECT_EQ(broken.code, ExitCode::kOk);
  EXPECT_THAT(broken.err, HasSubstr("no W3C trace context"));
  EXPECT_TRUE(server.trace.empty());
}

TEST_F(Program, TakesTheTraceOfTheEnvironment) {
  FakeCoordinator server;
  const std::string given = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01";
  setenv("TRACEPARENT", given.c_str(), 1);
  Run({"submit", Path("cube.obj"), "--detach", "--server", server.address()});
  unsetenv("TRACEPARENT");
  EXPECT_EQ(server.trace, ParseTraceparent(given));
}

TEST_F(Program, TellsHowAJobEnded) {
  FakeCoordinator server;
  const auto watch = [&] { return Run({"watch", "job-1", "--server", server.address()}); };
  EXPECT_EQ(watch().code, ExitCode::kOk);
  server.end_state = v1::JOB_STATE_CANCELLED;
  EXPECT_EQ(watch().code, ExitCode::kCancelled);
  server.end_state = v1::JOB_STATE_FAILED;
  server.end_error.set_code(13);
  server.end_error.set_reason("RANGE_POISONED");
  server.end_error.set_message("layers 3 to 9 failed three times");
  const Outcome failed = watch();
  EXPECT_EQ(failed.code, ExitCode::kJobFailed);
  EXPECT_THAT(failed.err, HasSubstr("layers 3 to 9 failed three times"));
  server.end_error.set_reason("MESH_TRUNCATED");
  EXPECT_EQ(watch().code, ExitCode::kBadMesh);
}

TEST_F(Program, LeavesNoFileWhenTheJobFails) {
  FakeCoordinator server;
  server.end_state = v1::JOB_STATE_FAILED;
  const Outcome outcome =
      Run({"submit", Path("cube.obj"), "-o", Path("out.gcode"), "--server", server.address()});
  EXPECT_EQ(outcome.code, ExitCode::kJobFailed);
  EXPECT_FALSE(Exists("out.gcode"));
}

TEST_F(Program, CancelsTheJobItWaitsForAtCtrlC) {
  for (const auto& [state, said] :
       {std::pair{v1::JOB_STATE_CANCELLED, "job job-1 was cancelled"},
        std::pair{v1::JOB_STATE_RUNNING, "job job-1 is being cancelled"},
        std::pair{v1::JOB_STATE_SUCCEEDED, "`slicefarm get job-1 -o OUT.gcode` fetches it"}}) {
    FakeCoordinator server;
    server.hold_watches = true;
    server.state_after_cancel = state;
    const pid_t pid =
        Start({"submit", Path("cube.obj"), "-o", Path("out.gcode"), "--server", server.address()});
    while (server.watches == 0) std::this_thread::yield();
    ASSERT_EQ(kill(pid, SIGINT), 0);
    const Outcome outcome = Await(pid);
    EXPECT_EQ(outcome.code, ExitCode::kCancelled) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(said));
    EXPECT_EQ(server.cancelled, "job-1");
    EXPECT_FALSE(Exists("out.gcode"));
  }
}

TEST_F(Program, SubmitsNothingWhoseResultHasNoPlaceToGo) {
  FakeCoordinator server;
  const Outcome outcome = Run(
      {"submit", Path("cube.obj"), "-o", Path("nowhere/out.gcode"), "--server", server.address()});
  EXPECT_NE(outcome.code, ExitCode::kOk);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere/out.gcode"));
  EXPECT_EQ(server.created.spec().objects_size(), 0);
}

TEST_F(Program, SaysThatAServerIsNoCoordinator) {
  v1::Profiles::Service other;
  grpc::ServerBuilder builder;
  builder.RegisterService(&other);
  int port = 0;
  builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
  const auto server = builder.BuildAndStart();
  const Outcome outcome = Run({"list", "--server", "127.0.0.1:" + std::to_string(port)});
  EXPECT_EQ(outcome.code, ExitCode::kServerUnavailable);
  EXPECT_THAT(outcome.err, HasSubstr("the server has no such method"));
  EXPECT_THAT(outcome.err, HasSubstr("is a coordinator of this version at that address?"));
}

TEST_F(Program, SaysThatAJobIsNotThere) {
  FakeCoordinator server;
  for (const char* command : {"get", "cancel", "delete"}) {
    const Outcome outcome = Run({command, "job-2", "--server", server.address()});
    EXPECT_EQ(outcome.code, ExitCode::kNotFound) << command;
    EXPECT_THAT(outcome.err, HasSubstr("there is no job job-2"));
  }
}

TEST_F(Program, ListsAllPages) {
  FakeCoordinator server;
  server.listed_jobs = 250;
  const std::string all = Run({"list", "--limit", "1000", "--server", server.address()}).out;
  EXPECT_THAT(all, HasSubstr("job-0 "));
  EXPECT_THAT(all, HasSubstr("job-249 "));
  const auto json = nlohmann::json::parse(
      Run({"list", "--limit", "120", "--json", "--server", server.address()}).out);
  EXPECT_EQ(json["jobs"].size(), 120);
}

TEST_F(Program, TellsWhatJobsWaitFor) {
  FakeCoordinator server;
  server.listed_jobs = 3;
  EXPECT_EQ(Run({"list", "--server", server.address()}).err, "");
  server.waits_for = "a worker";
  // Once for all that wait for the same.
  EXPECT_EQ(Run({"list", "--server", server.address()}).err, "warning: 2 jobs wait for a worker\n");
  EXPECT_EQ(Run({"submit", Path("cube.obj"), "--detach", "--server", server.address()}).err,
            "warning: 1 job waits for a worker\n");
}

TEST_F(Program, AsksForHealth) {
  FakeCoordinator server;
  EXPECT_EQ(Run({"health", server.address()}).code, ExitCode::kOk);
}

TEST_F(Program, TellsItsVersion) {
  const Outcome outcome = Run({"version"});
  EXPECT_EQ(Run({"--version"}).out, outcome.out);
  EXPECT_EQ(outcome.code, ExitCode::kOk);
  EXPECT_THAT(outcome.out,
              testing::MatchesRegex("slicefarm [0-9.]+ \\([0-9-]+\\), build [0-9a-f]+\n"));
}

}  // namespace
}  // namespace slicefarm::cli::program_test
