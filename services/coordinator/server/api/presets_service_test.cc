// Tests of presets that the farm stores, over a socket.
#include "services/coordinator/server/api/presets_service.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "nlohmann/json.hpp"
#include "services/coordinator/server/api/preset_settings.h"
#include "services/coordinator/server/main/coordinator_fixture_test.h"

namespace slicefarm::coordinator::presets_service_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

Reason WhyNot(const absl::Status& status) { return DetailOf(status).reason; }

/// Returns a vendor's bundle with this number of walls.
std::string BundleText(int walls) {
  return absl::StrCat(
      "[vendor]\nname = Acme\n[printer_model:A]\nname = Acme A\n"
      "[print:*base*]\nfill_density = 11%\n[print:0.25mm FAST @A]\ninherits = *base*\n"
      "layer_height = 0.25\nperimeters = ",
      walls,
      "\n[filament:PLA @A]\ntemperature = 207\n[filament:ABS @A]\ntemperature = 250\n"
      "[printer:Acme A]\nprinter_model = A\nnozzle_diameter = 0.4\ngcode_flavor = marlin2\n"
      "bed_shape = 0x0,90x0,90x90,0x90\ndefault_print_profile = 0.25mm FAST @A\n"
      "default_filament_profile = PLA @A\n");
}

class PresetsServiceTest : public CoordinatorTest {
 protected:
  template <typename Request, typename Response>
  absl::StatusOr<Response> Call(grpc::Status (v1::Presets::Stub::*call)(grpc::ClientContext*,
                                                                        const Request&, Response*),
                                const Request& request) {
    grpc::ClientContext context;
    Response response;
    const absl::Status status = rpc::FromGrpc(((*presets_).*call)(&context, request, &response));
    if (!status.ok()) return status;
    return response;
  }

  absl::StatusOr<v1::PresetBundle> Import(const std::string& name, const std::string& path,
                                          const std::string& content) {
    v1::ImportPresetsRequest request;
    request.set_name(name);
    v1::PresetFile* file = request.add_files();
    file->set_path(path);
    file->set_content(content);
    return Call(&v1::Presets::Stub::ImportPresets, request);
  }

  /// Creates a job for the printer, with more bundles or presets if `names` has them.
  absl::StatusOr<v1::Job> Make(const v1::JobPresets& names, const std::string& profile = "") {
    EXPECT_TRUE(Upload("xxx").ok());
    v1::CreateJobRequest request = RequestFor("xxx");
    request.mutable_spec()->set_generic(false);
    *request.mutable_spec()->mutable_presets() = names;
    if (!profile.empty()) request.mutable_spec()->add_profiles(profile);
    return Create(request);
  }

  /// Stores a revision of a profile with one setting.
  void PutProfile(const std::string& name, const std::string& key, const std::string& value) {
    v1::PutProfileRequest put;
    put.set_name(name);
    v1::Setting* setting = put.add_settings();
    setting->set_key(key);
    setting->set_value(value);
    grpc::ClientContext context;
    v1::Profile profile;
    EXPECT_TRUE(profiles_->PutProfile(&context, put, &profile).ok());
  }

  static v1::JobPresets Printer(const std::string& name, const std::string& bundle = "") {
    v1::JobPresets names;
    names.set_printer(name);
    if (!bundle.empty()) names.add_bundles(bundle);
    return names;
  }

  static std::string ValueOf(const v1::Job& job, std::string_view key) {
    std::string value = "(none)";
    for (const v1::Setting& setting : job.spec().settings())
      if (setting.key() == key) value = setting.value();
    return value;
  }

  static std::string SourceOf(const v1::Job& job, std::string_view key) {
    for (const v1::SettingSource& source : job.spec().setting_sources())
      for (const std::string& each : source.keys())
        if (each == key) return source.source();
    return "(none)";
  }
};

TEST_F(PresetsServiceTest, AJobNamesItsPresets) {
  const auto bundle = Import("acme", "Acme.ini", BundleText(3));
  ASSERT_TRUE(bundle.ok()) << bundle.status();
  EXPECT_EQ(bundle->revision(), 1);
  EXPECT_EQ(bundle->presets(), 4);
  EXPECT_THAT(bundle->problems(), testing::IsEmpty());
  const auto job = Make(Printer("Acme A"));
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(ValueOf(*job, "perimeters"), "3");
  EXPECT_EQ(ValueOf(*job, "bed_shape"), "0x0,90x0,90x90,0x90");
  EXPECT_EQ(job->spec().presets().process(), "0.25mm FAST @A");
  EXPECT_EQ(job->spec().presets().filament(), "PLA @A");
  EXPECT_THAT(job->spec().presets().bundles(), ElementsAre("acme@1"));
  EXPECT_EQ(AwaitEnd(job->id()).state(), v1::JOB_STATE_SUCCEEDED);
}

