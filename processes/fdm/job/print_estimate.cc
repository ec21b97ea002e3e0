#include "processes/fdm/job/print_estimate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::coordinator {
namespace {

constexpr double kSharpTurnRad = 0.5;
constexpr double kMm2PerNm2 = 1e-12;

/// Area, perimeter and corners of the outlines of a layer, in mm.
struct LayerShape {
  double area = 0;
  double perimeter = 0;
  double sharp_corners = 0;
  double islands = 0;
};

bool IsSharp(Point before, Point at, Point after) {
  const double in = Atan2(ToMm(at.y - before.y), ToMm(at.x - before.x));
  const double out = Atan2(ToMm(after.y - at.y), ToMm(after.x - at.x));
  return std::abs(std::remainder(out - in, 2 * std::numbers::pi)) > kSharpTurnRad;
}

void AddRing(const Polygon& ring, LayerShape& shape) {
  shape.perimeter += Perimeter(ring) / kNmPerMm;
  const size_t n = ring.size();
  for (size_t i = 0; i < n; ++i) {
    if (IsSharp(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n])) ++shape.sharp_corners;
  }
}

LayerShape ShapeOf(const ObjectSection& section) {
  LayerShape shape;
  const MultiPolygon& outlines = OutlineOf(section);
  shape.area = Area(outlines) * kMm2PerNm2;
  shape.islands = static_cast<double>(outlines.size());
  ForEachRing(outlines, [&](const Polygon& ring) { AddRing(ring, shape); });
  return shape;
}

/// Returns a lower bound of the area of layer `index` that is exposed. A point is exposed if one of
/// the `reach` layers above (step 1) or below (step -1) does not cover it. The bound assumes that
/// smaller layers are completely inside larger ones.
double Exposed(std::span<const LayerShape> shapes, std::ptrdiff_t index, int step, int reach) {
  const double area = shapes[index].area;
  double covered = area;
  for (int k = 1; k <= reach; ++k) {
    const std::ptrdiff_t other = index + k * step;
    const bool air = other < 0 || other >= std::ssize(shapes);
    covered = std::min(covered, air ? 0 : shapes[other].area);
  }
  return area - covered;
}

/// Lines of one kind in a layer.
struct Lines {
  Feature feature = Feature::kPerimeter;
  double length_mm = 0;
  double stops = 0;
};

class SectionEstimate {
 public:
  /// Estimates one section of one object with the settings of `row`.
  SectionEstimate(const LayerShape& shape, double exposed_mm2, const LayerFrame& frame,
                  const FdmSettings& settings, size_t row)
      : shape_(shape), frame_(frame), settings_(settings), speeds_(settings.regions[row].motion) {
    const BeadingOptions& beading = settings.regions[row].walls;
    const InfillOptions& infill = settings.regions[row].infill;
    const double height = ToMm(static_cast<double>(frame.height_nm));
    const double wall = Spacing(beading.inner_width_nm);
    const int32_t walls = beading.perimeters;
    const double wall_area = std::min(shape.area, walls * wall * shape.perimeter);
    const double inside = shape.area - wall_area;
    const double solid = std::min(inside, exposed_mm2);
    const double sparse = (inside - solid) * infill.density;
    const double outer = std::min(shape.perimeter, wall_area / wall);
    Add({Feature::kExternalPerimeter, outer, shape.sharp_corners});
    Add({Feature::kPerimeter, wall_area / wall - outer, shape.sharp_corners * (walls - 1)});
    AddFill(Feature::kSolidInfill, solid, Spacing(infill.solid_width_nm));
    AddFill(Feature::kInternalInfill, sparse, Spacing(infill.sparse_width_nm));
    AddTravels(walls + 1);
    volume_mm3_ = (wall_area + solid + sparse) * height;
  }

  double volume_mm3() const { return volume_mm3_; }

  double time_s() const { return time_s_; }

 private:
  /// Returns the spacing of adjacent beads, in mm. A bead is a rectangle with round ends (see
  /// bead_section.h), and the spacing is its mean width.
  double Spacing(Coord width_nm) const {
    return ToMm(width_nm) - ToMm(frame_.height_nm) * (1 - std::numbers::pi / 4);
  }

  double SpeedOf(Feature feature) const {
    const double speed = speeds_.speed_mm_s[static_cast<size_t>(feature)];
    const double first = settings_.machine.motion.first_layer_speed_mm_s;
    return frame_.index == 0 && first > 0 ? std::min(speed, first) : speed;
  }

  void Add(const Lines& lines) {
    const double speed = SpeedOf(lines.feature);
    const double stop_s = speed / settings_.machine.motion.limits.max_acceleration_extruding_mm_s2;
    time_s_ += lines.length_mm / speed + lines.stops * stop_s;
  }

