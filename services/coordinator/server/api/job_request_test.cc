#include "services/coordinator/server/api/job_request.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/base/sha256.h"

namespace slicefarm::coordinator {
namespace {

JobRequest SimpleRequest() {
  JobRequest request;
  request.objects.resize(1);
  request.objects[0].mesh_sha256 = Sha256Hex("mesh");
  request.objects[0].name = "part.stl";
  return request;
}

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
    testing::Values(Case{"Mesh", [](auto& r) { r.objects[0].mesh_sha256 = Sha256Hex("other"); }},
                    Case{"Name", [](auto& r) { r.objects[0].name = "other.stl"; }},
                    Case{"Format", [](auto& r) { r.objects[0].format = MeshFormat::kObj; }},
                    Case{"Unit", [](auto& r) { r.objects[0].placement.unit_mm = 25.4; }},
                    Case{"Scale", [](auto& r) { r.objects[0].placement.scale[2] = 1 + 1e-15; }},
                    Case{"Rotation", [](auto& r) { r.objects[0].placement.rotate_deg[1] = 1; }},
                    Case{"Centers",
                         [](auto& r) {
                           r.objects[0].placement.centers = {{1, 2}};
                         }},
                    Case{"Copies", [](auto& r) { r.objects[0].copies = 2; }},
                    Case{"SettingOfAnObject",
                         [](auto& r) {
                           r.objects[0].settings.push_back({"fill_density", "35%"});
                         }},
                    Case{"Objects", [](auto& r) { r.objects.push_back(r.objects[0]); }},
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
  request.objects[0].placement.centers.resize(limits::kMaxObjects);
  EXPECT_TRUE(CheckRequest(request).ok());
  request.objects.push_back(SimpleRequest().objects[0]);
  const absl::Status status = CheckRequest(request);
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge);
  EXPECT_EQ(DetailOf(status).metadata.at("limit"), "1000");
  EXPECT_EQ(DetailOf(status).metadata.at("got"), "1001");
}

TEST(CheckRequest, CountsCopiesWithoutCenters) {
  JobRequest request = SimpleRequest();
  request.objects[0].copies = limits::kMaxObjects;
  EXPECT_TRUE(CheckRequest(request).ok());
  request.objects.push_back(SimpleRequest().objects[0]);
  EXPECT_EQ(DetailOf(CheckRequest(request)).metadata.at("got"), "1001");
  request = SimpleRequest();
  request.objects[0].copies = -1;
  EXPECT_EQ(DetailOf(CheckRequest(request)).metadata.at("field"), "objects[0].copies");
}

TEST(ResolveJob, AMeshIsTakenOnceForAllItsObjects) {
  JobRequest request = SimpleRequest();
  request.objects.resize(3, request.objects[0]);
  request.objects[1].mesh_sha256 = Sha256Hex("other");
  request.objects[2].settings = {{"fill_density", "35%"}};
  const auto job = ResolveJob(request, "b", "");
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_EQ(job->meshes.size(), 2);
  EXPECT_EQ(job->meshes[1].sha256, Sha256Hex("other"));
  ASSERT_EQ(job->plate.objects.size(), 3);
  EXPECT_EQ(job->plate.objects[1].parts.at(0).mesh.file, 1);
  EXPECT_EQ(job->plate.objects[2].parts.at(0).mesh.file, 0);
}

TEST(ResolveJob, SettingsOfTheJobAreRefusedForAnObject) {
  JobRequest request = SimpleRequest();
  request.objects[0].settings = {{"temperature", "210"}};
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
    request.objects[0].name = name;
    const absl::Status status = CheckRequest(request);
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
    EXPECT_EQ(DetailOf(status).metadata.at("field"), "objects[0].name");
  }
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
}  // namespace slicefarm::coordinator