TEST_F(PresetsServiceTest, AnUpdateLeavesOlderRevisionsAsTheyAre) {
  ASSERT_TRUE(Import("acme", "Acme.ini", BundleText(3)).ok());
  const auto first = Make(Printer("Acme A"));
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_EQ(Import("acme", "Acme.ini", BundleText(3))->revision(), 1) << "the same files";
  ASSERT_EQ(Import("acme", "Acme.ini", BundleText(5))->revision(), 2);
  EXPECT_EQ(ValueOf(*Make(Printer("Acme A")), "perimeters"), "5");
  EXPECT_EQ(ValueOf(*Make(Printer("Acme A", "acme@1")), "perimeters"), "3");
  EXPECT_EQ(ValueOf(*Get(first->id()), "perimeters"), "3");
  EXPECT_THAT(Get(first->id())->spec().presets().bundles(), ElementsAre("acme@1"));
}

TEST_F(PresetsServiceTest, PresetsInheritFromOtherBundles) {
  ASSERT_TRUE(
      Import("mine", "process/Mine.json",
             R"({"name": "Mine", "from": "User", "inherits": "0.2 @One", "wall_loops": "6"})")
          .ok());
  EXPECT_EQ(WhyNot(Make(Printer("One")).status()), Reason::kProfileNotFound);
  v1::ImportPresetsRequest vendor;
  vendor.set_name("vendor");
  for (const auto& [path, text] : std::vector<std::pair<std::string, std::string>>{
           {"V.json", R"({"machine_list": [{"sub_path": "machine/o.json"}],
                          "process_list": [{"sub_path": "process/p.json"}],
                          "filament_list": [{"sub_path": "filament/f.json"}]})"},
           {"V/machine/o.json", R"({"type": "machine", "name": "One", "instantiation": "true",
                                    "nozzle_diameter": ["0.4"], "gcode_flavor": "klipper",
                                    "printable_area": ["0x0", "99x0", "99x99", "0x99"]})"},
           {"V/process/p.json", R"({"type": "process", "name": "0.2 @One",
                                    "instantiation": "true", "layer_height": "0.2"})"},
           {"V/filament/f.json", R"({"type": "filament", "name": "PLA @One",
                                     "instantiation": "true", "filament_type": ["PLA"]})"}}) {
    v1::PresetFile* file = vendor.add_files();
    file->set_path(path);
    file->set_content(text);
  }
  ASSERT_TRUE(Call(&v1::Presets::Stub::ImportPresets, vendor).ok());
  v1::JobPresets names = Printer("One");
  names.set_process("Mine");
  names.set_filament("PLA");
  const auto job = Make(names);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(ValueOf(*job, "perimeters"), "6");
  EXPECT_EQ(ValueOf(*job, "layer_height"), "0.2");
  EXPECT_THAT(SourceOf(*job, "perimeters"), HasSubstr(R"("Mine" (mine@1/process/Mine.json))"));
}

TEST_F(PresetsServiceTest, TheReportTellsTheSourceOfEachSetting) {
  ASSERT_TRUE(Import("acme", "Acme.ini", BundleText(3)).ok());
  PutProfile("acme-07", "extrusion_multiplier", "0.97");
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  *request.mutable_spec()->mutable_presets() = Printer("Acme A");
  request.mutable_spec()->add_profiles("acme-07");
  v1::Setting* own = request.mutable_spec()->add_settings();
  own->set_key("temperature");
  own->set_value("201");
  const auto job = Create(request);
  ASSERT_TRUE(job.ok()) << job.status();
  const std::vector<std::pair<std::string, std::string>> sources = {
      {"temperature", "job"},
      {"extrusion_multiplier", "profile acme-07@1"},
      {"perimeters", R"(process preset "0.25mm FAST @A" (acme@1/Acme.ini))"},
      {"fill_density", R"(process preset "*base*" (acme@1/Acme.ini))"},
      {"bed_shape", R"(printer preset "Acme A" (acme@1/Acme.ini))"}};
  for (const auto& [key, source] : sources) EXPECT_EQ(SourceOf(*job, key), source) << key;
  ASSERT_EQ(AwaitEnd(job->id()).state(), v1::JOB_STATE_SUCCEEDED);
  const auto report = nlohmann::json::parse(*Download(job->id(), v1::ARTIFACT_REPORT));
  std::map<std::string, std::string> reported;
  for (const auto& each : report["setting_sources"])
    for (const auto& key : each["keys"]) reported[key] = each["source"];
  for (const auto& [key, source] : sources) EXPECT_EQ(reported[key], source) << key;
}

