// Tests of the options of a job besides its objects: modes, priorities, deadlines, profiles,
// batches and preflights. They also test how jobs are found again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/model/limits.h"
#include "nlohmann/json.hpp"
#include "services/coordinator/server/main/coordinator_fixture_test.h"

namespace slicefarm::coordinator::submission_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Reason ReasonOf(const absl::Status& status) { return DetailOf(status).reason; }

class SubmissionTest : public CoordinatorTest {
 protected:
  SubmissionTest() {
    Close();
    rates_ = {.currency = "CHF", .setup = 5, .machine_per_hour = 3600};
    Open();
  }

  absl::StatusOr<v1::Profile> Put(const std::string& name, const std::string& key,
                                  const std::string& value, bool from_profile = false) {
    v1::PutProfileRequest request;
    request.set_name(name);
    v1::Setting* setting = request.add_settings();
    setting->set_key(key);
    setting->set_value(value);
    setting->set_from_profile(from_profile);
    grpc::ClientContext context;
    v1::Profile profile;
    const absl::Status status = rpc::FromGrpc(profiles_->PutProfile(&context, request, &profile));
    if (!status.ok()) return status;
    return profile;
  }

  v1::Job MakeAndEnd(const v1::CreateJobRequest& request) {
    const auto job = Create(request);
    EXPECT_TRUE(job.ok()) << job.status();
    return job.ok() ? AwaitEnd(job->id()) : v1::Job();
  }

  absl::StatusOr<v1::BatchCreateJobsResponse> CreateBatch(const v1::BatchCreateJobsRequest& batch) {
    grpc::ClientContext context;
    v1::BatchCreateJobsResponse response;
    const absl::Status status = rpc::FromGrpc(jobs_->BatchCreateJobs(&context, batch, &response));
    if (!status.ok()) return status;
    return response;
  }

  v1::CreateJobRequest QuoteFor(const std::string& mesh) {
    v1::CreateJobRequest request = RequestFor(mesh);
    request.mutable_spec()->set_mode(v1::JOB_MODE_QUOTE);
    return request;
  }
};

TEST_F(SubmissionTest, NothingNewIsTakenWhenTheDiskRunsLowAndTheRestGoesOn) {
  ranges_->Hold();
  const std::string id = Submit("xxx");
  ranges_->AwaitCall();
  Close();
  min_free_bytes_ = std::numeric_limits<int64_t>::max();
  Open();
  for (const absl::Status& refused :
       {Upload("another").status(), Create(RequestFor("xxx")).status()}) {
    EXPECT_EQ(ReasonOf(refused), Reason::kDiskLow);
    EXPECT_TRUE(DetailOf(refused).metadata.contains(rpc::kRetryAfterMs));
  }
  ranges_->LetGo();
  EXPECT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_SUCCEEDED);
}

TEST_F(SubmissionTest, AQuoteHasWhatAPrintHasButTheGcode) {
  ASSERT_TRUE(Upload("xxx").ok());
  const v1::Job quote = MakeAndEnd(QuoteFor("xxx"));
  ASSERT_EQ(quote.state(), v1::JOB_STATE_SUCCEEDED) << quote.error().message();
  EXPECT_EQ(quote.result().gcode_sha256(), "");
  EXPECT_EQ(quote.result().gcode_size(), 0);
  EXPECT_EQ(quote.result().layers(), 3);
  EXPECT_EQ(quote.result().print_time_s(), 3);
  EXPECT_EQ(quote.result().cost().currency(), "CHF");
  EXPECT_DOUBLE_EQ(quote.result().cost().total(), 5 + 3);
  EXPECT_FALSE(quote.result().cached());
  const auto report = Download(quote.id(), v1::ARTIFACT_REPORT);
  ASSERT_TRUE(report.ok()) << report.status();
  EXPECT_EQ(nlohmann::json::parse(*report)["layers"], 3);
  const absl::Status gcode = Download(quote.id(), v1::ARTIFACT_GCODE).status();
  EXPECT_EQ(ReasonOf(gcode), Reason::kBlobNotFound);
  EXPECT_THAT(std::string(gcode.message()), HasSubstr("is a quote"));
}

