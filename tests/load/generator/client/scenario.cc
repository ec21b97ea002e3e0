#include "tests/load/generator/client/scenario.h"

#include <future>
#include <string>
#include <utility>
#include <vector>

#include "common/wire/support/enum_wire.h"
#include "tests/load/generator/algo/seeded.h"
#include "tests/load/generator/client/print_request.h"

namespace slicefarm::load {
namespace {

/// Waits for an operation that ends with a call of `done`, during the preparation of a run.
template <typename Start>
absl::Status Await(const Start& start) {
  auto ended = std::make_shared<std::promise<absl::Status>>();
  std::future<absl::Status> status = ended->get_future();
  start([ended](const Outcome& outcome) { ended->set_value(outcome.status); });
  return status.get();
}

/// Values that differ between jobs.
struct JobNote {
  std::string request_id;  ///< unique among the requests of a run
  v1::Process process = EnumToProto<v1::Process>(kDefaultProcess);
};

class Numbering {
 public:
  explicit Numbering(const ScenarioOptions& options)
      : seed_(options.parts.seed), processes_(options.processes) {}

  JobNote Next() {
    const Process process = processes_[next_ % processes_.size()];
    return {RequestId(seed_, next_++), EnumToProto<v1::Process>(process)};
  }

 private:
  const uint64_t seed_;
  const std::vector<Process> processes_;
  uint64_t next_ = 0;
};

/// Scenario of kPrint and kWatch.
class PrintScenario final : public Scenario {
 public:
  PrintScenario(const ScenarioOptions& options, Farm& farm)
      : watchers_(options.kind == ScenarioKind::kWatch ? options.watchers : 1),
        download_(options.kind == ScenarioKind::kPrint),
        farm_(farm),
        numbers_(options),
        parts_(options.parts) {}

  /// Prints the repeated parts once, so that their results exist.
  absl::Status Prepare(const CallContext& context) override {
    for (const PartPtr& part : parts_.SameParts()) {
      const JobNote note = numbers_.Next();
      const PrintOrder order = {
          .part = part, .request_id = note.request_id, .process = note.process};
      absl::Status status =
          Await([&](Done done) { StartPrint(farm_, order, context, std::move(done)); });
      if (!status.ok()) return status;
    }
    return absl::OkStatus();
  }

  void Start(const CallContext& context, Done done) override {
    const JobNote note = numbers_.Next();
    StartPrint(farm_,
               {.part = parts_.Take(),
                .request_id = note.request_id,
                .process = note.process,
                .watchers = watchers_,
                .download = download_},
               context, std::move(done));
  }

 private:
  const int watchers_;
  const bool download_;
  Farm& farm_;
  Numbering numbers_;
  PartSupply parts_;
};

class SubmitScenario final : public Scenario {
 public:
  SubmitScenario(const ScenarioOptions& options, Farm& farm)
      : same_(options.parts.same),
        farm_(farm),
        numbers_(options),
        scales_(options.parts.seed),
        part_(NewPart(PickSize(options.parts.mix, options.parts.seed, 0), options.parts.seed)) {}

  absl::Status Prepare(const CallContext& context) override {
    return Await([&](const Done& done) {
      farm_.Next().Upload(part_, context, [done](absl::Status status) {
        done(OutcomeOf(std::move(status), "Upload"));
      });
    });
  }

  void Start(const CallContext& context, Done done) override {
    const JobNote note = numbers_.Next();
    v1::CreateJobRequest request = JobOf(note.request_id, part_->sha256, note.process);
    // Each job uses the same mesh but is different work.
    if (!same_) {
      request.mutable_spec()->mutable_objects(0)->mutable_placement()->add_scale(
          scales_.Uniform(1, 1.5));
    }
    farm_.Next().CreateJob(request, context, [done = std::move(done)](const auto& job) {
      done(OutcomeOf(job.status(), "CreateJob"));
    });
  }

 private:
  const bool same_;
  Farm& farm_;
  Numbering numbers_;
  SeededRandom scales_;
  const PartPtr part_;
};

class GetScenario final : public Scenario {
 public:
  GetScenario(const ScenarioOptions& options, Farm& farm)
      : farm_(farm), numbers_(options), options_(options) {}

  /// Creates some jobs and waits for their ends, so that only the requests keep the server busy.
  absl::Status Prepare(const CallContext& context) override {
    constexpr uint64_t kJobs = 16;
    for (uint64_t i = 0; i < kJobs; ++i) {
      const uint64_t seed = SeededRandom::Of(options_.parts.seed, i).Bits();
      absl::Status status = AddJob(NewPart(PartSize::kTiny, seed), context);
      if (!status.ok()) return status;
    }
    return absl::OkStatus();
  }

  void Start(const CallContext& context, Done done) override {
    const std::string& id = jobs_[next_++ % jobs_.size()];
    farm_.Next().GetJob(id, context, [done = std::move(done)](const auto& job) {
      done(OutcomeOf(job.status(), "GetJob"));
    });
  }

 private:
  absl::Status AddJob(const PartPtr& part, const CallContext& context) {
    const JobNote note = numbers_.Next();
    absl::Status status = Await([&](Done done) {
      StartPrint(farm_, {.part = part, .request_id = note.request_id, .process = note.process},
                 context, std::move(done));
    });
    if (!status.ok()) return status;
    // The same request again returns the same job, and so its id.
    return Await([&](const Done& done) {
      farm_.Next().CreateJob(JobOf(note.request_id, part->sha256, note.process), context,
                             [this, done](const absl::StatusOr<v1::Job>& job) {
                               if (job.ok()) jobs_.push_back(job->id());
                               done(OutcomeOf(job.status(), "CreateJob"));
                             });
    });
  }

  Farm& farm_;
  Numbering numbers_;
  const ScenarioOptions options_;
  std::vector<std::string> jobs_;
  size_t next_ = 0;
};

}  // namespace

std::unique_ptr<Scenario> MakeScenario(const ScenarioOptions& options, Farm& farm) {
  switch (options.kind) {
    case ScenarioKind::kSubmit:
      return std::make_unique<SubmitScenario>(options, farm);
    case ScenarioKind::kGet:
      return std::make_unique<GetScenario>(options, farm);
    case ScenarioKind::kPrint:
    case ScenarioKind::kWatch:
      break;
  }
  return std::make_unique<PrintScenario>(options, farm);
}

}  // namespace slicefarm::load
