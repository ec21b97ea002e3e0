#include "services/slicing/algo/mesh_io/threemf/plates.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "services/slicing/algo/mesh_io/threemf/bed_box.h"

namespace slicefarm::slicing::threemf {
namespace {

using Member = ProjectPlate::Member;

/// Distance from one plate to the next, as a multiple of the bed's size.
constexpr double kPlatePitch = 1.2;

/// Returns the plates sorted by their numbers if these are 1, 2, 3, ... in some order; otherwise in
/// the order of the file.
std::vector<const PlateSettings*> InOrder(const std::vector<PlateSettings>& plates) {
  std::vector<const PlateSettings*> order;
  for (const PlateSettings& plate : plates) order.push_back(&plate);
  std::vector<const PlateSettings*> by_number = order;
  std::stable_sort(by_number.begin(), by_number.end(),
                   [](const auto* a, const auto* b) { return a->number < b->number; });
  for (size_t i = 0; i < by_number.size(); ++i)
    if (by_number[i]->number != static_cast<int64_t>(i) + 1) return order;
  return by_number;
}

class PlateLayout {
 public:
  PlateLayout(size_t count, const std::optional<BedBox>& bed)
      : columns_(static_cast<size_t>(std::ceil(std::sqrt(static_cast<double>(count))))),
        bed_(bed) {}

  /// Converts an instance's position from the common coordinate system to the coordinates of plate
  /// `index`.
  void TakeOff(size_t index, Instance& instance) const {
    if (index == 0) return;
    if (!bed_) {
      instance.placed = false;
      return;
    }
    instance.to_plate(0, 3) -= static_cast<double>(index % columns_) * kPlatePitch * bed_->size[0];
    instance.to_plate(1, 3) += static_cast<double>(index / columns_) * kPlatePitch * bed_->size[1];
  }

 private:
  size_t columns_;
  std::optional<BedBox> bed_;
};

std::optional<Member> Find(const PlateSettings::Member& named, const ItemsOfObject& items) {
  const auto object = items.find(named.object);
  if (object == items.end() || named.instance >= static_cast<int64_t>(object->second.size()))
    return std::nullopt;
  return object->second[static_cast<size_t>(named.instance)];
}

}  // namespace

void AddPlates(const std::vector<PlateSettings>& plates, const ItemsOfObject& items,
               Project& project, Notes& notes) {
  const PlateLayout layout(plates.size(), BedBoxOf(project.settings, "printable_area"));
  const std::vector<const PlateSettings*> order = InOrder(plates);
  std::set<std::pair<int32_t, int32_t>> on_plates;
  for (size_t i = 0; i < order.size(); ++i) {
    ProjectPlate plate;
    plate.name = order[i]->name;
    plate.settings = order[i]->settings;
    plate.locked = order[i]->locked;
    for (const PlateSettings::Member& named : order[i]->members) {
      const std::optional<Member> member = Find(named, items);
      if (!member || !on_plates.emplace(member->object, member->instance).second) {
        notes.Add("entries of plates that are missing or on another plate", {});
        continue;
      }
      layout.TakeOff(i, project.objects[member->object].instances[member->instance]);
      plate.members.push_back(*member);
    }
    project.plates.push_back(std::move(plate));
  }
  if (plates.empty()) return;
  for (const auto& [id, members] : items) {
    const bool all_on_plates = std::all_of(members.begin(), members.end(), [&](const Member& each) {
      return on_plates.contains({each.object, each.instance});
    });
    if (all_on_plates || members.empty()) continue;
    notes.Add("copies beside all plates", project.objects[members.front().object].name);
  }
}

}  // namespace slicefarm::slicing::threemf
