#include "processes/list/wire.h"

#include <gtest/gtest.h>

#include <deque>
#include <utility>
#include <vector>

#include "common/stage/exposure_job.h"
#include "common/wire/support/round_trip_test.h"
#include "processes/engrave/task/engrave_task.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/fdm_task.h"
#include "processes/laser/task/laser_task.h"
#include "processes/mill/task/mill_task.h"

namespace slicefarm::wire_test {
namespace {

/// A stream in memory: one end reads the messages that the other end wrote.
template <typename In, typename Out>
class Pipe : public MessageChannel<In, Out> {
 public:
  bool Read(In* message) override {
    if (in.empty()) return false;
    *message = std::move(in.front());
    in.pop_front();
    return true;
  }
  bool Write(const Out& message) override {
    out.push_back(message);
    return true;
  }

  std::deque<In> in;
  std::deque<Out> out;
};
using ToWorker = Pipe<v1::WorkResponse, v1::WorkRequest>;
using ToCoordinator = Pipe<v1::WorkRequest, v1::WorkResponse>;

/// A layer, and the result of a task of each process for it.
struct Sample {
  static constexpr LayerFrame kFrame = {0, 200'000, 200'000};

  std::vector<SlicedLayer> layers = {{kFrame, {}}};
  std::vector<LayerPlan> plans = std::vector<LayerPlan>(1);
  std::vector<Copy> copies = {{0, {1'000, 2'000}, 0}};
  JobFacts facts = {1, {{"a", 0, 0, 1}}, {{}}};
  FdmSettings fdm_settings;
  ExposureSettings laser_settings;
  MillInput mill_input = {{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 2}}}, {}, {}};

  Task TaskOf(Process process) const {
    switch (process) {
      case Process::kFdm:
        return FdmTask{{0, 1}, layers, plans, FdmShared{fdm_settings, copies, facts}};
      case Process::kLaser:
        return LaserTask{{0, 1}, layers, ExposureJob{laser_settings, copies}};
      case Process::kMill:
        return MillTask{{2, 3}, MillPhase::kFinishing, 1, 3, mill_input};
      case Process::kEngrave:
        return EngraveTask{{2, 3}, EngraveInput{}};
    }
    return {};
  }

  static TaskResult ResultOf(Process process) {
    switch (process) {
      case Process::kFdm: {
        FdmResult result;
        result.programs.resize(1);
        result.programs[0].frame = kFrame;
        result.programs[0].gcode = "G1 X1\n";
        result.times[Stage::kBeading] = 0.5;
        return result;
      }
      case Process::kLaser: {
        LaserResult result;
        result.programs.resize(1);
        result.programs[0].frame = kFrame;
        result.programs[0].text = "$$POLYLINE";
        result.times[Stage::kExposure] = 0.5;
        return result;
      }
      case Process::kMill: {
        MillResult result;
        result.steps = {{{MillPhase::kFinishing, 2.5}, {}, {{{0, 1, 2}, {3, 4, 5}}}}};
        result.times[Stage::kMilling] = 0.5;
        return result;
      }
      case Process::kEngrave: {
        EngraveResult result;
        result.layers = {{.numbers = {.layer = 2, .points = 1}, .program = {}, .text = "0,2,1\n"}};
        result.times[Stage::kTexture] = 0.5;
        return result;
      }
    }
    return {};
  }
};

class EveryProcess : public testing::TestWithParam<Process> {
 protected:
  const TaskWire& wire() const { return WireOf(GetParam()); }
};