TEST_F(SubmissionTest, AJobNamesItsPrinterOrSaysThatItNeedsNone) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  request.mutable_spec()->set_generic(false);
  const absl::Status refused = Create(request).status();
  EXPECT_EQ(ReasonOf(refused), Reason::kPrinterMissing);
  EXPECT_EQ(DetailOf(refused).metadata.at("settings"), "bed_shape, nozzle_diameter, gcode_flavor");
  for (const auto& [key, value] :
       {std::pair{"bed_shape", "0x0,250x0,250x250,0x250"}, std::pair{"nozzle_diameter", "0.4"},
        std::pair{"gcode_flavor", "marlin2"}}) {
    v1::Setting& setting = *request.mutable_spec()->add_settings();
    setting.set_key(key);
    setting.set_value(value);
  }
  EXPECT_EQ(MakeAndEnd(request).state(), v1::JOB_STATE_SUCCEEDED);
}

TEST_F(SubmissionTest, TheDefaultProfileIsThatOfJobsWithoutAPrinter) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::PutProfileRequest put;
  put.set_name("mk4s");
  for (const auto& [key, value] :
       {std::pair{"bed_shape", "0x0,250x0,250x250,0x250"}, std::pair{"nozzle_diameter", "0.4"},
        std::pair{"gcode_flavor", "marlin2"}}) {
    put.add_settings()->set_key(key);
    put.mutable_settings(put.settings_size() - 1)->set_value(value);
  }
  grpc::ClientContext context;
  v1::Profile profile;
  ASSERT_TRUE(profiles_->PutProfile(&context, put, &profile).ok());
  Close();
  default_profile_ = "mk4s";
  Open();
  v1::CreateJobRequest request = RequestFor("xxx");
  EXPECT_EQ(MakeAndEnd(request).spec().profiles_size(), 0) << "it is generic";
  request.mutable_spec()->set_generic(false);
  const v1::Job job = MakeAndEnd(request);
  ASSERT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED);
  ASSERT_EQ(job.spec().profiles_size(), 1);
  EXPECT_EQ(job.spec().profiles(0), "mk4s@1");
}

TEST_F(SubmissionTest, AMissingFeatureIsRefusedUnlessItIsAllowed) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  v1::ProjectNote& paint = *request.mutable_spec()->add_notes();
  paint.set_text("filaments are painted on `a`");
  paint.set_feature("painted_filaments");
  request.mutable_spec()->add_notes()->set_text("painted fuzzy skin of `a`: without effect");
  const absl::Status refused = Create(request).status();
  EXPECT_EQ(ReasonOf(refused), Reason::kNotSupported);
  EXPECT_EQ(DetailOf(refused).metadata.at("feature"), "painted_filaments");
  request.mutable_spec()->add_allow("painted_filament");
  EXPECT_EQ(ReasonOf(Create(request).status()), Reason::kRequestMalformed);
  request.mutable_spec()->set_allow(0, "painted_filaments");
  const v1::Job job = MakeAndEnd(request);
  ASSERT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED) << job.error().message();
  EXPECT_THAT(job.warnings(),
              testing::IsSupersetOf({std::string("filaments are painted on `a`"),
                                     std::string("painted fuzzy skin of `a`: without effect")}));
  EXPECT_TRUE(MakeAndEnd(request).result().cached());
}

TEST_F(SubmissionTest, SeveralToolsAreAFeatureThatIsMissing) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  *request.mutable_spec()->add_objects() = request.spec().objects(0);
  v1::Setting& tool = *request.mutable_spec()->mutable_objects(1)->add_settings();
  tool.set_key("extruder");
  tool.set_value("2");
  const absl::Status refused = Create(request).status();
  EXPECT_EQ(ReasonOf(refused), Reason::kNotSupported);
  EXPECT_EQ(DetailOf(refused).metadata.at("feature"), "several_tools");
  request.mutable_spec()->add_allow("several_tools");
  EXPECT_TRUE(Create(request).ok());
}

