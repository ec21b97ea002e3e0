#include "processes/fdm/job/sampled_estimate.h"

#include <algorithm>
#include <numbers>
#include <set>

#include "common/model/options/motion_options.h"

namespace slicefarm::coordinator {
namespace {

constexpr int kSamples = 32;
constexpr size_t kMostAdded = 8;

/// Returns the ratio of a sample to the rough estimate of its layer; 0 if there is no rough
/// estimate.
double Ratio(double got, double rough) { return rough > 0 ? got / rough : 0; }

/// Sum over all layers.
class Sum {
 public:
  /// Adds layers without a sample. Their ratio to the rough estimate is interpolated between the
  /// samples before and after them.
  void AddGap(std::span<const double> rough, double ratio_before, double ratio_after) {
    const auto count = static_cast<double>(rough.size());
    for (size_t i = 0; i < rough.size(); ++i) {
      const double share = (static_cast<double>(i) + 1) / (count + 1);
      total_ += rough[i] * (ratio_before + share * (ratio_after - ratio_before));
    }
  }
  void AddSample(double got) { total_ += got; }
  double total() const { return total_; }

 private:
  double total_ = 0;
};

/// Returns the estimated total. `rough`: one per layer; `got`: one per sample.
double Total(std::span<const LayerSample> samples, std::span<const double> rough,
             std::span<const double> got) {
  Sum sum;
  size_t next = 0;  // index of the next layer
  double before = -1;
  for (size_t i = 0; i <= samples.size(); ++i) {
    const size_t end = i < samples.size() ? static_cast<size_t>(samples[i].layer) : rough.size();
    const double after = i < samples.size() ? Ratio(got[i], rough[end]) : before;
    // A layer without a rough estimate, such as a layer of a raft, gives no ratio for its
    // neighbours.
    const double from = before > 0 ? before : after;
    sum.AddGap(rough.subspan(next, end - next), from, after > 0 ? after : from);
    if (i == samples.size()) break;
    sum.AddSample(got[i]);
    if (after > 0) before = after;
    next = end + 1;
  }
  return sum.total();
}

}  // namespace

std::vector<int32_t> LayersToSample(std::span<const LayerEstimate> layers,
                                    std::span<const SlicedLayer> print) {
  std::set<int32_t> chosen = {0};
  for (const SlicedLayer& layer : print) {
    const bool added = std::ranges::any_of(layer.sections, [](const ObjectSection& section) {
      return !section.stack.IsPart() && !section.regions.empty();
    });
    if (added && chosen.size() <= kMostAdded) chosen.insert(layer.frame.index);
  }
  double all = 0;
  for (const LayerEstimate& layer : layers) all += layer.time_s;
  if (all <= 0) return {chosen.begin(), chosen.end()};
  double gone = 0;
  int taken = 0;
  for (size_t i = 0; i < layers.size(); ++i) {
    gone += layers[i].time_s;
    const int reached = static_cast<int>(gone / all * kSamples + 0.5);
    if (reached > taken) chosen.insert(static_cast<int32_t>(i));
    taken = std::max(taken, reached);
  }
  return {chosen.begin(), chosen.end()};
}

JobEstimate EstimateFrom(const LayerSamples& samples, std::span<const LayerEstimate> layers,
                         const MotionOptions& motion) {
  std::vector<double> times, volumes, got_times, got_filaments;
  for (const LayerEstimate& layer : layers) {
    times.push_back(layer.time_s);
    volumes.push_back(layer.volume_mm3);
  }
  for (const LayerSample& sample : samples.layers) {
    got_times.push_back(sample.time_s);
    got_filaments.push_back(sample.filament_mm);
  }
  JobEstimate estimate;
  estimate.print_time_s = samples.around_s + Total(samples.layers, times, got_times);
  ProgramStats total;
  FeatureUse& all = total.features[0];
  all.filament_mm = Total(samples.layers, volumes, got_filaments);
  const double radius_mm = motion.tool().filament_diameter_mm / 2;
  all.volume_mm3 = all.filament_mm * std::numbers::pi * radius_mm * radius_mm;
  estimate.filament = FilamentUseOf(total, motion);
  return estimate;
}

}  // namespace slicefarm::coordinator
