#include "processes/mill/job/step_split.h"

#include <algorithm>
#include <cstdint>

namespace slicefarm::coordinator {
namespace {

/// Maximum weight of a task: about a hundred levels of roughing. It limits the work that is lost
/// with a failed worker.
constexpr int64_t kMostWeight = 400;
/// Minimum weight of a task. Below it, the overhead of a call exceeds the benefit.
constexpr int64_t kLeastWeight = 16;

/// Returns the index after the last step of the phase of step `first`.
int32_t EndOfPhase(const std::vector<MillStep>& steps, int32_t first) {
  const MillPhase phase = steps[static_cast<size_t>(first)].phase;
  int32_t last = first;
  while (last < std::ssize(steps) && steps[static_cast<size_t>(last)].phase == phase) ++last;
  return last;
}

int64_t WeightOf(const MillLayout& layout, int32_t first, int32_t last) {
  int64_t weight = 0;
  for (int32_t i = first; i < last; ++i) weight += layout.weights[static_cast<size_t>(i)];
  return weight;
}

}  // namespace

std::vector<MillTask> SplitSteps(const MillLayout& layout, const Shared<MillInput>& input,
                                 int slots) {
  const auto count = static_cast<int32_t>(layout.steps.size());
  std::vector<MillTask> tasks;
  for (int32_t begin = 0, end = 0; begin < count; begin = end) {
    end = EndOfPhase(layout.steps, begin);
    const int64_t parts = 2 * std::max(slots, 1);
    const int64_t share = (WeightOf(layout, begin, end) + parts - 1) / parts;
    const int64_t want = std::clamp(share, kLeastWeight, kMostWeight);
    for (int32_t first = begin, last = begin; first < end; first = last) {
      int64_t weight = 0;
      while (last < end && weight < want) weight += layout.weights[static_cast<size_t>(last++)];
      tasks.push_back({{first, last},
                       layout.steps[static_cast<size_t>(first)].phase,
                       first - begin,
                       static_cast<int32_t>(weight),
                       input});
    }
  }
  return tasks;
}

}  // namespace slicefarm::coordinator