TEST_F(SubmissionTest, JobsAreSeenInTheViewAskedForAndInBatches) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  v1::Setting& setting = *request.mutable_spec()->add_settings();
  setting.set_key("perimeters");
  setting.set_value("3");
  const std::string id = MakeAndEnd(request).id();
  v1::GetJobRequest get;
  get.set_id(id);
  get.set_view(v1::JOB_VIEW_BASIC);
  v1::Job basic;
  grpc::ClientContext first;
  ASSERT_TRUE(jobs_->GetJob(&first, get, &basic).ok());
  EXPECT_EQ(basic.spec().settings_size(), 0);
  EXPECT_EQ(basic.spec().objects_size(), 1);
  EXPECT_EQ(Get(id)->spec().settings_size(), 1);
  v1::BatchGetJobsRequest batch;
  batch.add_ids(id);
  batch.add_ids("none");
  v1::BatchGetJobsResponse response;
  grpc::ClientContext second;
  ASSERT_TRUE(jobs_->BatchGetJobs(&second, batch, &response).ok());
  ASSERT_EQ(response.outcomes_size(), 2);
  EXPECT_EQ(response.outcomes(0).job().state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_FALSE(response.outcomes(0).job().has_spec());
  EXPECT_EQ(response.outcomes(1).error().reason(), "JOB_NOT_FOUND");
}

TEST_F(SubmissionTest, ACancelledJobHasNoResultForThatReason) {
  ranges_->Hold();
  const std::string id = Submit("xxx");
  ranges_->AwaitCall();
  ASSERT_TRUE(Cancel(id).ok());
  ranges_->LetGo();
  EXPECT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_CANCELLED);
  const absl::Status none = Download(id, v1::ARTIFACT_GCODE).status();
  EXPECT_EQ(ReasonOf(none), Reason::kCancelled);
  EXPECT_EQ(none.code(), absl::StatusCode::kFailedPrecondition);
}

TEST_F(SubmissionTest, APrintServesAsAQuoteAndNotTheOtherWayRound) {
  ASSERT_TRUE(Upload("xxx").ok());
  EXPECT_FALSE(MakeAndEnd(QuoteFor("xxx")).result().cached());
  const v1::Job print = MakeAndEnd(RequestFor("xxx"));
  EXPECT_FALSE(print.result().cached());
  const v1::Job quote = MakeAndEnd(QuoteFor("xxx"));
  EXPECT_TRUE(quote.result().cached());
  EXPECT_EQ(quote.result().gcode_sha256(), "");
  EXPECT_EQ(quote.result().report_sha256(), print.result().report_sha256());
  EXPECT_TRUE(MakeAndEnd(RequestFor("xxx")).result().cached());
}

TEST_F(SubmissionTest, ACachedResultCostsWhatIsChargedToday) {
  Submit("xxx");
  ASSERT_EQ(AwaitEnd(Submit("xxx")).result().cost().setup(), 5);
  Close();
  rates_.setup = 7;
  Open();
  const v1::Job again = AwaitEnd(Submit("xxx"));
  EXPECT_TRUE(again.result().cached());
  EXPECT_EQ(again.result().cost().setup(), 7);
}

TEST_F(SubmissionTest, AnInteractiveJobNeedNotWaitForLongOnes) {
  ranges_->Hold();
  const std::string a = Submit("x"), b = Submit("xx");  // all slots are taken
  ASSERT_TRUE(Upload("x!").ok());
  v1::CreateJobRequest request = RequestFor("x!");
  request.set_priority(v1::JOB_PRIORITY_INTERACTIVE);
  EXPECT_EQ(MakeAndEnd(request).state(), v1::JOB_STATE_FAILED) << "which it can only if it runs";
  EXPECT_EQ(Get(a)->has_end_time(), false);
  ranges_->LetGo();
  AwaitEnd(a);
  AwaitEnd(b);
}

