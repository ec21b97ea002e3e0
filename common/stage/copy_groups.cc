#include "common/stage/copy_groups.h"

#include <algorithm>

namespace slicefarm {

std::vector<CopyGroup> GroupsOf(std::span<const Instance> instances) {
  std::vector<CopyGroup> groups;
  for (const Instance& instance : instances) {
    if (!instance.printable) continue;
    Transform turned = instance.to_plate;
    turned(0, 3) = turned(1, 3) = 0;
    const auto same = std::ranges::find_if(
        groups, [&](const CopyGroup& group) { return group.to_plate == turned; });
    CopyGroup& group = same != groups.end() ? *same : groups.emplace_back(CopyGroup{turned, {}});
    group.instances.push_back(&instance);
  }
  return groups;
}

std::vector<CopyInput> CopiesOf(const CopyGroup& group) {
  std::vector<CopyInput> copies;
  for (const Instance* instance : group.instances) {
    CopyInput& copy = copies.emplace_back();
    if (!instance->placed) continue;
    copy.place = instance->by_middle ? CopyInput::Place::kMiddleAt : CopyInput::Place::kOriginAt;
    copy.at = {FromMm(instance->to_plate(0, 3)), FromMm(instance->to_plate(1, 3))};
  }
  return copies;
}

}  // namespace slicefarm