TEST_F(PresetsServiceTest, AJobGetsTheOverlaysOfItsPrinter) {
  ASSERT_TRUE(Import("acme", "Acme.ini", BundleText(3)).ok());
  PutProfile("mine", "perimeters", "5");
  EXPECT_THAT(Make(Printer("Acme A"), "mine")->spec().profiles(), ElementsAre("mine@1"));
  PutProfile("overlay.Acme_A", "perimeters", "7");
  PutProfile("overlay.Acme_A", "fill_density", "33%");
  PutProfile("overlay.Acme_A__with__PLA__20_40A", "perimeters", "8");  // another filament
  PutProfile("overlay.Acme_A__with__PLA___40A", "temperature", "199");
  const auto first = Make(Printer("Acme A"), "mine");
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_THAT(first->spec().profiles(),
              ElementsAre("overlay.Acme_A@2", "overlay.Acme_A__with__PLA___40A@1", "mine@1"));
  EXPECT_EQ(ValueOf(*first, "fill_density"), "33%");
  EXPECT_EQ(SourceOf(*first, "fill_density"), "profile overlay.Acme_A@2");
  EXPECT_EQ(ValueOf(*first, "temperature"), "199");
  EXPECT_EQ(ValueOf(*first, "perimeters"), "5") << "the profile that the job names wins";

  v1::JobPresets abs = Printer("Acme A");
  abs.set_filament("ABS");
  EXPECT_EQ(ValueOf(*Make(abs), "temperature"), "250");

  PutProfile("overlay.Acme_A", "fill_density", "44%");
  EXPECT_EQ(ValueOf(*Make(Printer("Acme A")), "fill_density"), "44%");
  EXPECT_EQ(ValueOf(*Make(Printer("Acme A"), "overlay.Acme_A@2"), "fill_density"), "33%");
  EXPECT_EQ(ValueOf(*Get(first->id()), "fill_density"), "33%");
}

TEST_F(PresetsServiceTest, JobsWithoutPresetsTellNoSources) {
  const v1::Job job = AwaitEnd(Submit("xxx"));
  EXPECT_EQ(job.spec().setting_sources_size(), 0);
  EXPECT_FALSE(
      nlohmann::json::parse(*Download(job.id(), v1::ARTIFACT_REPORT)).contains("setting_sources"));
}

TEST_F(PresetsServiceTest, ListsAndResolvesByName) {
  ASSERT_TRUE(Import("acme", "Acme.ini", BundleText(3)).ok());
  v1::ListPresetsRequest list;
  list.set_page_size(3);
  std::vector<std::string> names;
  do {
    const auto page = Call(&v1::Presets::Stub::ListPresets, list);
    ASSERT_TRUE(page.ok()) << page.status();
    for (const v1::PresetName& each : page->presets())
      names.push_back(absl::StrCat(each.kind(), " ", each.name(), " ", each.file()));
    list.set_page_token(page->next_page_token());
  } while (!list.page_token().empty());
  EXPECT_THAT(names, ElementsAre("1 Acme A acme@1/Acme.ini", "2 0.25mm FAST @A acme@1/Acme.ini",
                                 "3 ABS @A acme@1/Acme.ini", "3 PLA @A acme@1/Acme.ini"));
  v1::ResolvePresetsRequest resolve;
  *resolve.mutable_presets() = Printer("Acme A");
  resolve.mutable_presets()->set_filament("ABS");
  const auto resolved = Call(&v1::Presets::Stub::ResolvePresets, resolve);
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  EXPECT_EQ(resolved->presets().filament(), "ABS @A");
  std::map<std::string, std::string> values;
  for (const v1::ResolvedSetting& each : resolved->settings())
    values[each.key()] = each.value() + " " + each.preset();
  EXPECT_EQ(values["temperature"], "250 ABS @A");
  EXPECT_EQ(values["fill_density"], "11% *base*");
}

