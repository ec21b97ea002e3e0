#include "services/coordinator/server/messages/job_request.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/model/limits.h"

namespace slicefarm::coordinator::job_request_test {
namespace {

JobRequest SimpleRequest() {
  JobRequest request;
  request.scene.meshes = {{Sha256Hex("mesh"), "part.stl", MeshFormat::kUnknown}};
  request.scene.objects = {ObjectOfFile("part.stl", 0, {}, 1)};
  return request;
}

SceneObject& FirstOf(JobRequest& request) { return request.scene.objects[0]; }

struct Case {
  std::string name;
  std::function<void(JobRequest&)> change;
};

class ActionDigestTest : public testing::TestWithParam<Case> {};

TEST_P(ActionDigestTest, DependsOnThis) {
  JobRequest request = SimpleRequest();
  const auto before = ResolveJob(request, "build", "");
  GetParam().change(request);
  const auto after = ResolveJob(request, "build", "");
  ASSERT_TRUE(before.ok() && after.ok()) << after.status();
  EXPECT_NE(before->action_digest, after->action_digest);
}

INSTANTIATE_TEST_SUITE_P(
    All, ActionDigestTest,
    testing::Values(
        Case{"Mesh", [](auto& r) { r.scene.meshes[0].sha256 = Sha256Hex("other"); }},
        Case{"NameOfTheMesh", [](auto& r) { r.scene.meshes[0].name = "other.stl"; }},
        Case{"Format", [](auto& r) { r.scene.meshes[0].format = MeshFormat::kObj; }},
        Case{"Name", [](auto& r) { FirstOf(r).name = "other.stl"; }},
        Case{"NameOfAPart", [](auto& r) { FirstOf(r).parts[0].name = "other.stl"; }},
        Case{"WhichMesh", [](auto& r) { FirstOf(r).parts[0].mesh.mesh = 1; }},
        Case{"FirstTriangle", [](auto& r) { FirstOf(r).parts[0].mesh.first_triangle = 1; }},
        Case{"TriangleCount", [](auto& r) { FirstOf(r).parts[0].mesh.triangle_count = 1; }},
        Case{"Role", [](auto& r) { FirstOf(r).parts[0].role = PartRole::kNegative; }},
        Case{"PlaceInTheObject", [](auto& r) { FirstOf(r).parts[0].to_object(2, 3) = 1e-9; }},
        Case{"Scale", [](auto& r) { FirstOf(r).instances[0].to_plate(2, 2) = 1 + 1e-15; }},
        Case{"Placed", [](auto& r) { FirstOf(r).instances[0].placed = true; }},
        Case{"ByOrigin", [](auto& r) { FirstOf(r).instances[0].by_middle = false; }},
        Case{"WarningOfTheProject", [](auto& r) { r.warnings = {"painted"}; }},
        Case{"MissingFeature",
             [](auto& r) {
               r.missing = {{"painted_filaments", "painted", {}}};
             }},
        Case{"SourceOfASetting",
             [](auto& r) {
               FirstOf(r).settings = {{"perimeters", "3", config::Source::kProfile}};
             }},
        Case{"SettingOfARange",
             [](auto& r) {
               FirstOf(r).ranges = {{1, 2, {{"layer_height", "0.1"}}}};
             }},
        Case{"KindOfACalibration", [](auto& r) { r.calibration.kind = "flow"; }},
        Case{"ValueOfACalibration", [](auto& r) { r.calibration.rows.resize(1); }},
        Case{"Copies", [](auto& r) { FirstOf(r).instances.resize(2); }},
        Case{"HeightRange",
             [](auto& r) {
               FirstOf(r).ranges.push_back({1, 2, {}});
             }},
        Case{"SettingOfAnObject",
             [](auto& r) {
               FirstOf(r).settings.push_back({"fill_density", "35%"});
             }},
        Case{"SettingOfAPart",
             [](auto& r) {
               FirstOf(r).parts[0].settings.push_back({"fill_density", "35%"});
             }},
        Case{"Objects", [](auto& r) { r.scene.objects.push_back(FirstOf(r)); }},
        Case{"WhatTheClientSaysHasNoEffect", [](auto& r) { r.without_effect = {"painted seams"}; }},
        Case{"Setting",
             [](auto& r) {
               r.settings.push_back({"layer_height", "0.15"});
             }},
        Case{"WhatHasNoEffect",
             [](auto& r) {
               r.settings.push_back({"nonsense", "1", config::Source::kProfile});
             }}),
    [](const auto& info) { return info.param.name; });

TEST(ResolveJob, TheBuildIsPartOfTheAction) {
  EXPECT_NE(ResolveJob(SimpleRequest(), "a", "")->action_digest,
            ResolveJob(SimpleRequest(), "b", "")->action_digest);
  EXPECT_NE(ResolveJob(SimpleRequest(), "a", "")->action_digest,
            ResolveJob(SimpleRequest(), "a", "acme")->action_digest);
}

TEST(ResolveJob, SettingsSaidInAnotherWayAreTheSame) {
  JobRequest other = SimpleRequest();
  other.settings = {{"perimeters", " 3 "}};
  const JobRequest plain = SimpleRequest();  // 3 is the standard
  EXPECT_EQ(ResolveJob(other, "b", "")->action_digest, ResolveJob(plain, "b", "")->action_digest);
}

TEST(CheckRequest, CountsCopies) {
  JobRequest request = SimpleRequest();
  FirstOf(request).instances.resize(limits::kMaxObjects);
  EXPECT_TRUE(CheckRequest(request).ok());
  request.scene.objects.push_back(FirstOf(request));
  request.scene.objects[1].instances.resize(1);
  const absl::Status status = CheckRequest(request);
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge);
  EXPECT_EQ(DetailOf(status).metadata.at("limit"), "1000");
  EXPECT_EQ(DetailOf(status).metadata.at("got"), "1001");
}

TEST(CheckRequest, WantsAnObject) {
  EXPECT_EQ(DetailOf(CheckRequest({})).metadata.at("field"), "objects");
}

TEST(ResolveJob, ReportsWhatTheClientSaysHasNoEffect) {
  JobRequest request = SimpleRequest();
  request.without_effect = {"painted seams"};
  EXPECT_EQ(ResolveJob(request, "b", "")->plate.no_effect.front().text, "painted seams");
}

TEST(ResolveJob, SettingsOfTheJobAreRefusedForAnObject) {
  JobRequest request = SimpleRequest();
  FirstOf(request).settings = {{"temperature", "210"}};
  const absl::Status status = ResolveJob(request, "b", "").status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kSettingMisplaced);
  EXPECT_EQ(DetailOf(status).metadata.at("object"), "part.stl");
  EXPECT_EQ(DetailOf(status).metadata.at("setting"), "temperature");
}

