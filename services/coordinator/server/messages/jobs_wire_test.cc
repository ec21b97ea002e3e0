#include "services/coordinator/server/messages/jobs_wire.h"

#include <gtest/gtest.h>

#include <functional>

#include "common/base/error.h"
#include "common/base/sha256.h"

namespace slicefarm::coordinator::jobs_wire_test {
namespace {

v1::JobSpec SpecOfTwo() {
  v1::JobSpec spec;
  for (const char* name : {"a.stl", "b.obj"}) {
    v1::Object* object = spec.add_objects();
    object->set_mesh_sha256(Sha256Hex(name));
    object->set_name(name);
  }
  spec.mutable_objects(1)->set_format(v1::MESH_FORMAT_OBJ);
  spec.mutable_objects(1)->mutable_placement()->add_scale(2);
  spec.mutable_objects(1)->set_copies(4);
  v1::Setting* own = spec.mutable_objects(1)->add_settings();
  own->set_key("fill_density");
  own->set_value("35%");
  v1::Setting* setting = spec.add_settings();
  setting->set_key("perimeters");
  setting->set_value("2");
  setting = spec.add_settings();
  setting->set_key("raft_layers");
  setting->set_from_profile(true);
  return spec;
}

JobRecord DoneJob() {
  JobRecord job;
  job.number = 12;
  job.id = "j";
  job.state = JobState::kSucceeded;
  job.spec = SpecBytes(SpecOfTwo());
  job.labels = {{"order", "7"}};
  job.create_us = 1'500'000;
  job.end_us = 2'000'001;
  job.layers_total = job.layers_done = 9;
  job.result.emplace();
  job.result->gcode_sha256 = "g";
  job.result->gcode_size = 77;
  job.result->cached = true;
  job.result->warnings = {"careful"};
  return job;
}

TEST(JobsWire, ReadsASpec) {
  const auto request = ReadSpec(SpecBytes(SpecOfTwo()));
  ASSERT_TRUE(request.ok()) << request.status();
  ASSERT_EQ(request->scene.meshes.size(), 2u);
  EXPECT_EQ(request->scene.meshes[0].format, MeshFormat::kUnknown);
  EXPECT_EQ(request->scene.meshes[1].format, MeshFormat::kObj);
  const std::vector<SceneObject>& objects = request->scene.objects;
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].name, "a.stl");
  EXPECT_EQ(objects[1].parts.at(0).mesh.file, 1);
  EXPECT_EQ(objects[1].instances.at(0).to_plate(2, 2), 2);
  EXPECT_EQ(objects[0].instances.size(), 1u);
  EXPECT_EQ(objects[1].instances.size(), 4u);
  EXPECT_TRUE(objects[0].settings.empty());
  ASSERT_EQ(objects[1].settings.size(), 1u);
  EXPECT_EQ(objects[1].settings[0],
            (config::Setting{"fill_density", "35%", config::Source::kRequest}));
  ASSERT_EQ(request->settings.size(), 2u);
  EXPECT_EQ(request->settings[0], (config::Setting{"perimeters", "2", config::Source::kRequest}));
  EXPECT_EQ(request->settings[1].source, config::Source::kProfile);
}

TEST(JobsWire, SettingsOfAProjectComeFirst) {
  v1::JobSpec spec = SpecOfTwo();
  spec.add_project_settings()->set_key("fill_density");
  spec.add_without_effect("painted seams");
  const auto request = FromProto(spec);
  ASSERT_TRUE(request.ok()) << request.status();
  ASSERT_EQ(request->settings.size(), 3u);
  EXPECT_EQ(request->settings[0].key, "fill_density");
  EXPECT_EQ(request->without_effect, std::vector<std::string>{"painted seams"});
}

TEST(JobsWire, ErrorsSayWhere) {
  v1::JobSpec spec = SpecOfTwo();
  spec.mutable_objects(1)->mutable_placement()->set_scale(0, -1);
  const absl::Status status = FromProto(spec).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_NE(DetailOf(status).metadata.at("field").find("objects[1].placement"), std::string::npos);
}

TEST(JobsWire, DamagedSpecsAreErrors) { EXPECT_FALSE(ReadSpec("\xff\xff").ok()); }

TEST(JobsWire, WritesAJob) {
  const v1::Job job = ToProto(DoneJob());
  EXPECT_EQ(job.id(), "j");
  EXPECT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(job.spec().objects(1).name(), "b.obj");
  EXPECT_EQ(job.labels().at("order"), "7");
  EXPECT_EQ(job.create_time().seconds(), 1);
  EXPECT_EQ(job.create_time().nanos(), 500'000'000);
  EXPECT_FALSE(job.has_start_time());
  EXPECT_EQ(job.end_time().nanos(), 1'000);
  EXPECT_EQ(job.progress().layers_done(), 9);
  EXPECT_EQ(job.result().gcode_size(), 77);
  EXPECT_TRUE(job.result().cached());
  EXPECT_FALSE(job.has_error());
  EXPECT_EQ(job.warnings(0), "careful");
}

TEST(JobsWire, WritesAFailure) {
  JobRecord record = DoneJob();
  record.state = JobState::kFailed;
  record.result.reset();
  record.error = JobErrorOf(MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                                      "no triangle", {{"name", "a"}}));
  const v1::Job job = ToProto(record);
  EXPECT_EQ(job.error().code(), 3);
  EXPECT_EQ(job.error().reason(), "MESH_EMPTY");
  EXPECT_EQ(job.error().message(), "no triangle");
  EXPECT_EQ(job.error().metadata().at("name"), "a");
  EXPECT_FALSE(job.has_result());
}

