#include "services/planning/algo/support/support_heights.h"

#include <algorithm>
#include <utility>

namespace slicefarm::planning {
namespace {

/// Tops that differ by less are one.
constexpr Coord kSameNm = 1'000;

/// Adds layers from the top of the last one to `top_nm`.
void FillUpTo(Coord top_nm, const SupportOptions& options, std::vector<SupportHeight>& layers) {
  Coord from = layers.empty() ? 0 : layers.back().top_nm;
  if (layers.empty() && top_nm > options.first_layer_height_nm + kSameNm &&
      top_nm - options.first_layer_height_nm >= options.min_layer_height_nm) {
    layers.push_back({0, options.first_layer_height_nm});
    from = options.first_layer_height_nm;
  }
  const Coord rise = top_nm - from;
  if (rise <= 0) return;
  const Coord most = std::max<Coord>(1, options.layer_height_nm + kSameNm);
  const Coord count = (rise + most - 1) / most;
  for (Coord i = 0; i < count; ++i)
    layers.push_back({from + rise * i / count, from + rise * (i + 1) / count});
}

/// The tops that overhangs ask for: by height, each with the layers of the part that ask for it.
std::vector<std::pair<Coord, size_t>> TopsWanted(const SupportProblem& problem,
                                                 const std::vector<Overhang>& overhangs,
                                                 const SupportOptions& options) {
  std::vector<std::pair<Coord, size_t>> tops;
  for (size_t i = 0; i < overhangs.size(); ++i) {
    if (overhangs[i].contact.empty()) continue;
    Coord top = problem.part[i].bottom_nm() - options.top_gap_nm;
    if (options.synchronize_layers) {
      const auto above =
          std::partition_point(problem.part.begin(), problem.part.end(),
                               [&](const PartLayer& l) { return l.top_nm <= top + kSameNm; });
      if (above == problem.part.begin()) continue;
      top = std::prev(above)->top_nm;
    }
    if (top >= options.min_layer_height_nm) tops.push_back({top, i});
  }
  return tops;
}

/// Layers at the part's own heights up to `top_nm`.
std::vector<SupportHeight> PartHeights(const SupportProblem& problem, Coord top_nm) {
  std::vector<SupportHeight> layers;
  for (const PartLayer& layer : problem.part)
    if (layer.top_nm <= top_nm) layers.push_back({layer.bottom_nm(), layer.top_nm});
  return layers;
}

}  // namespace

SupportHeights HeightsFor(const SupportProblem& problem, const std::vector<Overhang>& overhangs,
                          const SupportOptions& options) {
  SupportHeights heights;
  heights.under.assign(overhangs.size(), -1);
  const auto tops = TopsWanted(problem, overhangs, options);
  if (tops.empty()) return heights;
  if (options.synchronize_layers) {
    heights.layers = PartHeights(problem, tops.back().first);
  }
  for (const auto& [top, part_layer] : tops) {
    std::vector<SupportHeight>& layers = heights.layers;
    if (options.synchronize_layers) {
      const auto at = std::partition_point(layers.begin(), layers.end(),
                                           [&, top = top](const auto& l) { return l.top_nm < top; });
      heights.under[part_layer] = static_cast<int32_t>(at - layers.begin());
      continue;
    }
    if (layers.empty() || top - layers.back().top_nm >= options.min_layer_height_nm)
      FillUpTo(top, options, layers);
    heights.under[part_layer] = static_cast<int32_t>(layers.size()) - 1;
  }
  return heights;
}

}  // namespace slicefarm::planning