std::vector<std::string> HostileTexts() {
  return {"a\nb",     "a\rb",        "a\tb",       "\x7f", std::string("a\0b", 3),
          "a\x1b[2J", "a\u0085M112", "a\u2028M112"};
}

TEST(CheckRequest, NamesStayOnTheirLine) {
  for (const std::string& name : HostileTexts()) {
    JobRequest request = SimpleRequest();
    FirstOf(request).name = name;
    const absl::Status status = CheckRequest(request);
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
    EXPECT_EQ(DetailOf(status).metadata.at("field"), "objects[0].name");
    request = SimpleRequest();
    FirstOf(request).parts[0].name = name;
    EXPECT_EQ(DetailOf(CheckRequest(request)).metadata.at("field"), "objects[0].parts[0].name");
    request = SimpleRequest();
    request.without_effect = {name};
    EXPECT_EQ(DetailOf(CheckRequest(request)).metadata.at("field"), "without_effect");
    request = SimpleRequest();
    request.calibration.rows = {{name, 1, 0, 0, "part"}};
    EXPECT_EQ(DetailOf(CheckRequest(request)).metadata.at("field"), "calibration");
  }
}

TEST(CheckRequest, CalibrationsAreFiniteAndLimited) {
  JobRequest request = SimpleRequest();
  request.calibration.rows.resize(1000);
  EXPECT_TRUE(CheckRequest(request).ok());
  request.calibration.rows.back().to_mm = NAN;
  EXPECT_EQ(DetailOf(CheckRequest(request)).metadata.at("field"), "calibration");
  request.calibration.rows.resize(1001);
  EXPECT_EQ(DetailOf(CheckRequest(request)).reason, Reason::kRequestTooLarge);
}

TEST(CheckLabels, HaveBounds) {
  EXPECT_TRUE(CheckLabels({{"order", "17"}}).ok());
  EXPECT_FALSE(CheckLabels({{"order", std::string(2000, 'x')}}).ok());
  std::map<std::string, std::string> many;
  for (int i = 0; i < 65; ++i) many[std::to_string(i)] = "";
  EXPECT_FALSE(CheckLabels(many).ok());
}

TEST(CheckLabels, AndRequestIdsHaveNoControlCharacters) {
  for (const std::string& text : HostileTexts()) {
    for (const absl::Status& status :
         {CheckLabels({{text, "x"}}), CheckLabels({{"x", text}}), CheckRequestId(text)}) {
      EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
    }
  }
  EXPECT_TRUE(CheckRequestId("../../etc/passwd; DROP TABLE jobs").ok());  // goes nowhere
}

}  // namespace
}  // namespace slicefarm::coordinator::job_request_test
