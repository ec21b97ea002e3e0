#include "services/coordinator/algo/pipeline/job_pipeline.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/fdm_task.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"

namespace slicefarm::coordinator::job_pipeline_test {
namespace {

class NamedLayers : public FdmRunner {
 public:
  absl::StatusOr<FdmResult> Run(const StageCall&, const FdmTask& task) const override {
    FdmResult result;
    for (int32_t i = task.range.first; i < task.range.last; ++i)
      result.programs.emplace_back().gcode = absl::StrCat(i, " ");
    return result;
  }
};

/// Planned job of ten layers, one task per layer. Assemble joins their texts.
class Counted : public PlannedJob {
 public:
  int32_t Weight() const override { return 10; }
  absl::StatusOr<std::vector<Task>> Tasks(int /*slots*/) override {
    std::vector<Task> tasks;
    for (int32_t i = 0; i < 10; ++i) {
      FdmTask task;
      task.range = {i, i + 1};
      tasks.push_back(task);
    }
    return tasks;
  }
  absl::Status Take(size_t task, TaskResult result) override {
    texts_[task] = result.As<FdmResult>().programs[0].gcode;
    return absl::OkStatus();
  }
  absl::StatusOr<JobOutput> Assemble(const StageCall&) override {
    JobOutput output;
    for (const std::string& text : texts_) output.program.Add(text);
    return output;
  }

 private:
  std::array<std::string, 10> texts_;
};

class CountedProcess : public JobProcess {
 public:
  Process process() const override { return Process::kFdm; }
  absl::StatusOr<std::unique_ptr<PlannedJob>> Plan(const StageCall&, JobInput) const override {
    if (!fails.ok()) return fails;
    return std::make_unique<Counted>();
  }
  absl::StatusOr<JobEstimate> Estimate(const StageCall&, SlicedJob, JobInput,
                                       TaskExecutor&) const override {
    return JobEstimate();
  }

  absl::Status fails;
};

class JobPipelineTest : public testing::Test {
 protected:
  JobPipelineTest() {
    dispatcher_.Join({.name = "here", .tasks = std::make_shared<NamedLayers>(), .slots = 3});
  }

  /// Returns a pipeline with one process. If `fails` is an error, Plan returns it.
  JobPipeline Pipeline(const absl::Status& fails = {}) {
    auto process = std::make_unique<CountedProcess>();
    process->fails = fails;
    std::vector<std::unique_ptr<JobProcess>> processes;
    processes.push_back(std::move(process));
    return {std::move(processes), dispatcher_};
  }

  Dispatcher dispatcher_;
};

TEST_F(JobPipelineTest, PutsResultsTogetherInTheirOrder) {
  std::vector<int32_t> done;
  const auto output = Pipeline().Run({}, {}, [&](PipelineProgress p) {
    EXPECT_EQ(p.total, 10);
    done.push_back(p.done);
  });
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(*output->program.Whole(), "0 1 2 3 4 5 6 7 8 9 ");
  EXPECT_EQ(done.front(), 0);
  EXPECT_EQ(done.back(), 10);
}

TEST_F(JobPipelineTest, ErrorsOfThePlanEndTheJob) {
  const absl::Status fails = absl::UnavailableError("no plan");
  EXPECT_EQ(Pipeline(fails).Run({}, {}, nullptr).status(), fails);
}

TEST_F(JobPipelineTest, AProcessThatIsNotThereIsAnError) {
  const auto output = JobPipeline({}, dispatcher_).Run({}, {}, nullptr);
  EXPECT_EQ(DetailOf(output.status()).reason, Reason::kProcessUnavailable);
}

}  // namespace
}  // namespace slicefarm::coordinator::job_pipeline_test