TEST_F(SubmissionTest, PriorityAndDeadlineAreKept) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  EXPECT_EQ(Create(request)->priority(), v1::JOB_PRIORITY_NORMAL);
  EXPECT_FALSE(Create(request)->has_deadline());
  request.set_priority(v1::JOB_PRIORITY_INTERACTIVE);
  request.mutable_deadline()->set_seconds(4'000'000'000);
  request.mutable_deadline()->set_nanos(5'000);
  const auto job = Create(request);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->priority(), v1::JOB_PRIORITY_INTERACTIVE);
  EXPECT_EQ(job->deadline().seconds(), 4'000'000'000);
  EXPECT_EQ(Get(job->id())->deadline().nanos(), 5'000);
}

TEST_F(SubmissionTest, AJobThatMissesItsDeadlineFails) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  request.mutable_deadline()->set_seconds(1);
  const v1::Job job = MakeAndEnd(request);
  EXPECT_EQ(job.state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(job.error().reason(), "DEADLINE_EXCEEDED");
}

TEST_F(SubmissionTest, MoreUrgentJobsGoFirst) {
  Close();
  jobs_at_once_ = 1;
  Open();
  ranges_->Hold();
  Submit("x");
  ranges_->AwaitCall();
  ASSERT_TRUE(Upload("xxx").ok());
  std::vector<std::string> ids;
  for (const auto priority :
       {v1::JOB_PRIORITY_BULK, v1::JOB_PRIORITY_NORMAL, v1::JOB_PRIORITY_INTERACTIVE}) {
    v1::CreateJobRequest request = RequestFor("xxx");
    request.mutable_spec()->mutable_objects(0)->set_name(v1::JobPriority_Name(priority));
    request.set_priority(priority);
    ids.push_back(Create(request)->id());
  }
  ranges_->LetGo();
  std::vector<int64_t> started;
  for (const std::string& id : ids) {
    const v1::Job job = AwaitEnd(id);
    started.push_back(job.start_time().seconds() * 1'000'000 + job.start_time().nanos() / 1'000);
  }
  EXPECT_LE(started[2], started[1]);
  EXPECT_LE(started[1], started[0]);
}

TEST_F(SubmissionTest, WhatCannotBeIsNamed) {
  ASSERT_TRUE(Upload("xxx").ok());
  const std::pair<const char*, std::function<void(v1::CreateJobRequest&)>> kCases[] = {
      {"spec.mode", [](auto& r) { r.mutable_spec()->set_mode(static_cast<v1::JobMode>(9)); }},
      {"priority", [](auto& r) { r.set_priority(static_cast<v1::JobPriority>(9)); }},
      {"deadline", [](auto& r) { r.mutable_deadline()->set_seconds(-1); }},
      {"deadline", [](auto& r) { r.mutable_deadline()->set_nanos(1'000'000'000); }},
      {"deadline", [](auto& r) { r.mutable_deadline()->set_seconds(1LL << 60); }},
      {"spec.profiles[0]", [](auto& r) { r.mutable_spec()->add_profiles("a b"); }},
  };
  for (const auto& [field, spoil] : kCases) {
    v1::CreateJobRequest request = RequestFor("xxx");
    spoil(request);
    const absl::Status refused = Create(request).status();
    EXPECT_EQ(ReasonOf(refused), Reason::kRequestMalformed) << field;
    EXPECT_THAT(DetailOf(refused).metadata["field"], HasSubstr(field));
  }
}

// The farm of this test has no exposure service.
TEST_F(SubmissionTest, AProcessThatIsNotMadeHereIsRefused) {
  ASSERT_TRUE(Upload("xx").ok());
  v1::CreateJobRequest request = RequestFor("xx");
  request.mutable_spec()->set_process(v1::PROCESS_LASER);
  const absl::Status refused = Create(request).status();
  EXPECT_EQ(refused.code(), absl::StatusCode::kFailedPrecondition) << refused;
  EXPECT_EQ(ReasonOf(refused), Reason::kProcessUnavailable);
  EXPECT_EQ(DetailOf(refused).metadata.at("process"), "laser");
  request.mutable_spec()->set_process(static_cast<v1::Process>(99));
  EXPECT_EQ(ReasonOf(Create(request).status()), Reason::kRequestMalformed);
  request.mutable_spec()->set_process(v1::PROCESS_FDM);
  EXPECT_TRUE(Create(request).ok());
}

TEST_F(SubmissionTest, APreflightKeepsNothing) {
  ASSERT_TRUE(Upload("xxxxxxxxxx").ok());
  v1::CreateJobRequest request = RequestFor("xxxxxxxxxx");
  request.set_validate_only(true);
  request.set_request_id("an id");
  const auto job = Create(request);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->id(), "");
  EXPECT_EQ(job->preflight().layers(), 10);
  EXPECT_DOUBLE_EQ(job->preflight().first_layer_area_mm2(), 81);
  EXPECT_GT(job->preflight().print_time_s(), 0);
  EXPECT_GT(job->preflight().filament_g(), 0);
  EXPECT_GT(job->preflight().cost().total(), 5);
  EXPECT_NE(job->settings_digest(), "");
  EXPECT_NE(job->build_id(), "");
  EXPECT_THAT(List({}), ElementsAre());
  request.set_validate_only(false);
  EXPECT_NE(Create(request)->id(), "") << "its request_id is not taken";
}

TEST_F(SubmissionTest, OnlyAPreflightAdvisesOrientations) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  request.set_validate_only(true);
  EXPECT_EQ(Create(request)->preflight().orientations_size(), 0);
  request.set_advise_orientations(true);
  const auto job = Create(request);
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_EQ(job->preflight().orientations_size(), 1);
  EXPECT_EQ(job->preflight().orientations(0).rotate_deg(1), 90);
  request.set_validate_only(false);
  const absl::Status refused = Create(request).status();
  EXPECT_EQ(ReasonOf(refused), Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(refused).metadata["field"], "advise_orientations");
}

TEST_F(SubmissionTest, APreflightCountsCopies) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  request.set_validate_only(true);
  request.mutable_spec()->mutable_objects(0)->set_copies(3);
  const auto job = Create(request);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->preflight().layers(), 3);
  EXPECT_DOUBLE_EQ(job->preflight().first_layer_area_mm2(), 3 * 81);
}

TEST_F(SubmissionTest, AnObjectHasSettingsOfItsOwn) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  *request.mutable_spec()->add_objects() = request.spec().objects(0);
  v1::Setting* own = request.mutable_spec()->mutable_objects(1)->add_settings();
  own->set_key("fill_density");
  own->set_value("35%");
  const v1::Job job = MakeAndEnd(request);
  EXPECT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED) << job.error().message();
  EXPECT_EQ(job.spec().objects(1).settings(0).key(), "fill_density");
  EXPECT_FALSE(MakeAndEnd(RequestFor("xxx")).result().cached());
  EXPECT_TRUE(MakeAndEnd(request).result().cached());
  own->set_key("temperature");
  own->set_value("210");
  EXPECT_EQ(ReasonOf(Create(request).status()), Reason::kSettingMisplaced);
}

