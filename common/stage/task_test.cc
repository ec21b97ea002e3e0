#include "common/stage/task.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::task_test {
namespace {

/// Task that makes a text longer, for a process without layers.
template <Process kOf>
struct Words {
  static constexpr Process kProcess = kOf;
  std::string text;
  int32_t Weight() const { return static_cast<int32_t>(text.size()); }
  TaskLabel Label() const { return {"words " + text, {{"letters", Weight()}}}; }
};

struct Made {
  std::string text;
  StageTimes times;
  size_t Print() const { return text.size(); }
  int64_t ProgramBytes() const { return std::ssize(text); }
};

template <Process kOf>
class Maker : public RunnerOf<Words<kOf>, Made> {
 public:
  absl::StatusOr<Made> Run(const StageCall&, const Words<kOf>& task) const override {
    if (task.text.empty()) return absl::UnavailableError("silent");
    return Made{task.text + "!", {}};
  }
};

using First = Words<kProcesses[0].process>;
using Second = Words<kProcesses[1].process>;

TEST(Task, TellsItsProcessWeightAndLabel) {
  const Task task = First{"abc"};
  EXPECT_EQ(task.process(), kProcesses[0].process);
  EXPECT_EQ(task.weight(), 3);
  EXPECT_EQ(task.label(), (TaskLabel{"words abc", {{"letters", 3}}}));
  EXPECT_EQ(task.As<First>().text, "abc");
  const Task other = Second{};
  EXPECT_EQ(other.process(), kProcesses[1].process);
  EXPECT_EQ(Task().weight(), 0);
}

TEST(Task, OfLayersIsCalledByThem) {
  const TaskLabel label = LabelOf({3, 10});
  EXPECT_EQ(label.text, "layers 3 to 9");
  EXPECT_EQ(label.numbers, (std::map<std::string, int64_t>{{"layer_first", 3}, {"layer_last", 9}}));
}

TEST(TaskResult, IsWhatItWasMadeOf) {
  Made made{"abcd", {}};
  made.times[Stage::kMotion] = 2;
  TaskResult result = made;
  EXPECT_EQ(result.Print(), 4u);
  EXPECT_EQ(result.ProgramBytes(), 4);
  EXPECT_EQ(result.times()[Stage::kMotion], 2);
  result.As<Made>().text = "x";
  EXPECT_EQ(result.ProgramBytes(), 1);
}

TEST(StageTimes, AddUpByStage) {
  StageTimes times, more;
  double seconds = 1;
  for (const StageInfo& info : kStages) {
    times[info.stage] = seconds;
    more[info.stage] = 10 * seconds++;
  }
  times.Add(more);
  seconds = 1;
  for (const StageInfo& info : kStages) EXPECT_EQ(times[info.stage], 11 * seconds++) << info.name;
}

TEST(Stages, AreFoundByName) {
  for (const StageInfo& info : kStages) {
    EXPECT_EQ(StageName(info.stage), info.name) << "in the order of Stage";
    EXPECT_EQ(FindStage(info.name), info.stage);
  }
  EXPECT_EQ(FindStage("no such stage"), std::nullopt);
}

std::vector<std::shared_ptr<const TaskRunner>> Both() {
  return {std::make_shared<Maker<kProcesses[0].process>>(),
          std::make_shared<Maker<kProcesses[1].process>>()};
}

TEST(ProcessRunners, GiveEachTaskToItsRunner) {
  const ProcessRunners both(Both());
  EXPECT_EQ(both.processes(), (ProcessSet{kProcesses[0].process, kProcesses[1].process}));
  const auto result = both.RunTask({}, Second{"hey"});
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_EQ(result->As<Made>().text, "hey!");
  EXPECT_EQ(both.RunTask({}, First{}).status(), absl::UnavailableError("silent"));
}

TEST(ProcessRunners, WhatNobodyMakesIsAnError) {
  const ProcessRunners one({Both().front()});
  EXPECT_EQ(one.processes(), ProcessSet{kProcesses[0].process});
  EXPECT_EQ(DetailOf(one.RunTask({}, Second{"x"}).status()).reason, Reason::kInternal);
}

}  // namespace
}  // namespace slicefarm::task_test
