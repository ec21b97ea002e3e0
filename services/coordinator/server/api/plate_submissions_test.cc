// Tests of CreatePlates, which creates one job per plate, with a real server, real stores and fake
// stages.
#include "services/coordinator/server/api/plate_submissions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/coordinator/server/main/coordinator_fixture_test.h"

namespace slicefarm::coordinator::plate_submissions_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class PlatesTest : public CoordinatorTest {
 protected:
  absl::StatusOr<std::vector<v1::Job>> CreatePlates(const v1::CreatePlatesRequest& request) {
    grpc::ClientContext context;
    Bound(context);
    v1::CreatePlatesResponse response;
    const absl::Status status = rpc::FromGrpc(jobs_->CreatePlates(&context, request, &response));
    if (!status.ok()) return status;
    return std::vector<v1::Job>(response.jobs().begin(), response.jobs().end());
  }

  /// Returns a request for `copies` copies. FakeArranging puts each copy on a plate of its own.
  static v1::CreatePlatesRequest PlatesFor(const std::string& mesh, int copies,
                                           const std::string& request_id = "") {
    v1::CreatePlatesRequest request;
    request.set_request_id(request_id);
    *request.add_requests() = RequestFor(mesh);
    request.mutable_requests(0)->mutable_spec()->mutable_objects(0)->set_copies(copies);
    return request;
  }

  Reason RefusalOf(const v1::CreatePlatesRequest& request) {
    const auto jobs = CreatePlates(request);
    EXPECT_FALSE(jobs.ok());
    EXPECT_THAT(List(), IsEmpty()) << "all or none";
    return DetailOf(jobs.status()).reason;
  }

  static std::vector<std::string> Ids(const std::vector<v1::Job>& jobs) {
    std::vector<std::string> ids;
    for (const v1::Job& job : jobs) ids.push_back(job.id());
    return ids;
  }
};

TEST_F(PlatesTest, EachPlateIsAJobOfItsOwn) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreatePlatesRequest request = PlatesFor("xxx", 3);
  (*request.mutable_requests(0)->mutable_labels())["order"] = "17";
  const auto jobs = CreatePlates(request);
  ASSERT_TRUE(jobs.ok()) << jobs.status();
  ASSERT_THAT(*jobs, SizeIs(3));
  for (const v1::Job& made : *jobs) {
    EXPECT_EQ(made.spec().objects(0).name(), "part.stl");
    EXPECT_EQ(made.spec().objects(0).copies(), 1);
    EXPECT_EQ(made.spec().objects(0).mesh_sha256(), "") << "the answer is one message";
    const v1::Job job = AwaitEnd(made.id());
    EXPECT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED) << job.error().message();
    EXPECT_EQ(job.labels().at("order"), "17");
    ASSERT_EQ(job.spec().objects_size(), 1);
    ASSERT_EQ(job.spec().objects(0).instances_size(), 1);
    const v1::Instance& copy = job.spec().objects(0).instances(0);
    EXPECT_EQ(copy.place(), v1::Instance::PLACE_MIDDLE_AT);
    EXPECT_EQ(copy.to_plate(3), 50);
    EXPECT_EQ(job.spec().objects(0).name(), "part.stl");
  }
  EXPECT_EQ(arranging_.runs(), 1);
}

TEST_F(PlatesTest, PlatesOfSeveralRequestsComeInTheirOrder) {
  ASSERT_TRUE(Upload("xxx").ok());
  ASSERT_TRUE(Upload("xxxxx").ok());
  v1::CreatePlatesRequest request = PlatesFor("xxx", 2);
  *request.add_requests() = RequestFor("xxxxx");
  const auto jobs = CreatePlates(request);
  ASSERT_TRUE(jobs.ok()) << jobs.status();
  ASSERT_THAT(*jobs, SizeIs(3));
  const int layers[] = {3, 3, 5}, requests[] = {0, 0, 1}, beds[] = {0, 1, 0};
  for (size_t i = 0; i < 3; ++i) {
    const v1::Job job = AwaitEnd(jobs->at(i).id());
    EXPECT_EQ(job.result().layers(), layers[i]);
    for (const v1::Job& reported : {jobs->at(i), job}) {
      EXPECT_EQ(reported.spec().plate().request(), requests[i]);
      EXPECT_EQ(reported.spec().plate().bed(), beds[i]);
    }
  }
}