TEST_F(SubmissionTest, APreflightFindsWhatAJobWouldFailFor) {
  ASSERT_TRUE(Upload("x!").ok());
  v1::CreateJobRequest bad_mesh = RequestFor("x!");
  bad_mesh.set_validate_only(true);
  EXPECT_EQ(ReasonOf(Create(bad_mesh).status()), Reason::kMeshMalformed);
  v1::CreateJobRequest no_mesh = RequestFor("another");
  no_mesh.set_validate_only(true);
  EXPECT_EQ(ReasonOf(Create(no_mesh).status()), Reason::kBlobNotFound);
}

TEST_F(SubmissionTest, ABatchTellsOfEachJob) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::BatchCreateJobsRequest batch;
  *batch.add_requests() = RequestFor("xxx");
  *batch.add_requests() = RequestFor("of no mesh");
  *batch.add_requests() = QuoteFor("xxx");
  *batch.add_requests() = RequestFor("xxx");
  batch.mutable_requests(3)->set_validate_only(true);
  const auto created = CreateBatch(batch);
  ASSERT_TRUE(created.ok()) << created.status();
  const v1::BatchCreateJobsResponse& response = *created;
  ASSERT_EQ(response.outcomes_size(), 4);
  EXPECT_EQ(AwaitEnd(response.outcomes(0).job().id()).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(response.outcomes(1).error().reason(), "BLOB_NOT_FOUND");
  EXPECT_EQ(AwaitEnd(response.outcomes(2).job().id()).spec().mode(), v1::JOB_MODE_QUOTE);
  EXPECT_EQ(response.outcomes(3).error().reason(), "REQUEST_MALFORMED");
}

TEST_F(SubmissionTest, ABatchOfTooManyIsRefusedAsAWhole) {
  v1::BatchCreateJobsRequest batch;
  for (int i = 0; i <= limits::kMaxBatchJobs; ++i) *batch.add_requests() = RequestFor("xxx");
  EXPECT_EQ(ReasonOf(CreateBatch(batch).status()), Reason::kRequestTooLarge);
}