TEST_P(EveryProcess, SendsItsTasks) {
  const Sample sample;
  const Task task = sample.TaskOf(GetParam());
  ToWorker sender;
  StageCall call;
  call.job_id = "j";
  ASSERT_TRUE(wire().Send(call, task, sender).ok());
  ToCoordinator receiver;
  receiver.in = std::move(sender.out);
  v1::WorkRequest first;
  ASSERT_TRUE(receiver.Read(&first));
  EXPECT_EQ(first.start().call().job_id(), "j");
  EXPECT_EQ(WireOf(first.start()), &wire());
  SharedCache shared(1 << 20);
  const std::string missing =
      MissingDigest(wire().Receive(first.start(), shared, {}, receiver).status());
  const auto parts = wire().PartsOf(task);
  ASSERT_TRUE(parts.ok()) << parts.status();
  ASSERT_EQ(parts->size(), 1u);
  EXPECT_EQ(parts->front()->digest, missing);
  EXPECT_EQ(wire().PartsOf(task)->front(), parts->front()) << "is made once";
  shared.Put(*parts->front());
  const auto received = wire().Receive(first.start(), shared, {}, receiver);
  ASSERT_TRUE(received.ok()) << received.status();
  const Task there = (*received)->task();
  EXPECT_EQ(there.process(), GetParam());
  EXPECT_EQ(there.weight(), task.weight());
  EXPECT_EQ(there.label(), task.label());
}

TEST_P(EveryProcess, SendsWhatTheyComeTo) {
  const Sample sample;
  ToCoordinator sender;
  ASSERT_TRUE(wire().SendResult(Sample::ResultOf(GetParam()), sender).ok());
  ToWorker receiver;
  receiver.in = std::move(sender.out);
  const auto result = wire().ReceiveResult(receiver);
  ASSERT_TRUE(result.ok()) << result.status();
  const TaskResult want = Sample::ResultOf(GetParam());
  EXPECT_EQ(result->Print(), want.Print());
  EXPECT_EQ(result->times(), want.times());
  EXPECT_TRUE(wire().Check(sample.TaskOf(GetParam()), *result).ok());
  ToWorker nothing;
  const auto empty = wire().ReceiveResult(nothing);
  ASSERT_TRUE(empty.ok()) << empty.status();
  EXPECT_FALSE(wire().Check(sample.TaskOf(GetParam()), *empty).ok()) << "a layer is missing";
}

TEST_P(EveryProcess, RefusesATaskWithoutItsLayers) {
  const Sample sample;
  ToWorker sender;
  const Task task = sample.TaskOf(GetParam());
  ASSERT_TRUE(wire().Send({}, task, sender).ok());
  SharedCache shared(1 << 20);
  const auto parts = wire().PartsOf(task);
  ASSERT_TRUE(parts.ok()) << parts.status();
  for (const auto& part : *parts) shared.Put(*part);
  if (sender.out.size() == 1) return;  // the start contains the whole task
  ToCoordinator receiver;
  const auto received = wire().Receive(sender.out.front().start(), shared, {}, receiver);
  EXPECT_EQ(DetailOf(received.status()).reason, Reason::kRequestMalformed) << received.status();
}

TEST_P(EveryProcess, RefusesWorkWithoutARange) {
  const Sample sample;
  ToWorker sender;
  ASSERT_TRUE(wire().Send({}, sample.TaskOf(GetParam()), sender).ok());
  v1::WorkStart start = sender.out.front().start();
  const auto* work = start.GetDescriptor()->FindFieldByNumber(start.work_case());
  start.GetReflection()->MutableMessage(&start, work)->Clear();
  SharedCache shared(1 << 20);
  ToCoordinator receiver;
  ExpectMalformed(wire().Receive(start, shared, {}, receiver).status(),
                  "start." + work->name() + ".range");
}

INSTANTIATE_TEST_SUITE_P(Wire, EveryProcess, testing::ValuesIn([] {
                           std::vector<Process> all;
                           for (const ProcessInfo& info : kProcesses) all.push_back(info.process);
                           return all;
                         }()),
                         [](const auto& info) { return std::string(ProcessName(info.param)); });

TEST(WireOf, AStartWithoutWorkIsOfNoProcess) { EXPECT_EQ(WireOf(v1::WorkStart()), nullptr); }

}  // namespace
}  // namespace slicefarm::wire_test
