// Tests wrong command lines: each message names the mistake and the correct form, and existing
// files are unchanged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

#include "services/cli/console/program_fixture_test.h"

namespace slicefarm::cli::wrong_usage_test {
namespace {

using testing::HasSubstr;

constexpr ExitCode kUsage = ExitCode::kUsage;
constexpr ExitCode kSettings = ExitCode::kBadSettings;

/// `@name` is a file of the folder: cube.obj, machine.ini, out.gcode (a file of G-code).
struct Case {
  const char* name;
  Arguments arguments;
  ExitCode code = kUsage;
  std::vector<std::string> words = {};  ///< texts that the message must contain
};

class WrongUsage : public Program, public testing::WithParamInterface<Case> {
 protected:
  WrongUsage() {
    Put("machine.ini",
        "bed_shape = 0x0,250x0,250x210,0x210\nnozzle_diameter = 0.4\ngcode_flavor = marlin2\n");
    Put("binary.ini", Text("machine.ini") + "binary_gcode = 1\n");
    Put("colours.ini", Text("machine.ini") + "colorprint_heights = 5\n");
    Put("resin.ini", Text("machine.ini") + "printer_technology = SLA\n");
    Put("template.ini", Text("machine.ini") + "layer_gcode = {no_such_name}\n");
    Put("start.ini", Text("machine.ini") + "start_gcode = {no_such_name}\n");
    Put("other.ini",
        Text("machine.ini") +
            "compatible_printers_condition_cummulative = \"printer_model=~/ENDER.*/\"\n");
    Put("out.gcode", "G28\nG1 X1 Y1\n");
    Put("text.txt", "not a model\n");
    std::filesystem::create_directory(Path("folder"));
  }

