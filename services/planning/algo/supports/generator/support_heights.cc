#include "services/planning/algo/supports/generator/support_heights.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "common/model/options/support_options.h"

namespace slicefarm::planning {
namespace {

/// Difference below which two tops count as equal.
constexpr Coord kSameNm = 1'000;

/// Distances within which a top snaps to a layer of the part. A layer between contacts may move up
/// or down. A contact moves only down, and by less.
constexpr Coord kSnapNm = 20'000, kSnapContactNm = 8'000;

/// Returns the top of the part's layer nearest to `top_nm` in [top_nm - below_nm, top_nm +
/// above_nm], or `top_nm` if there is none. Otherwise two nearly equal heights would add a useless
/// layer to the print.
Coord Snapped(Coord top_nm, Coord below_nm, Coord above_nm, const SupportProblem& problem) {
  const auto from =
      std::ranges::lower_bound(problem.part, top_nm - below_nm, {}, &PartLayer::top_nm);
  Coord nearest = top_nm, least = below_nm + above_nm + 1;
  for (auto layer = from; layer != problem.part.end() && layer->top_nm <= top_nm + above_nm;
       ++layer) {
    const Coord distance = std::abs(layer->top_nm - top_nm);
    if (distance < least) nearest = layer->top_nm;
    least = std::min(least, distance);
  }
  return nearest;
}

/// Adds layers of equal height from the top of the last one to `top_nm`.
void FillEvenly(Coord top_nm, const SupportProblem& problem, const SupportOptions& options,
                std::vector<SupportHeight>& layers) {
  const Coord from = layers.back().top_nm;
  const Coord rise = top_nm - from;
  if (rise < std::max<Coord>(1, options.min_layer_height_nm)) return;
  const Coord most = std::max<Coord>(1, options.layer_height_nm + kSameNm);
  const Coord count = (rise + most - 1) / most;
  const Coord reach = std::min(kSnapNm, rise / count / 4);
  for (Coord i = 1; i < count; ++i)
    layers.push_back(
        {layers.back().top_nm, Snapped(from + rise * i / count, reach, reach, problem)});
  layers.push_back({layers.back().top_nm, top_nm});
}

/// Adds layers that end with the part's layers, as long as a layer that ends at `top_nm` still fits
/// above.
void FollowPart(Coord top_nm, const SupportProblem& problem, const SupportOptions& options,
                std::vector<SupportHeight>& layers) {
  const Coord from = layers.back().top_nm;
  for (auto layer = std::ranges::upper_bound(problem.part, from, {}, &PartLayer::top_nm);
       layer != problem.part.end() && layer->top_nm <= top_nm - options.min_layer_height_nm;
       ++layer) {
    const bool whole = layer->bottom_nm() == layers.back().top_nm;
    if (whole && layer->height_nm >= options.min_layer_height_nm)
      layers.push_back({layer->bottom_nm(), layer->top_nm});
    else
      FillEvenly(layer->top_nm, problem, options, layers);
  }
}

/// Adds layers from the top of the last one to `top_nm`. The first layer is as high as the part's
/// first layer, because the nozzle prints no lower layer.
void FillUpTo(Coord top_nm, const SupportProblem& problem, const SupportOptions& options,
              std::vector<SupportHeight>& layers) {
  if (layers.empty()) layers.push_back({0, options.first_layer_height_nm});
  if (options.style == SupportStyle::kTree) FollowPart(top_nm, problem, options, layers);
  FillEvenly(top_nm, problem, options, layers);
}

/// Returns the distance that a contact may move down to the top of a layer of the part. For
/// branches it is up to half a layer. So trees add no layers to the print if the gap is no multiple
/// of the part's layer heights.
Coord LowerBy(const SupportOptions& options) {
  return options.style == SupportStyle::kTree ? options.layer_height_nm / 2 : kSnapContactNm;
}

/// Returns the tops that overhangs require, sorted by height, each with the index of the
/// overhanging layer.
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
    if (!options.synchronize_layers) top = Snapped(top, LowerBy(options), 0, problem);
    if (top >= options.first_layer_height_nm - kSameNm) tops.push_back({top, i});
  }
  return tops;
}

/// Returns layers at the part's own heights up to `top_nm`.
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
      const auto at = std::partition_point(
          layers.begin(), layers.end(), [&, top = top](const auto& l) { return l.top_nm < top; });
      heights.under[part_layer] = static_cast<int32_t>(at - layers.begin());
      continue;
    }
    if (layers.empty() || top - layers.back().top_nm >= options.min_layer_height_nm)
      FillUpTo(top, problem, options, layers);
    heights.under[part_layer] = static_cast<int32_t>(layers.size()) - 1;
  }
  return heights;
}

}  // namespace slicefarm::planning