TEST_F(PlatesTest, CopiesOnABedAreToldAsMany) {
  v1::JobSpec spec;
  spec.mutable_plate()->set_request(1);
  spec.mutable_plate()->set_bed(2);
  spec.add_settings()->set_key("layer_height");
  for (const char* name : {"one", "three"}) spec.add_objects()->set_name(name);
  spec.mutable_objects(0)->set_mesh_sha256("a digest");
  for (int i = 0; i < 3; ++i) spec.mutable_objects(1)->add_instances();
  KeepWhatIsOnThePlate(spec);
  EXPECT_EQ(spec.plate().request(), 1);
  EXPECT_EQ(spec.plate().bed(), 2);
  EXPECT_THAT(spec.settings(), IsEmpty());
  ASSERT_EQ(spec.objects_size(), 2);
  EXPECT_EQ(spec.objects(0).mesh_sha256(), "");
  EXPECT_EQ(spec.objects(0).copies(), 1);
  EXPECT_EQ(spec.objects(1).name(), "three");
  EXPECT_EQ(spec.objects(1).copies(), 3);
}

TEST_F(PlatesTest, NoClientSaysWhatPlateItsJobIs) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  request.mutable_spec()->mutable_plate()->set_bed(7);
  const auto job = Create(request);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_FALSE(AwaitEnd(job->id()).spec().has_plate());
}

TEST_F(PlatesTest, ARepeatedCallReturnsTheFirstOnesJobs) {
  ASSERT_TRUE(Upload("xxx").ok());
  const auto first = CreatePlates(PlatesFor("xxx", 3, "an id"));
  ASSERT_TRUE(first.ok()) << first.status();
  const auto second = CreatePlates(PlatesFor("xxx", 3, "an id"));
  ASSERT_TRUE(second.ok()) << second.status();
  EXPECT_EQ(Ids(*second), Ids(*first));
  EXPECT_EQ(second->at(2).spec().plate().bed(), 2) << "as it is kept";
  EXPECT_EQ(arranging_.runs(), 1) << "nothing is done twice";
  EXPECT_THAT(List(), SizeIs(3));
  EXPECT_EQ(DetailOf(CreatePlates(PlatesFor("xxx", 4, "an id")).status()).reason,
            Reason::kRequestIdReused);
  Close();  // as after a crash of the coordinator
  Open();
  const auto third = CreatePlates(PlatesFor("xxx", 3, "an id"));
  ASSERT_TRUE(third.ok()) << third.status();
  EXPECT_EQ(Ids(*third), Ids(*first));
  EXPECT_NE(Ids(*CreatePlates(PlatesFor("xxx", 3))), Ids(*first));
}

TEST_F(PlatesTest, APlateThatWasDeletedHidesNoOther) {
  ASSERT_TRUE(Upload("xxx").ok());
  const auto first = CreatePlates(PlatesFor("xxx", 3, "an id"));
  ASSERT_TRUE(first.ok()) << first.status();
  AwaitEnd(first->at(1).id());
  ASSERT_TRUE(Delete(first->at(1).id()).ok());
  const auto second = CreatePlates(PlatesFor("xxx", 3, "an id"));
  ASSERT_TRUE(second.ok()) << second.status();
  EXPECT_THAT(Ids(*second), testing::ElementsAre(first->at(0).id(), first->at(2).id()));
}

TEST_F(PlatesTest, NoRequestIdOfAClientIsThatOfAPlate) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest own = RequestFor("xxx");
  own.set_request_id("an id#1");
  ASSERT_TRUE(Create(own).ok());
  EXPECT_THAT(*CreatePlates(PlatesFor("xxx", 2, "an id")), SizeIs(2));
  // The id has the maximum length. With a plate's number it is longer.
  const std::string long_id(limits::kMaxNameBytes, 'r');
  EXPECT_THAT(*CreatePlates(PlatesFor("xxx", 2, long_id)), SizeIs(2));
}

TEST_F(PlatesTest, WhatIsWrongWithOneLeavesNone) {
  ASSERT_TRUE(Upload("xxx").ok());
  ASSERT_TRUE(Upload("x!").ok());
  v1::CreatePlatesRequest bad_mesh = PlatesFor("xxx", 2);
  *bad_mesh.add_requests() = RequestFor("x!");
  EXPECT_EQ(RefusalOf(bad_mesh), Reason::kMeshMalformed);
  v1::CreatePlatesRequest no_mesh = PlatesFor("xxx", 2);
  *no_mesh.add_requests() = RequestFor("not uploaded");
  EXPECT_EQ(RefusalOf(no_mesh), Reason::kBlobNotFound);
  v1::CreatePlatesRequest setting = PlatesFor("xxx", 2);
  *setting.add_requests() = RequestFor("xxx");
  setting.mutable_requests(1)->mutable_spec()->add_settings()->set_key("no_such_key");
  EXPECT_EQ(RefusalOf(setting), Reason::kSettingUnknown);
}