TEST(JobsWire, AnEventIsTheJobAsOfThen) {
  const v1::JobEvent event =
      ToProto(JobEventRecord{3, 1'000'000, JobState::kRunning, 9, 4}, DoneJob());
  EXPECT_EQ(event.sequence(), 3);
  EXPECT_EQ(event.job().state(), v1::JOB_STATE_RUNNING);
  EXPECT_EQ(event.job().progress().layers_done(), 4);
  EXPECT_FALSE(event.job().has_result());
  EXPECT_FALSE(event.job().has_end_time());
  EXPECT_FALSE(event.job().has_spec());
}

TEST(JobsWire, AProjectIsNoMeshOfAnObject) {
  v1::JobSpec spec = SpecOfTwo();
  spec.mutable_objects(1)->set_format(v1::MESH_FORMAT_3MF);
  const absl::Status refused = FromProto(spec).status();
  EXPECT_EQ(DetailOf(refused).metadata["field"], "objects[1].format") << refused;
}

TEST(JobsWire, PagesFollowEachOther) {
  v1::ListJobsRequest request;
  request.set_page_size(2);
  const auto query = FromProto(request);
  ASSERT_TRUE(query.ok());
  JobRecord first = DoneJob(), second = DoneJob();
  second.number = 11;
  const v1::ListJobsResponse page = ToProto({first, second}, *query);
  request.set_page_token(page.next_page_token());
  EXPECT_EQ(FromProto(request)->after_number, 11);
  EXPECT_EQ(ToProto(std::vector<JobRecord>{first}, *query).next_page_token(), "")
      << "a page that is not full is the last";
}

TEST(JobsWire, APageTokenIsOfTheListThatGaveIt) {
  v1::ListJobsRequest request;
  request.set_page_size(1);
  (*request.mutable_labels())["order"] = "17";
  request.set_page_token(
      ToProto(std::vector<JobRecord>{DoneJob()}, *FromProto(request)).next_page_token());
  request.set_page_size(5);
  EXPECT_TRUE(FromProto(request).ok()) << "pages may differ in size";
  for (const auto& change : std::vector<std::function<void(v1::ListJobsRequest&)>>{
           [](auto& r) { (*r.mutable_labels())["order"] = "18"; },
           [](auto& r) { r.clear_labels(); }, [](auto& r) { r.set_oldest_first(true); },
           [](auto& r) { r.add_states(v1::JOB_STATE_FAILED); },
           [](auto& r) { r.set_priority(v1::JOB_PRIORITY_BULK); },
           [](auto& r) { r.mutable_created_from()->set_seconds(5); }}) {
    v1::ListJobsRequest other = request;
    change(other);
    EXPECT_EQ(DetailOf(FromProto(other).status()).metadata["field"], "page_token")
        << other.DebugString();
  }
}

TEST(JobsWire, ListsLeaveTheSettingsOut) {
  const v1::ListJobsResponse page = ToProto(std::vector<JobRecord>{DoneJob()}, ListQuery{});
  EXPECT_EQ(page.jobs(0).spec().objects(0).name(), "a.stl");
  EXPECT_EQ(page.jobs(0).spec().settings_size(), 0);
}

TEST(JobsWire, PagesEndByBytesToo) {
  JobRecord big = DoneJob();
  for (int i = 0; i < 64; ++i) big.labels[std::to_string(i)] = std::string(1000, 'l');
  std::vector<JobRecord> jobs(100, big);
  for (int i = 0; i < 100; ++i) jobs[i].number = 100 - i;
  const v1::ListJobsResponse page = ToProto(jobs, ListQuery{.states = {}, .limit = 1000});
  EXPECT_GT(page.jobs_size(), 1);
  EXPECT_LT(page.ByteSizeLong(), 2u << 20);
  EXPECT_TRUE(page.next_page_token().starts_with(std::to_string(101 - page.jobs_size()) + "-"));
}

TEST(JobsWire, PageSizesHaveBounds) {
  v1::ListJobsRequest request;
  EXPECT_EQ(FromProto(request)->limit, 50);
  request.set_page_size(1'000'000);
  EXPECT_EQ(FromProto(request)->limit, 1000);
}

}  // namespace
}  // namespace slicefarm::coordinator::jobs_wire_test
