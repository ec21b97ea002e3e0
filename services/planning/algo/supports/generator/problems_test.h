#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/planning/algo/supports/generator/support_plan.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm::planning {

/// Stack of layers of 0.2 mm that stores its outlines and makes problems from them.
class TestStack {
 public:
  static constexpr Coord kHeightNm = 200'000;

  /// `outline`: returns the outline of a layer from the height of its middle, in mm.
  TestStack(int layers, const std::function<MultiPolygon(double)>& outline) {
    for (int i = 0; i < layers; ++i) outlines_.push_back(outline(0.2 * i + 0.1));
  }

  SupportProblem Problem() const {
    SupportProblem problem;
    for (size_t i = 0; i < outlines_.size(); ++i) {
      PartLayer layer;
      layer.top_nm = static_cast<Coord>(i + 1) * kHeightNm;
      layer.height_nm = kHeightNm;
      layer.outlines = &outlines_[i];
      problem.part.push_back(layer);
    }
    return problem;
  }
  std::vector<SolidLayer> Layers() const {
    std::vector<SolidLayer> layers;
    for (const PartLayer& layer : Problem().part) layers.push_back(layer);
    return layers;
  }
  std::vector<MultiPolygon>& outlines() { return outlines_; }

 private:
  std::vector<MultiPolygon> outlines_;
};

inline MultiPolygon BoxOf(double x0, double y0, double x1, double y1) {
  return {{{{FromMm(x0), FromMm(y0)},
            {FromMm(x1), FromMm(y0)},
            {FromMm(x1), FromMm(y1)},
            {FromMm(x0), FromMm(y1)}},
           {}}};
}

inline double AreaMm2(const MultiPolygon& region) { return Area(region) * 1e-12; }

/// Returns all support of the layer with its top at `top_nm`.
inline MultiPolygon SupportAt(const SupportPlan& plan, Coord top_nm) {
  MultiPolygon all;
  for (const SupportLayer& layer : plan.layers)
    if (layer.top_nm == top_nm)
      for (const SupportRegion& region : layer.regions) all = Union(all, region.outlines);
  return all;
}

inline double VolumeMm3(const SupportPlan& plan) {
  double volume = 0;
  for (const SupportLayer& layer : plan.layers)
    for (const SupportRegion& region : layer.regions)
      volume += AreaMm2(region.outlines) * ToMm(static_cast<double>(layer.height_nm));
  return volume;
}

}  // namespace slicefarm::planning
