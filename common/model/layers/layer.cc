#include "common/model/layers/layer.h"

#include <algorithm>

namespace slicefarm {
namespace {

template <typename Value>
double SumOver(const ProgramStats& stats, Value FeatureUse::*value) {
  double sum = 0;
  for (const FeatureUse& use : stats.features) sum += use.*value;
  return sum;
}

}  // namespace

LayerRange LayerRange::Grown(int32_t by, int32_t layer_count) const {
  return {std::max(0, first - by), std::min(layer_count, last + by)};
}

const MultiPolygon& OutlineOf(const ObjectSection& section) {
  return section.regions.size() == 1 ? section.regions.front().outlines : section.whole;
}

const MultiPolygon& MarkedIn(const ObjectSection& section, PartRole role) {
  static const MultiPolygon kNothing;
  const auto found = std::ranges::find(section.marks, role, &Mark::role);
  return found == section.marks.end() ? kNothing : found->outlines;
}

void FeatureUse::Add(const FeatureUse& other) {
  time_s += other.time_s;
  length_mm += other.length_mm;
  filament_mm += other.filament_mm;
  volume_mm3 += other.volume_mm3;
}

double ProgramStats::TimeS() const { return travel_time_s + SumOver(*this, &FeatureUse::time_s); }
double ProgramStats::FilamentMm() const { return SumOver(*this, &FeatureUse::filament_mm); }
double ProgramStats::VolumeMm3() const { return SumOver(*this, &FeatureUse::volume_mm3); }
double ProgramStats::ExtrudedMm() const { return SumOver(*this, &FeatureUse::length_mm); }

void ProgramStats::Add(const ProgramStats& other) {
  for (size_t i = 0; i < features.size(); ++i) features[i].Add(other.features[i]);
  travel_time_s += other.travel_time_s;
  retract_time_s += other.retract_time_s;
  travel_mm += other.travel_mm;
  travels += other.travels;
  retractions += other.retractions;
  bounds.Add(other.bounds);
}

bool OnlySupports(const SlicedLayer& layer) {
  bool supports = false;
  for (const ObjectSection& section : layer.sections) {
    if (section.regions.empty()) continue;
    if (section.stack.kind != StackKind::kSupport) return false;
    supports = true;
  }
  return supports;
}

}  // namespace slicefarm