// All outcomes of a batch are in one message.
TEST_F(SubmissionTest, ABatchTellsOfLongErrorsInShort) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::BatchCreateJobsRequest batch;
  *batch.add_requests() = RequestFor("xxx");
  for (int i = 0; i < 60; ++i) {
    v1::CreateJobRequest& wrong = *batch.add_requests();
    wrong = RequestFor("xxx");
    v1::Setting* setting = wrong.mutable_spec()->add_settings();
    setting->set_key(std::string(60'000, 'k'));
    setting->set_value("1");
  }
  const auto response = CreateBatch(batch);
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_FALSE(response->outcomes(0).job().id().empty());
  EXPECT_EQ(response->outcomes(60).error().reason(), "SETTING_UNKNOWN");
}

TEST_F(SubmissionTest, ABatchWhoseAnswerWouldBeTooLongIsRefusedBeforeItIsMade) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::BatchCreateJobsRequest batch;
  for (int i = 0; i < 40; ++i) {
    v1::CreateJobRequest& each = *batch.add_requests();
    each = RequestFor("xxx");
    for (int label = 0; label < 60; ++label)
      (*each.mutable_labels())[absl::StrCat(label)] = std::string(1000, 'x');
  }
  EXPECT_EQ(ReasonOf(CreateBatch(batch).status()), Reason::kRequestTooLarge);
  EXPECT_EQ(List().size(), 0);
}