TEST_F(PresetsServiceTest, BundlesAreListedFetchedAndDeleted) {
  ASSERT_TRUE(Import("b", "Acme.ini", BundleText(1)).ok());
  ASSERT_TRUE(Import("a", "Acme.ini", BundleText(2)).ok());
  ASSERT_TRUE(Import("a", "Acme.ini", BundleText(3)).ok());
  const auto all = Call(&v1::Presets::Stub::ListPresetBundles, v1::ListPresetBundlesRequest());
  ASSERT_EQ(all->bundles_size(), 2);
  EXPECT_EQ(all->bundles(0).name(), "a");
  EXPECT_EQ(all->bundles(0).revision(), 2);
  EXPECT_EQ(all->bundles(0).files_size(), 0);
  v1::GetPresetBundleRequest get;
  get.set_name("a");
  get.set_revision(1);
  EXPECT_EQ(Call(&v1::Presets::Stub::GetPresetBundle, get)->files(0).content(), BundleText(2));
  ASSERT_TRUE(Make(Printer("Acme A", "a@1")).ok());
  v1::DeletePresetBundleRequest remove;
  remove.set_name("a");
  remove.set_revision(1);
  ASSERT_TRUE(Call(&v1::Presets::Stub::DeletePresetBundle, remove).ok());
  EXPECT_EQ(WhyNot(Call(&v1::Presets::Stub::GetPresetBundle, get).status()),
            Reason::kProfileNotFound);
  const absl::Status gone = Make(Printer("Acme A", "a@1")).status();
  EXPECT_EQ(WhyNot(gone), Reason::kProfileNotFound);
  EXPECT_TRUE(absl::IsFailedPrecondition(gone)) << gone;
}

struct WrongCase {
  std::string name;
  v1::JobPresets presets;
  Reason reason;
  std::string message;
};

TEST_F(PresetsServiceTest, RefusesWhatIsNotThere) {
  EXPECT_EQ(WhyNot(Make(Printer("Acme A")).status()), Reason::kProfileNotFound) << "no bundles yet";
  ASSERT_TRUE(Import("acme", "Acme.ini", BundleText(3)).ok());
  v1::JobPresets process = Printer("Acme A");
  process.set_process("0.25mm FASST");
  const std::vector<WrongCase> cases = {
      {"Printer", Printer("Acme B"), Reason::kProfileNotFound, "do you mean \"Acme A\"?"},
      {"Process", process, Reason::kProfileNotFound, "do you mean \"0.25mm FAST\"?"},
      {"Bundle", Printer("Acme A", "other"), Reason::kProfileNotFound, "other"},
      {"Revision", Printer("Acme A", "acme@7"), Reason::kProfileNotFound, "acme@7"},
      {"Reference", Printer("Acme A", "acme@x"), Reason::kRequestMalformed, "revision"}};
  for (const WrongCase& each : cases) {
    const absl::Status status = Make(each.presets).status();
    EXPECT_EQ(WhyNot(status), each.reason) << each.name << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr(each.message)) << each.name;
  }
  v1::CreateJobRequest laser = RequestFor("xxx");
  laser.mutable_spec()->set_process(v1::PROCESS_LASER);
  *laser.mutable_spec()->mutable_presets() = Printer("Acme A");
  EXPECT_EQ(WhyNot(Create(laser).status()), Reason::kRequestMalformed);
}

TEST_F(PresetsServiceTest, RefusesFilesWithoutPresets) {
  EXPECT_EQ(WhyNot(Import("a", "a.json", "{").status()), Reason::kSettingMalformed);
  EXPECT_EQ(WhyNot(Import("a", "a.ini", "[print:\xff]\nx = 1\n").status()),
            Reason::kSettingMalformed);
  EXPECT_EQ(WhyNot(Import("a", "a.zip", "PK\x03\x04 broken").status()), Reason::kSettingMalformed);
  EXPECT_EQ(WhyNot(Import("../a", "a.ini", BundleText(1)).status()), Reason::kRequestMalformed);
  EXPECT_EQ(WhyNot(Import("a", "a\n.ini", BundleText(1)).status()), Reason::kRequestMalformed);
  EXPECT_EQ(WhyNot(Import("a", "", BundleText(1)).status()), Reason::kRequestMalformed);
  EXPECT_EQ(
      Call(&v1::Presets::Stub::ListPresetBundles, v1::ListPresetBundlesRequest())->bundles_size(),
      0);
}

TEST_F(PresetsServiceTest, SurvivesARestart) {
  ASSERT_TRUE(Import("acme", "Acme.ini", BundleText(3)).ok());
  Close();
  Open();
  EXPECT_EQ(ValueOf(*Make(Printer("Acme A")), "perimeters"), "3");
}

}  // namespace
}  // namespace slicefarm::coordinator::presets_service_test