TEST_F(PlatesTest, RefusesWhatIsNoRequest) {
  ASSERT_TRUE(Upload("xxx").ok());
  EXPECT_EQ(RefusalOf({}), Reason::kRequestMalformed);
  EXPECT_EQ(RefusalOf(PlatesFor("xxx", 2, "an\nid")), Reason::kRequestMalformed);
  v1::CreatePlatesRequest own_id = PlatesFor("xxx", 2);
  own_id.mutable_requests(0)->set_request_id("mine");
  EXPECT_EQ(RefusalOf(own_id), Reason::kRequestMalformed);
  v1::CreatePlatesRequest checks = PlatesFor("xxx", 2);
  checks.mutable_requests(0)->set_validate_only(true);
  EXPECT_EQ(RefusalOf(checks), Reason::kRequestMalformed);
  v1::CreatePlatesRequest advice = PlatesFor("xxx", 2);
  advice.mutable_requests(0)->set_advise_orientations(true);
  EXPECT_EQ(RefusalOf(advice), Reason::kRequestMalformed);
  EXPECT_EQ(RefusalOf(PlatesFor("xxx", limits::kMaxBatchJobs + 1)), Reason::kRequestTooLarge);
  v1::CreatePlatesRequest checked = PlatesFor("xxx", limits::kMaxBatchJobs + 1);
  checked.set_validate_only(true);
  EXPECT_EQ(RefusalOf(checked), Reason::kRequestTooLarge) << "each would be sliced";
  EXPECT_EQ(slicing_.runs(), 0);
  v1::CreatePlatesRequest together = PlatesFor("xxx", limits::kMaxBatchJobs);
  *together.add_requests() = RequestFor("xxx");
  EXPECT_EQ(RefusalOf(together), Reason::kRequestTooLarge);
  v1::CreatePlatesRequest many;
  for (int i = 0; i <= limits::kMaxBatchJobs; ++i) *many.add_requests() = RequestFor("xxx");
  EXPECT_EQ(RefusalOf(many), Reason::kRequestTooLarge);
}

TEST_F(PlatesTest, WhatPlatesOfALongSpecTakeIsBounded) {
  ASSERT_TRUE(Upload("xxx").ok());
  const auto of_long_texts = [](int copies) {
    v1::CreatePlatesRequest request = PlatesFor("xxx", copies);
    for (const char* key : {"start_gcode", "end_gcode", "layer_gcode", "before_layer_gcode"}) {
      v1::Setting& setting = *request.mutable_requests(0)->mutable_spec()->add_settings();
      setting.set_key(key);
      setting.set_value("; " + std::string(60'000, 'x'));
    }
    v1::Setting& field = *request.mutable_requests(0)->mutable_spec()->add_settings();
    field.set_key("density_field");
    field.set_value(R"({"kind": "constant", "density": 0.3)" + std::string(600'000, ' ') + "}");
    return request;
  };
  EXPECT_THAT(*CreatePlates(of_long_texts(2)), SizeIs(2));
  const absl::Status refused = CreatePlates(of_long_texts(limits::kMaxBatchJobs)).status();
  EXPECT_EQ(DetailOf(refused).reason, Reason::kRequestTooLarge);
  EXPECT_EQ(DetailOf(refused).metadata.at("limit"), std::to_string(limits::kMaxPlatesBytes));
}

TEST_F(PlatesTest, ACheckMakesNothingAndTellsOfEachPlate) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreatePlatesRequest request = PlatesFor("xxx", 2, "an id");
  request.set_validate_only(true);
  request.mutable_requests(0)->set_advise_orientations(true);
  const auto checked = CreatePlates(request);
  ASSERT_TRUE(checked.ok()) << checked.status();
  ASSERT_THAT(*checked, SizeIs(2));
  for (const v1::Job& job : *checked) {
    EXPECT_EQ(job.id(), "");
    EXPECT_EQ(job.preflight().layers(), 3);
    EXPECT_DOUBLE_EQ(job.preflight().first_layer_area_mm2(), 81) << "of one copy";
    EXPECT_EQ(job.preflight().orientations_size(), 1);
  }
  EXPECT_THAT(List(), IsEmpty());
  request.set_validate_only(false);
  request.mutable_requests(0)->set_advise_orientations(false);
  EXPECT_THAT(*CreatePlates(request), SizeIs(2)) << "its request_id is not taken";
}

}  // namespace
}  // namespace slicefarm::coordinator::plate_submissions_test