TEST_F(SubmissionTest, ProfilesThatAreTooMuchTogetherAreRefused) {
  ASSERT_TRUE(Upload("xxx").ok());
  ASSERT_TRUE(Put("long", "start_gcode", std::string(60'000, 'G')).ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  for (int i = 0; i < limits::kMaxJobProfiles; ++i) request.mutable_spec()->add_profiles("long");
  const auto fits = Create(request);
  EXPECT_TRUE(fits.ok()) << fits.status();
  v1::PutProfileRequest longer;
  longer.set_name("longer");
  for (int i = 0; i < 5; ++i) {
    v1::Setting* setting = longer.add_settings();
    setting->set_key("start_gcode");
    setting->set_value(std::string(60'000, 'G'));
  }
  grpc::ClientContext context;
  v1::Profile profile;
  ASSERT_TRUE(profiles_->PutProfile(&context, longer, &profile).ok());
  for (std::string& name : *request.mutable_spec()->mutable_profiles()) name = "longer";
  EXPECT_EQ(ReasonOf(Create(request).status()), Reason::kRequestTooLarge);
}

TEST_F(SubmissionTest, SettingsOfProfilesComeBeforeThoseOfTheJob) {
  ASSERT_TRUE(Upload("xxx").ok());
  ASSERT_EQ(Put("thin", "layer_height", "0.1")->revision(), 1);
  ASSERT_EQ(Put("walls", "perimeters", "7")->revision(), 1);
  v1::CreateJobRequest by_hand = RequestFor("xxx");
  for (const auto& [key, value] : {std::pair{"layer_height", "0.1"}, {"perimeters", "2"}}) {
    v1::Setting* setting = by_hand.mutable_spec()->add_settings();
    setting->set_key(key);
    setting->set_value(value);
  }
  v1::CreateJobRequest by_profile = RequestFor("xxx");
  by_profile.mutable_spec()->add_profiles("walls");
  by_profile.mutable_spec()->add_profiles("thin@1");
  v1::Setting* own = by_profile.mutable_spec()->add_settings();
  own->set_key("perimeters");
  own->set_value("2");
  const auto job = Create(by_profile);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->settings_digest(), Create(by_hand)->settings_digest());
  EXPECT_THAT(job->spec().profiles(), ElementsAre("walls@1", "thin@1"));
}

TEST_F(SubmissionTest, AJobKeepsTheRevisionItGot) {
  ASSERT_TRUE(Upload("xxx").ok());
  ASSERT_TRUE(Put("p", "perimeters", "7").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  request.set_request_id("r");
  request.mutable_spec()->add_profiles("p");
  const auto first = Create(request);
  ASSERT_TRUE(first.ok()) << first.status();
  ASSERT_EQ(Put("p", "perimeters", "8")->revision(), 2);
  EXPECT_EQ(Create(request)->id(), first->id()) << "the request is the same";
  request.set_request_id("another");
  const auto second = Create(request);
  EXPECT_THAT(second->spec().profiles(), ElementsAre("p@2"));
  EXPECT_NE(second->settings_digest(), first->settings_digest());
}

TEST_F(SubmissionTest, ProfilesAreCheckedAndFoundAgain) {
  EXPECT_EQ(ReasonOf(Put("p", "no_such_setting", "7").status()), Reason::kSettingUnknown);
  EXPECT_EQ(ReasonOf(Put("p", "perimeters", "x").status()), Reason::kSettingMalformed);
  EXPECT_EQ(ReasonOf(Put("../p", "perimeters", "3").status()), Reason::kRequestMalformed);
  EXPECT_TRUE(Put("p", "no_such_setting", "7", /*from_profile=*/true).ok());
  EXPECT_EQ(Put("p", "perimeters", "3")->revision(), 2);
  EXPECT_EQ(Put("p", "perimeters", "3")->revision(), 2);

  v1::GetProfileRequest get;
  get.set_name("p");
  get.set_revision(1);
  v1::Profile profile;
  grpc::ClientContext first;
  ASSERT_TRUE(profiles_->GetProfile(&first, get, &profile).ok());
  EXPECT_EQ(profile.settings(0).key(), "no_such_setting");
  get.set_revision(3);
  grpc::ClientContext second;
  EXPECT_EQ(ReasonOf(rpc::FromGrpc(profiles_->GetProfile(&second, get, &profile))),
            Reason::kProfileNotFound);

  v1::CreateJobRequest request = RequestFor("xxx");
  request.mutable_spec()->add_profiles("q");
  const absl::Status missing = Create(request).status();
  EXPECT_EQ(ReasonOf(missing), Reason::kProfileNotFound);
  EXPECT_TRUE(absl::IsFailedPrecondition(missing));

  ASSERT_TRUE(Put("a", "perimeters", "3").ok());
  v1::ListProfilesRequest list;
  list.set_page_size(1);
  std::vector<std::string> names;
  do {
    v1::ListProfilesResponse page;
    grpc::ClientContext context;
    ASSERT_TRUE(profiles_->ListProfiles(&context, list, &page).ok());
    for (const v1::Profile& each : page.profiles())
      names.push_back(absl::StrCat(each.name(), "@", each.revision()));
    list.set_page_token(page.next_page_token());
  } while (!list.page_token().empty());
  EXPECT_THAT(names, ElementsAre("a@1", "p@2"));
}

TEST_F(SubmissionTest, JobsAreFoundByWhatTheyAre) {
  ASSERT_TRUE(Upload("xxx").ok());
  std::vector<std::string> ids;
  for (const char* order : {"17", "18", "18"}) {
    v1::CreateJobRequest request = RequestFor("xxx");
    (*request.mutable_labels())["order"] = order;
    request.set_priority(ids.empty() ? v1::JOB_PRIORITY_BULK : v1::JOB_PRIORITY_NORMAL);
    ids.push_back(Create(request)->id());
  }
  v1::ListJobsRequest by_label;
  (*by_label.mutable_labels())["order"] = "18";
  EXPECT_THAT(List(by_label), ElementsAre(ids[2], ids[1]));
  by_label.set_oldest_first(true);
  EXPECT_THAT(List(by_label), ElementsAre(ids[1], ids[2]));
  v1::ListJobsRequest by_priority;
  by_priority.set_priority(v1::JOB_PRIORITY_BULK);
  EXPECT_THAT(List(by_priority), ElementsAre(ids[0]));
  v1::ListJobsRequest by_time;
  *by_time.mutable_created_from() = Get(ids[1])->create_time();
  EXPECT_THAT(List(by_time), ElementsAre(ids[2], ids[1]));
  *by_time.mutable_created_before() = Get(ids[2])->create_time();
  EXPECT_THAT(List(by_time), ElementsAre(ids[1]));
}

}  // namespace
}  // namespace slicefarm::coordinator::submission_test
