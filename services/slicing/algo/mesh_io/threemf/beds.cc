#include "services/slicing/algo/mesh_io/threemf/beds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "common/base/portable_math.h"
#include "services/slicing/algo/mesh_io/threemf/bed_box.h"

namespace slicefarm::slicing::threemf {
namespace {

using Cell = std::array<int64_t, 2>;  ///< column and row of a bed

/// Returns the cell of a bed. The first n * n beds fill a square. The next beds form a column at
/// its right, from the front, and then a row behind it.
Cell CellOf(size_t index) {
  auto side = static_cast<int64_t>(std::sqrt(static_cast<double>(index)));
  const int64_t rest = static_cast<int64_t>(index) - side * side;
  return rest < side ? Cell{side, rest} : Cell{rest - side, side};
}

class BedLayout {
 public:
  BedLayout(size_t count, const BedBox& bed) : count_(count), bed_(bed) {
    constexpr double kMostMm = 100;
    const double gap = std::min(kMostMm, Hypot(bed.size[0], bed.size[1]) * 0.3);
    pitch_ = {bed.size[0] + gap, bed.size[1] + gap};
  }

  std::optional<size_t> BedOf(const Instance& instance) const {
    Cell cell;
    for (int axis = 0; axis < 2; ++axis) {
      const double middle = bed_.min[axis] + bed_.size[axis] / 2;
      const double beds = std::round((instance.to_plate(axis, 3) - middle) / pitch_[axis]);
      // The value may be too large for an integer; in any project, it is at most the number of
      // beds.
      if (!(std::abs(beds) <= static_cast<double>(count_))) return std::nullopt;
      cell[axis] = static_cast<int64_t>(beds);
    }
    for (size_t index = 0; index < count_; ++index)
      if (CellOf(index) == cell) return index;
    return std::nullopt;
  }

  /// Converts an instance's position from the common coordinate system to the coordinates of bed
  /// `index`.
  void TakeOff(size_t index, Instance& instance) const {
    const Cell cell = CellOf(index);
    for (int axis = 0; axis < 2; ++axis)
      instance.to_plate(axis, 3) -= static_cast<double>(cell[axis]) * pitch_[axis];
  }

 private:
  size_t count_;
  BedBox bed_;
  std::array<double, 2> pitch_ = {0, 0};
};

}  // namespace

void AddBeds(const std::vector<PlateSettings>& beds, Project& project, Notes& notes) {
  const std::optional<BedBox> bed = BedBoxOf(project.settings, "bed_shape");
  if (beds.size() < 2 || !bed) return;
  const BedLayout layout(beds.size(), *bed);
  for (const PlateSettings& each : beds) project.plates.emplace_back().settings = each.settings;
  for (size_t i = 0; i < project.objects.size(); ++i) {
    SceneObject& object = project.objects[i];
    for (size_t copy = 0; copy < object.instances.size(); ++copy) {
      const std::optional<size_t> index = layout.BedOf(object.instances[copy]);
      if (!index) {
        notes.Add("copies beside all beds", object.name);
        continue;
      }
      layout.TakeOff(*index, object.instances[copy]);
      project.plates[*index].members.push_back(
          {static_cast<int32_t>(i), static_cast<int32_t>(copy)});
    }
  }
}

}  // namespace slicefarm::slicing::threemf
