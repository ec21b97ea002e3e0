#include "common/config/presets/read_presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include "common/base/error.h"
#include "common/config/presets/preset_files_test.h"

namespace slicefarm::config::presets::read_presets_test {
namespace {

std::string ValueIn(const PresetSet& set, PresetKind kind, std::string_view name,
                    std::string_view key) {
  const Preset* preset = Only(set, kind, name);
  if (preset == nullptr) return "(no preset)";
  const auto flat = set.Flatten(*preset);
  if (!flat.ok()) return std::string(flat.status().message());
  const auto found = flat->find(key);
  return found == flat->end() ? "(none)" : found->second.value;
}

struct Case {
  std::string name;
  std::vector<PresetFile> files;
  PresetKind kind;
  std::string preset;
  std::string key;
  std::string value;
};

class ReadPresetsTest : public testing::TestWithParam<Case> {};

TEST_P(ReadPresetsTest, Resolves) {
  const Case& c = GetParam();
  const auto set = ReadPresets(c.files);
  ASSERT_TRUE(set.ok()) << set.status();
  EXPECT_EQ(ValueIn(*set, c.kind, c.preset, c.key), c.value);
}

std::vector<PresetFile> PrusaBundle() {
  return Files({{"Prusa.ini", R"([vendor]
name = Acme Research
config_version = 1.0
[printer_model:A4]
name = Acme 4
default_materials = Acme PLA; Other PLA
[print:*common*]
layer_height = 0.2
perimeters = 2
[print:*fast*]
perimeters = 3
perimeter_speed = 100
[print:0.20mm SPEED @A4]
inherits = *common*; *fast*
perimeter_speed = 120
compatible_printers_condition = printer_model=="A4"
renamed_from = "0.20mm FAST @A4"; Old
[filament:Acme PLA]
temperature = 215
start_filament_gcode = "M900 K0.05"
[printer:Acme 4]
printer_model = A4
nozzle_diameter = 0.4
default_print_profile = 0.20mm SPEED @A4
)"}});
}

constexpr auto kPrinter = PresetKind::kPrinter;
constexpr auto kProcess = PresetKind::kProcess;
constexpr auto kFilament = PresetKind::kFilament;

INSTANTIATE_TEST_SUITE_P(
    Presets, ReadPresetsTest,
    testing::Values(
        Case{"OrcaOwn", OrcaFolder(), kPrinter, "Acme One 0.6", "nozzle_diameter", R"(["0.6"])"},
        Case{"OrcaParent", OrcaFolder(), kPrinter, "Acme One 0.6", "gcode_flavor", "klipper"},
        Case{"OrcaOldName", OrcaFolder(), kPrinter, "Acme Uno 0.6", "gcode_flavor", "klipper"},
        Case{"OrcaLibrary", OrcaFolder(), kFilament, "Acme PLA @One", "filament_density",
             R"(["1.24"])"},
        Case{"OrcaUser", OrcaFolder(), kProcess, "Fast", "outer_wall_speed", "120"},
        Case{"OrcaUserParent", OrcaFolder(), kProcess, "Fast", "wall_loops", "4"},
        Case{"OrcaNewline", OrcaFolder(), kPrinter, "My One", "machine_start_gcode",
             R"(G28\nPRIME)"},
        Case{"OrcaBaseIsNotListed", OrcaFolder(), kProcess, "fdm", "wall_loops", "(no preset)"},
        Case{"OrcaUnlistedFile", OrcaFolder(), kProcess, "Draft", "wall_loops", "(no preset)"},
        Case{"OrcaOnlyFile",
             Files({{"a/filament/Mine.json", R"({"nozzle_temperature": ["200"]})"}}), kFilament,
             "Mine", "nozzle_temperature", R"(["200"])"},
        Case{"BambuInclude",
             Files({{"V.json", R"({"machine_list": [{"sub_path": "machine/p.json"},
                                   {"sub_path": "machine/t.json"}, {"sub_path": "machine/x.json"}]})"},
                    {"V/machine/p.json", R"({"type": "machine", "name": "p", "a": "p", "b": "p"})"},
                    {"V/machine/t.json", R"({"type": "machine", "name": "t", "b": "t", "c": "t"})"},
                    {"V/machine/x.json", R"({"type": "machine", "name": "x", "inherits": "p",
                                             "include": ["t"], "c": "x"})"}}),
             kPrinter, "x", "b", "t"},
        Case{"PrusaOwn", PrusaBundle(), kProcess, "0.20mm SPEED @A4", "perimeter_speed", "120"},
        Case{"PrusaLaterParent", PrusaBundle(), kProcess, "0.20mm SPEED @A4", "perimeters", "3"},
        Case{"PrusaFirstParent", PrusaBundle(), kProcess, "0.20mm SPEED @A4", "layer_height",
             "0.2"},
        Case{"PrusaOldName", PrusaBundle(), kProcess, "0.20mm FAST @A4", "perimeters", "3"},
        Case{"PrusaBase", PrusaBundle(), kProcess, "*fast*", "perimeters", "(no preset)"},
        Case{"PrusaTextAsItIs", PrusaBundle(), kFilament, "Acme PLA", "start_filament_gcode",
             R"("M900 K0.05")"},
        Case{"PrusaEscapedQuotes",
             Files({{"a.ini",
                     "[printer:P]\nstart_gcode = M117 \\\"a\\\"\\n\\\\\n[vendor]\nname = a\n"}}),
             kPrinter, "P", "start_gcode", R"(M117 "a"\n\\)"},
        Case{"PrusaTemplate",
             Files({{"Templates.ini",
                     "[vendor]\nname = Templates\ntemplates_profile = 1\n[filament:*PLA*]\n"
                     "temperature = 215\n[filament:A]\ninherits = *PLA*\n[filament:B]\n"
                     "inherits = A\n"}}),
             kFilament, "B @Template", "temperature", "215"},
        Case{"PrusaUserPreset",
             Files({{"d/print/My 0.2.ini", "inherits = Gone\nperimeters = 5\n"}}), kProcess,
             "My 0.2", "perimeters", "5"},
        Case{"FlatIni", Files({{"config.ini", "printer_settings_id = P\nperimeters = 5\n"}}),
             kPrinter, "P", "perimeters", "5"},
        Case{"FlatIniWithoutName", Files({{"mine.ini", "perimeters = 5\n"}}), kProcess, "mine",
             "perimeters", "5"}),
    [](const auto& info) { return info.param.name; });

struct ProblemCase {
  std::string name;
  std::string path;
  std::string text;
  std::string problem;
};

class ProblemTest : public testing::TestWithParam<ProblemCase> {};

TEST_P(ProblemTest, SparesTheRest) {
  std::vector<PresetFile> files = OrcaFolder();
  files.push_back({GetParam().path, GetParam().text});
  const auto set = ReadPresets(files);
  ASSERT_TRUE(set.ok()) << set.status();
  ASSERT_EQ(set->problems().size(), 1U);
  EXPECT_THAT(set->problems().front(), testing::StartsWith(GetParam().path));
  EXPECT_THAT(set->problems().front(), testing::HasSubstr(GetParam().problem));
  EXPECT_EQ(ValueIn(*set, kProcess, "Fast", "wall_loops"), "4");
}

INSTANTIATE_TEST_SUITE_P(
    Presets, ProblemTest,
    testing::Values(ProblemCase{"CutOff", "x.json", R"({"a": "1)", "parse error"},
                    ProblemCase{"NotUtf8", "x.json", "{\"a\": \"\xff\"}", "parse error"},
                    ProblemCase{"List", "x.json", "[]", "it is a list"},
                    ProblemCase{"Text", "x.json", R"("a")", "not an object"},
                    ProblemCase{"Number", "x.json", "7", "not an object"},
                    ProblemCase{"Deep", "x.json", std::string(100'000, '['), "it is a list"},
                    ProblemCase{"NumberAsValue", "process/x.json", R"({"layer_height": 0.2})",
                                "layer_height is neither a text nor a list of texts"},
                    ProblemCase{"MixedList", "process/x.json", R"({"layer_height": ["0.2", 0.3]})",
                                "layer_height is neither"},
                    ProblemCase{"Object", "process/x.json", R"({"layer_height": {"a": "b"}})",
                                "layer_height is neither"},
                    ProblemCase{"ListOfLists", "process/x.json", R"({"layer_height": [["0.2"]]})",
                                "layer_height is neither"},
                    ProblemCase{"IndexOfNumbers", "x.json", R"({"machine_list": [1]})", "sub_path"},
                    ProblemCase{"IndexWithoutPath", "x.json",
                                R"({"machine_list": [{"name": "a"}]})", "sub_path"},
                    ProblemCase{"NoKey", "x.ini", "[print:a]\nfoo\n",
                                "line 2: 'foo' is not of the form key = value"},
                    ProblemCase{"SectionTwice", "x.ini", "[print:a]\n[print:a]\n", "line 2"},
                    ProblemCase{"KeyTwice", "x.ini", "[print:a]\na = 1\na = 2\n", "line 3"},
                    ProblemCase{"OpenSection", "x.ini", "[print:a\n", "line 1"},
                    ProblemCase{"Binary", "x.ini", std::string("a\0b", 3), "is not text"},
                    ProblemCase{"CutOffArchive", "x.bbscfg", "PK\x03\x04garbage", "archive"}),
    [](const auto& info) { return info.param.name; });

TEST(ReadPresetsErrorTest, NothingFound) {
  const auto set = ReadPresets(Files({{"a.json", "{}"}, {"b.ini", ""}}));
  EXPECT_EQ(DetailOf(set.status()).reason, Reason::kSettingMalformed);
}

TEST(ReadPresetsErrorTest, VendorListNamesAMissingFile) {
  std::vector<PresetFile> files = OrcaFolder();
  std::erase_if(files, [](const PresetFile& file) { return file.path.ends_with("p30.json"); });
  const auto set = ReadPresets(files);
  ASSERT_TRUE(set.ok()) << set.status();
  ASSERT_EQ(set->problems().size(), 1U);
  EXPECT_THAT(set->problems().front(), testing::HasSubstr("p30.json"));
}

/// Returns a ZIP archive of files.
std::string Zipped(const std::vector<PresetFile>& files) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(target);
  zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  for (const PresetFile& file : files)
    zip_file_add(archive, file.path.c_str(),
                 zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0), 0);
  zip_close(archive);
  zip_stat_t stat;
  zip_source_stat(target, &stat);
  std::string bytes(stat.size, '\0');
  zip_source_open(target);
  zip_source_read(target, bytes.data(), bytes.size());
  zip_source_close(target);
  zip_source_free(target);
  return bytes;
}

TEST(ArchiveTest, IsReadLikeAFolder) {
  const std::string archive = Zipped(
      Files({{"bundle_structure.json", R"({"version": "1", "printer_config": ["printer/P.json"]})"},
             {"printer/P.json", R"({"name": "P", "printer_settings_id": "P", "a": "1"})"}}));
  const auto set = ReadPresets(Files({{"mine.orca_printer", archive}}));
  ASSERT_TRUE(set.ok()) << set.status();
  EXPECT_TRUE(set->problems().empty());
  EXPECT_EQ(ValueIn(*set, kPrinter, "P", "a"), "1");
  EXPECT_EQ(Only(*set, kPrinter, "P")->file, "mine.orca_printer/printer/P.json");
}

TEST(ArchiveTest, BombIsRefusedUnexpanded) {
  const std::string archive = Zipped(Files({{"a.json", std::string(12 << 20, ' ')}}));
  EXPECT_LT(archive.size(), 100'000U);
  const auto files = UnpackArchive({"x.bbscfg", archive});
  EXPECT_EQ(DetailOf(files.status()).reason, Reason::kRequestTooLarge);
}

TEST(ArchiveTest, TooManyFilesAreRefused) {
  std::vector<PresetFile> many;
  for (int64_t i = 0; i <= kMaxPresetFiles; ++i)
    many.push_back({std::to_string(i) + ".json", "{}"});
  const auto files = UnpackArchive({"x.bbscfg", Zipped(many)});
  EXPECT_EQ(DetailOf(files.status()).reason, Reason::kRequestTooLarge);
}

TEST(ArchiveTest, PacksFilesThatAreUnpackedAgain) {
  const std::vector<PresetFile> files = Files(
      {{"V.json", R"({"machine_list": []})"}, {"V/machine/\xc3\xa4.json", "{}"}, {"e.ini", ""}});
  const auto packed = PackArchive(files);
  ASSERT_TRUE(packed.ok()) << packed.status();
  EXPECT_EQ(*PackArchive(files), *packed);
  const auto unpacked = UnpackArchive({"a.zip", *packed});
  ASSERT_TRUE(unpacked.ok()) << unpacked.status();
  ASSERT_EQ(unpacked->size(), files.size());
  for (size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ((*unpacked)[i].path, "a.zip/" + files[i].path);
    EXPECT_EQ((*unpacked)[i].bytes, files[i].bytes);
  }
  EXPECT_EQ(DetailOf(UnpackArchive({"a.zip", *packed}, 10).status()).reason,
            Reason::kRequestTooLarge);
}

TEST(ArchiveTest, DamagedFileIsRefused) {
  std::string archive = Zipped(Files({{"a.json", R"({"name": "P", "a": "one two three"})"}}));
  archive[45] ^= 0x55;
  const auto files = UnpackArchive({"x.bbscfg", archive});
  EXPECT_EQ(DetailOf(files.status()).reason, Reason::kSettingMalformed);
}

}  // namespace
}  // namespace slicefarm::config::presets::read_presets_test