  /// Adds lines across the islands, with a full stop at both ends. Their length is the mean chord:
  /// pi area / perimeter (Crofton).
  void AddFill(Feature feature, double area_mm2, double spacing_mm) {
    if (area_mm2 <= 0) return;
    const double length = area_mm2 / spacing_mm;
    const double chord = std::numbers::pi * shape_.area / shape_.perimeter;
    Add({feature, length, 2 * length / chord});
  }

  void AddTravels(int an_island) {
    const double distance = std::sqrt(shape_.area) / 2;
    const RetractionOptions& retraction = settings_.tools.front().retraction;
    double each_s = distance / settings_.machine.motion.travel_speed_mm_s;
    if (distance > retraction.min_travel_mm)
      each_s += retraction.length_mm / retraction.speed_mm_s +
                retraction.length_mm / retraction.restart_speed_mm_s;
    time_s_ += shape_.islands * an_island * each_s;
  }

  const LayerShape& shape_;
  const LayerFrame& frame_;
  const FdmSettings& settings_;
  const RegionMotion& speeds_;
  double time_s_ = 0;
  double volume_mm3_ = 0;
};

double FilamentMm(double volume_mm3, const MotionOptions& motion) {
  const double radius = motion.tool().filament_diameter_mm / 2;
  return volume_mm3 * motion.tool().extrusion_multiplier / (std::numbers::pi * radius * radius);
}

/// Layers of one object, from the bottom up.
struct ObjectShapes {
  std::vector<LayerShape> shapes;
  std::vector<LayerFrame> frames;
  std::vector<size_t> rows;  ///< settings row of the first region of each section
};

std::map<int32_t, ObjectShapes> ShapesByObject(std::span<const SlicedLayer> layers) {
  std::map<int32_t, ObjectShapes> objects;
  for (const SlicedLayer& layer : layers) {
    for (const ObjectSection& section : layer.sections) {
      if (!section.stack.IsPart()) continue;
      ObjectShapes& object = objects[section.stack.object];
      object.shapes.push_back(ShapeOf(section));
      object.frames.push_back({layer.frame.index, layer.frame.print_z_nm, section.height_nm});
      const int32_t row = section.regions.empty() ? 0 : section.regions.front().settings;
      object.rows.push_back(static_cast<size_t>(row));
    }
  }
  return objects;
}

std::map<int32_t, int> CopiesByObject(std::span<const PlacedCopy> copies) {
  std::map<int32_t, int> count;
  for (const PlacedCopy& copy : copies) ++count[copy.object];
  return count;
}

/// Returns the time of a layer after the slowdown that cooling requires.
double CooledTime(double time_s, double area_mm2, const CoolingOptions& cooling) {
  if (!cooling.enabled || area_mm2 == 0) return time_s;
  return std::max(time_s, cooling.slowdown_below_layer_time_s);
}

}  // namespace

std::vector<LayerEstimate> EstimateLayers(const SlicedOutlines& job, const FdmSettings& settings) {
  std::map<int32_t, int> copies = CopiesByObject(job.copies);
  const bool one_by_one = settings.machine.plan.sequence.complete_objects;
  const CoolingOptions& cooling = settings.tools.front().cooling;
  std::vector<LayerEstimate> layers(job.layers.size());
  std::vector<double> areas(job.layers.size(), 0);
  for (const auto& [index, object] : ShapesByObject(job.layers)) {
    const double count = copies[index];
    for (std::ptrdiff_t i = 0; i < std::ssize(object.shapes); ++i) {
      const auto at = static_cast<size_t>(i);
      const InfillOptions& infill = settings.regions[object.rows[at]].infill;
      const double exposed = Exposed(object.shapes, i, 1, infill.top_solid_layers) +
                             Exposed(object.shapes, i, -1, infill.bottom_solid_layers);
      const SectionEstimate section(object.shapes[at], exposed, object.frames[at], settings,
                                    object.rows[at]);
      const double area = object.shapes[at].area;
      const auto layer = static_cast<size_t>(object.frames[at].index);
      layers[layer].time_s +=
          count * (one_by_one ? CooledTime(section.time_s(), area, cooling) : section.time_s());
      layers[layer].volume_mm3 += count * section.volume_mm3();
      areas[layer] += area;
    }
  }
  if (!one_by_one)
    for (size_t i = 0; i < layers.size(); ++i)
      layers[i].time_s = CooledTime(layers[i].time_s, areas[i], cooling);
  return layers;
}

JobEstimate EstimatePrint(const SlicedOutlines& job, const FdmSettings& settings) {
  JobEstimate estimate;
  ProgramStats total;
  FeatureUse& all = total.features[0];
  for (const LayerEstimate& layer : EstimateLayers(job, settings)) {
    estimate.print_time_s += layer.time_s;
    all.volume_mm3 += layer.volume_mm3;
  }
  const MotionOptions motion = MotionOf(settings);
  all.filament_mm = FilamentMm(all.volume_mm3, motion);
  estimate.filament = FilamentUseOf(total, motion);
  return estimate;
}

}  // namespace slicefarm::coordinator