  Arguments Resolved() const {
    Arguments arguments = GetParam().arguments;
    for (std::string& argument : arguments)
      for (size_t at = argument.find('@'); at != std::string::npos; at = argument.find('@', at + 1))
        if (at == 0 || argument[at - 1] == '=') argument.replace(at, 1, Path(""));
    return arguments;
  }
};

TEST_P(WrongUsage, NamesTheMistakeAndTheRemedy) {
  const Outcome outcome = Run(Resolved());
  EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
  for (const std::string& word : GetParam().words) EXPECT_THAT(outcome.err, HasSubstr(word));
  EXPECT_THAT(outcome.out, testing::IsEmpty());
  EXPECT_EQ(Text("cube.obj"), kCube);
  EXPECT_EQ(Text("out.gcode"), "G28\nG1 X1 Y1\n");
}

const auto kName = [](const auto& info) { return std::string(info.param.name); };

INSTANTIATE_TEST_SUITE_P(
    Commands, WrongUsage,
    testing::Values(
        Case{"Nothing", {}, kUsage, {"a command is missing", "slicefarm --help"}},
        Case{"Mistyped",
             {"slcie", "@cube.obj"},
             kUsage,
             {"no command 'slcie'", "do you mean slice?"}},
        Case{"MistypedSubmit", {"sumbit"}, kUsage, {"do you mean submit?"}},
        Case{"MistypedList", {"lst"}, kUsage, {"do you mean list?"}},
        Case{"Unlike", {"print"}, kUsage, {"no command 'print'", "slicefarm --help"}},
        Case{"HelpOfNothing",
             {"help", "slcie"},
             kUsage,
             {"'slcie' is not one of", "do you mean slice?"}},
        Case{"InnerMissing", {"profile"}, kUsage, {"slicefarm profile: a command is missing"}},
        Case{"InnerMistyped",
             {"profile", "pt", "a"},
             kUsage,
             {"no command 'pt'", "do you mean put?"}},
        Case{"InnerOfMeshes", {"meshes", "lits"}, kUsage, {"do you mean list?"}},
        Case{"Shell",
             {"completion", "zhs"},
             kUsage,
             {"'zhs' is not one of bash, zsh, fish, man", "zsh?"}},
        Case{"OptionBeforeCommand", {"--verbos"}, kUsage, {"--verbos"}}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Options, WrongUsage,
    testing::Values(
        Case{"SettingAsOption",
             {"slice", "@cube.obj", "--layer-height", "0.2"},
             kUsage,
             {"no option --layer-height", "--set layer_height=VALUE"}},
        Case{"SettingWithEquals",
             {"slice", "@cube.obj", "--fill-density=20%"},
             kUsage,
             {"no option --fill-density", "--set fill_density=VALUE"}},
        Case{"MistypedOption",
             {"slice", "@cube.obj", "--ouput", "a.gcode"},
             kUsage,
             {"no option --ouput", "do you mean --output?"}},
        Case{"MistypedConfig", {"slice", "@cube.obj", "--confg", "a.ini"}, kUsage, {"--config?"}},
        Case{"OfAnotherCommand",
             {"slice", "@cube.obj", "--profile", "mk4s"},
             kUsage,
             {"slicefarm slice has no option --profile",
              "commands with this option:", "`slicefarm submit`"}},
        Case{"UnknownLetter", {"slice", "@cube.obj", "-z"}, kUsage, {"has no option -z"}},
        Case{"Unlike", {"list", "--xyzzyxyzzy"}, kUsage, {"no option --xyzzyxyzzy", "list --help"}},
        Case{"NoModel", {"slice"}, kUsage, {"slicefarm slice: MODEL", "slice --help"}},
        Case{"NoJob", {"watch"}, kUsage, {"slicefarm watch: JOB"}},
        Case{"NoKey", {"profile", "put"}, kUsage, {"slicefarm profile put: NAME"}},
        Case{"NoValue", {"slice", "@cube.obj", "-o"}, kUsage, {"--output", "OUT.gcode"}},
        Case{"TooMuch", {"list", "all"}, kUsage, {"slicefarm list takes no 'all'"}},
        Case{"Excluded",
             {"slice", "@cube.obj", "--rotate", "0,0,1", "--rotate-z", "3"},
             kUsage,
             {"--rotate", "--rotate-z"}},
        Case{"SetWithoutEquals",
             {"slice", "@cube.obj", "--set", "layer_height"},
             kUsage,
             {"--set layer_height", "KEY=VALUE"}},
        Case{"LabelWithoutEquals",
             {"submit", "@cube.obj", "--detach", "--label", "x"},
             kUsage,
             {"--label x", "KEY=VALUE"}},
        Case{"OrientWithoutCheck",
             {"submit", "@cube.obj", "--detach", "--orient"},
             kUsage,
             {"--orient", "--check"}},
        Case{"SubmitWithoutPlace", {"submit", "@cube.obj"}, kUsage, {"-o OUT.gcode", "--detach"}},
        Case{"QuoteWithOutput",
             {"submit", "@cube.obj", "--quote", "-o", "@a.gcode"},
             kUsage,
             {"--quote makes no G-code"}}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Values, WrongUsage,
    testing::Values(
        Case{"Negative",
             {"submit", "@cube.obj", "--deadline", "-4"},
             kUsage,
             {"--deadline", "-4 is out of range", "more than 0"}},
        Case{"NotANumber",
             {"submit", "@cube.obj", "--deadline", "soon"},
             kUsage,
             {"'soon' is not a number", "more than 0"}},
        Case{"TooLarge",
             {"slice", "@cube.obj", "--threads", "1000"},
             kUsage,
             {"--threads", "1000 is out of range", "from 1 to 256"}},
        Case{"Fraction", {"slice", "@cube.obj", "--threads", "1.5"}, kUsage, {"a whole number"}},
        Case{"Patience", {"list", "--patience", "-1"}, kUsage, {"--patience", "from 0 to 86400"}},
        Case{"Limit", {"list", "--limit", "0"}, kUsage, {"--limit", "from 1 to 100000"}},
        Case{"Angle",
             {"slice", "@cube.obj", "--rotate-z", "left"},
             kUsage,
             {"--rotate-z = left", "a number is needed"}},
        Case{"Choice",
             {"submit", "@cube.obj", "--priority", "bluk"},
             kUsage,
             {"--priority", "'bluk' is not one of bulk, normal, interactive", "do you mean bulk?"}},
        Case{"State", {"list", "--state", "finished"}, kUsage, {"'finished' is not one of queued"}},
        Case{"Machine",
             {"slice", "@cube.obj", "--machine", "lasre"},
             kUsage,
             {"do you mean laser?"}},
        Case{"Units", {"slice", "@cube.obj", "--units", "inches"}, kUsage, {"do you mean inch?"}},
        Case{"Color",
             {"render", "@out.gcode", "--layer", "1", "-o", "@a.png", "--color", "feture"},
             kUsage,
             {"do you mean feature?"}},
        Case{"Scope",
             {"token", "--scope", "write"},
             kUsage,
             {"'write' is not one of submit, read, admin"}},
        Case{"Kind",
             {"artifacts", "0123", "--kind", "thumnail"},
             kUsage,
             {"do you mean thumbnail?"}},
        Case{"Scale",
             {"slice", "@cube.obj", "-o", "@a.gcode", "--scale", "0"},
             kUsage,
             {"--scale 0", "more than 0"}},
        Case{"Center",
             {"slice", "@cube.obj", "-o", "@a.gcode", "--center", "1"},
             kUsage,
             {"--center 1", "2 numbers"}},
        Case{"Copies",
             {"slice", "@cube.obj", "-o", "@a.gcode", "--copies", "ball.stl=2"},
             kUsage,
             {"--copies ball.stl=2", "MODEL=N"}},
        Case{
            "Since", {"events", "--from", "yesterday"}, kUsage, {"--from", "2027-01-31T12:00:00Z"}},
        Case{"Revision",
             {"profile", "get", "mk4s@new"},
             kUsage,
             {"mk4s@new", "number of a revision"}},
        Case{"TwoRevisions",
             {"profile", "get", "mk4s@1", "--revision", "2"},
             kUsage,
             {"two different revisions"}},
        Case{"Flavor",
             {"time", "@out.gcode", "--flavor", "marlni"},
             kUsage,
             {"--flavor marlni", "marlin"}},
        Case{"NoFlavor", {"time", "@cube.obj"}, kUsage, {"gcode_flavor", "--flavor klipper"}}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Settings, WrongUsage,
    testing::Values(Case{"MistypedKey",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--set", "fil_density=10%"},
                         kSettings,
                         {"no setting 'fil_density'", "do you mean fill_density?"}},
                    Case{"OrcasKey",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--set", "wall_loops=3"},
                         kSettings,
                         {"'wall_loops'", "do you mean perimeters?"}},
                    Case{"OrcasDensity",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--set",
                          "sparse_infill_density=9"},
                         kSettings,
                         {"do you mean fill_density?"}},
                    Case{"MistypedChoice",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--set", "fill_pattern=gyriod"},
                         kSettings,
                         {"gyriod", "do you mean gyroid?"}},
                    Case{"OutOfRange",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--set", "layer_height=9"},
                         kSettings,
                         {"layer_height = 9 is out of range", "slicefarm settings layer_height"}},
                    Case{"NoNumber",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--set", "perimeters=two"},
                         kSettings,
                         {"perimeters = 'two'", "must be a number"}},
                    Case{"ListedMistyped",
                         {"settings", "infil_sped"},
                         kSettings,
                         {"no setting has 'infil_sped'", "do you mean infill_speed?"}},
                    Case{"OfAnotherMachine",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--set", "stepdown=1"},
                         kSettings,
                         {"stepdown is a setting of process mill"}},
                    Case{"Colours",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--config", "@colours.ini"},
                         kSettings,
                         {"not supported: colorprint_heights = 5", "--allow colorprint_heights"}},
                    Case{"ColoursByHand",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--set", "colorprint_heights=5"},
                         kSettings,
                         {"colorprint_heights = 5: not supported yet"}},
                    Case{"Resin",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--config", "@resin.ini"},
                         kSettings,
                         {"printer_technology = SLA", "--allow printer_technology"}},
                    Case{"Template",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--config", "@template.ini"},
                         kSettings,
                         {"layer_gcode, line 1", "no_such_name", "--allow gcode_templates"}},
                    Case{"StartIsNeverLeftOut",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--config", "@start.ini",
                          "--allow", "gcode_templates"},
                         kSettings,
                         {"start_gcode, line 1", "no_such_name"}},
                    Case{"OtherPrinter",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--config", "@other.ini"},
                         kSettings,
                         {"made for other printers", "--allow incompatible_profiles"}},
                    Case{"AllowMistyped",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--allow", "several_tool"},
                         kUsage,
                         {"no feature 'several_tool'", "do you mean several_tools?"}},
                    Case{"AllowSecondMistyped",
                         {"slice", "@cube.obj", "-o", "@a.gcode", "--allow", "several_tools,all"},
                         kUsage,
                         {"no feature 'all'", "painted_filaments"}}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Files, WrongUsage,
    testing::Values(
        Case{"ReplacesItsModel",
             {"slice", "@cube.obj", "-o", "@cube.obj", "--format", "gcode"},
             kUsage,
             {"cube.obj is also an input", "another name"}},
        Case{"ReplacesItsConfig",
             {"slice", "@cube.obj", "--config", "@machine.ini", "-o", "@machine.ini", "--format",
              "gcode"},
             kUsage,
             {"machine.ini is also an input"}},
        Case{"ReportReplacesItsConfig",
             {"slice", "@cube.obj", "--config", "@machine.ini", "-o", "@a.gcode", "--report",
              "@machine.ini"},
             kUsage,
             {"machine.ini is also an input"}},
        Case{"SubmitReplacesItsModel",
             {"submit", "@cube.obj", "-o", "@cube.obj", "--format", "gcode"},
             kUsage,
             {"cube.obj is also an input"}},
        Case{"OneFileForBoth",
             {"slice", "@cube.obj", "-o", "@a.txt", "--report", "@a.txt"},
             kUsage,
             {"-o and --report name the same file"}},
        Case{"NamedAsAModel",
             {"slice", "@cube.obj", "-o", "@a.stl"},
             kUsage,
             {"a.stl", "a model", "--format"}},
        Case{
            "NamedAsAModelInCapitals", {"slice", "@cube.obj", "-o", "@A.STL"}, kUsage, {"a model"}},
        Case{"NamedAsAnArchive",
             {"slice", "@cube.obj", "-o", "@a.zip"},
             kUsage,
             {"a.zip", "archive"}},
        Case{"NamedAsAnArchiveOfAnotherMachine",
             {"slice", "@cube.obj", "--machine", "laser", "-o", "@a.gcode.3mf"},
             kUsage,
             {"a.gcode.3mf", "--machine fdm"}},
        Case{"NamedAsLayers",
             {"submit", "@cube.obj", "-o", "@a.slm"},
             kUsage,
             {"a.slm", "--format"}},
        Case{"TextNamedBinary",
             {"slice", "@cube.obj", "-o", "@a.bgcode"},
             kUsage,
             {"a.bgcode", "binary_gcode = 1", "--format"}},
        Case{"BinaryNamedText",
             {"slice", "@cube.obj", "-o", "@a.gcode", "--config", "@binary.ini"},
             kUsage,
             {"a.gcode", "binary_gcode = 1", "*.bgcode"}},
        Case{"BinaryNamedTextOfPlates",
             {"slice", "@cube.obj", "--plates", "-o", "@a.gcode", "--set", "binary_gcode=1"},
             kUsage,
             {"a.gcode", "*.bgcode"}},
        Case{"OfAnotherMachine",
             {"slice", "@cube.obj", "-o", "@a.cli"},
             kUsage,
             {"--machine laser"}},
        Case{"UnknownFormat",
             {"slice", "@cube.obj", "-o", "@a", "--format", "gcod"},
             kUsage,
             {"--format gcod", "do you mean gcode?"}},
        Case{"FormatOfAnotherMachine",
             {"slice", "@cube.obj", "-o", "@a", "--format", "cli"},
             kUsage,
             {"--format cli", "--machine laser"}},
        Case{"NoSuchModel",
             {"slice", "@none.stl", "-o", "@a.gcode"},
             kUsage,
             {"none.stl", "No such file"}},
        Case{"NoSuchConfig",
             {"slice", "@cube.obj", "-o", "@a.gcode", "-c", "@none.ini"},
             kUsage,
             {"none.ini"}},
        Case{"NoModelAtAll",
             {"slice", "@text.txt", "-o", "@a.gcode"},
             ExitCode::kBadMesh,
             {"text.txt"}},
        Case{"NoPlate",
             {"slice", "@cube.obj", "-o", "@a.gcode", "--plate", "2"},
             kUsage,
             {"3MF project"}}),
    kName);

/// Different names of the output for the file that is the model.
struct Spelling {
  const char* name;
  void (*make)(const std::string& folder);
  const char* output;
};

class SameFile : public Program, public testing::WithParamInterface<Spelling> {};

TEST_P(SameFile, IsNeverReplaced) {
  GetParam().make(Path(""));
  for (const char* command : {"slice", "submit"}) {
    const Outcome outcome = Run({command, Path("cube.obj"), "--generic", "--format", "gcode", "-o",
                                 Path(GetParam().output)});
    EXPECT_EQ(outcome.code, ExitCode::kUsage) << command << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("is also an input")) << command;
    EXPECT_EQ(Text("cube.obj"), kCube) << command;
    EXPECT_EQ(Text(GetParam().output), kCube) << command;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Names, SameFile,
    testing::Values(Spelling{"Itself", [](const std::string&) {}, "cube.obj"},
                    Spelling{"Dotted", [](const std::string&) {}, "./cube.obj"},
                    Spelling{"Relative",
                             [](const std::string& folder) {
                               std::filesystem::create_directory(folder + "sub");
                             },
                             "sub/../cube.obj"},
                    Spelling{"Symlink",
                             [](const std::string& folder) {
                               std::filesystem::create_symlink("cube.obj", folder + "link");
                             },
                             "link"},
                    Spelling{"HardLink",
                             [](const std::string& folder) {
                               std::filesystem::create_hard_link(folder + "cube.obj",
                                                                 folder + "hard");
                             },
                             "hard"}),
    kName);

class Named : public Program {};

TEST_F(Named, ByFormatAnyNameIsMeant) {
  EXPECT_EQ(Slice({"--format", "bgcode"}).code, ExitCode::kOk);
  EXPECT_THAT(Text("out.gcode"), testing::StartsWith("GCDE"));
  EXPECT_EQ(
      Run({"slice", Path("cube.obj"), "--generic", "-o", Path("a.stl"), "--format", "gcode"}).code,
      ExitCode::kOk);
  EXPECT_THAT(Text("a.stl"), testing::StartsWith("; generated by"));
  EXPECT_EQ(Run({"slice", Path("cube.obj"), "--generic", "-o", Path("a.bgcode"), "--set",
                 "binary_gcode=1"})
                .code,
            ExitCode::kOk);
}

TEST_F(Named, BinaryGcodeIsReadAsTextIs) {
  ASSERT_EQ(Slice().code, ExitCode::kOk);
  ASSERT_EQ(
      Run({"slice", Path("cube.obj"), "--generic", "-o", Path("b.bgcode"), "--format", "bgcode"})
          .code,
      ExitCode::kOk);
  const Outcome text = Run({"time", Path("out.gcode"), "--flavor", "marlin"});
  const Outcome binary = Run({"time", Path("b.bgcode"), "--flavor", "marlin"});
  EXPECT_EQ(binary.code, ExitCode::kOk) << binary.err;
  EXPECT_EQ(binary.out, text.out);
  EXPECT_EQ(Run({"render", Path("b.bgcode"), "--layer", "3", "-o", Path("b.png")}).code,
            ExitCode::kOk);
  EXPECT_EQ(Run({"check", Path("b.bgcode"), "--flavor", "marlin"}).code, ExitCode::kOk);
  const std::string before = Text("b.bgcode");
  const Outcome replaces =
      Run({"render", Path("b.bgcode"), "--layer", "3", "--format", "png", "-o", Path("b.bgcode")});
  EXPECT_EQ(replaces.code, ExitCode::kUsage);
  EXPECT_THAT(replaces.err, HasSubstr("b.bgcode is also an input"));
  EXPECT_EQ(Text("b.bgcode"), before);
}

TEST_F(Named, WhatIsAllowedIsWarnedOf) {
  Put("colours.ini", "colorprint_heights = 5\n");
  const Outcome outcome = Slice({"--config", Path("colours.ini"), "--allow", "colorprint_heights"});
  EXPECT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("warning: colorprint_heights = 5"));
  EXPECT_THAT(outcome.out, HasSubstr("such as colorprint_heights = 5"));
}

TEST_F(Named, AJobWithoutAPrinterIsWarnedOf) {
  const Outcome outcome = Run({"slice", Path("cube.obj"), "-o", Path("out.gcode")});
  EXPECT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("do not name a printer"));
  EXPECT_THAT(outcome.err, HasSubstr("--generic"));
}

TEST_F(Named, HelpOfAllCommandsIsTheSameAsTheirOwn) {
  EXPECT_EQ(Run({"help"}).out, Run({"--help"}).out);
  EXPECT_EQ(Run({"help", "profile", "put"}).out, Run({"profile", "put", "--help"}).out);
  EXPECT_EQ(Run({"-v"}).out, Run({"--version"}).out);
  for (const char* shell : {"bash", "zsh", "fish", "man"})
    EXPECT_THAT(Run({"completion", shell}).out, HasSubstr("slice")) << shell;
}

}  // namespace
}  // namespace slicefarm::cli::wrong_usage_test
