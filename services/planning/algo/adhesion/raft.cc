#include "services/planning/algo/adhesion/raft.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "common/geometry/offset.h"

namespace slicefarm::planning {
namespace {

/// By how much a layer below another stands out.
constexpr Coord kStepNm = 500'000;

MultiPolygon Grown(const MultiPolygon& region, Coord by_nm) {
  return Offset(region, by_nm, {.join = Join::kRound});
}

/// Whatever differs between the layers: where a layer stands in the pile.
class Pile {
 public:
  Pile(const MultiPolygon& carried, const RaftOptions& options)
      : options_(options),
        base_layers_(options.layers - (options.layers + 1) / 2),
        top_(Grown(carried, options.expansion_nm)),
        middle_(options.layers > 2 ? Grown(top_, kStepNm) : MultiPolygon{}) {}

  RaftLayer Layer(int32_t i) const {
    return {.height_nm = Height(i),
            .region = Region(i),
            .density = Density(i),
            .angle_rad = Angle(i),
            .interface = i >= base_layers_};
  }

 private:
  Coord Height(int32_t i) const {
    if (i == 0) return options_.first_layer_height_nm;
    return std::max(options_.layer_height_nm, options_.nozzle_diameter_nm * 3 / 4);
  }

  MultiPolygon Region(int32_t i) const {
    if (i + 1 == options_.layers) return top_;
    if (i == 0) return Grown(top_, options_.first_layer_expansion_nm);
    return middle_;
  }

  double Density(int32_t i) const {
    if (i >= base_layers_) return 1;
    if (i == 0) return options_.first_layer_density;
    const auto width = static_cast<double>(options_.line_width_nm);
    return width / (width + static_cast<double>(options_.base_spacing_nm));
  }

  double Angle(int32_t i) const {
    const bool across = i >= base_layers_ || (i == 0 && base_layers_ > 1);
    return options_.angle_rad + (across ? std::numbers::pi / 2 : 0);
  }

  const RaftOptions& options_;
  int32_t base_layers_;
  MultiPolygon top_;
  MultiPolygon middle_;
};

}  // namespace

Raft RaftUnder(const MultiPolygon& carried, const RaftOptions& options) {
  Raft raft;
  if (options.layers <= 0 || carried.empty()) return raft;
  const Pile pile(carried, options);
  Coord z_nm = 0;
  for (int32_t i = 0; i < options.layers; ++i) {
    RaftLayer layer = pile.Layer(i);
    layer.print_z_nm = z_nm += layer.height_nm;
    raft.layers.push_back(std::move(layer));
  }
  raft.part_shift_nm = z_nm + options.contact_distance_nm;
  return raft;
}

}  // namespace slicefarm::planning
