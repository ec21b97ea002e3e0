#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "common/base/from_environment_test.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/stage/object_layers.h"
#include "common/stage/slice_input_test.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "tests/corpus_file.h"
#include "tests/integration/region_raster_test.h"

/// Compares skins of real parts with skins that a raster builds from the same sections. Bare area
/// is fill area with no section above (below) it in one of the layers of a skin. A disc of bare
/// area must be solid. Area farther from bare area than anchors reach must be sparse.
/// Environment:
///   SLICEFARM_SKIN_CASES   number of the table's rows (2); the slow test takes all
///   SLICEFARM_SKIN_FIRST   the first of them (0)
namespace slicefarm::skin_oracle_test {
namespace {

constexpr double kWidthNm = 450'000;
/// Radius of a disc of bare area that must be solid, except for the resolution of the raster.
constexpr double kDiscNm = 300'000;
constexpr double kSeamNm = 150'000;
/// Distance that bridges over sparse infill extend beyond skins: a pitch of its lines at 20 %, and
/// a bead.
constexpr double kCellNm = 2'700'000;
/// Distance that skins may extend beyond bare area: two beads, and twice this at the tip of a
/// miter.
constexpr double kAnchorNm = 2 * 2 * kWidthNm;
/// Radius of a disc of sparse area. Smaller areas may be solid.
constexpr double kSparseDiscNm = 3 * kWidthNm;

struct Case {
  std::string model;
  double turn_deg = 0;
  double height_mm = 0.2;
  int32_t walls = 3;
  WallGenerator generator = WallGenerator::kArachne;
  int32_t skins = 5;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.model << ", turned by " << c.turn_deg << ", " << c.height_mm << " mm, " << c.walls
             << (c.generator == WallGenerator::kArachne ? " walls, " : " classic walls, ")
             << c.skins << " + " << c.skins << " layers";
}

/// Part with its walls.
struct Part {
  std::vector<SlicedLayer> layers;
  std::vector<WalledLayer> walled;
};

absl::StatusOr<Part> PartOf(const Case& c) {
  SlicingOptions slicing;
  slicing.objects[0].layer_height_nm = FromMm(c.height_mm);
  slicing.thumbnails.clear();
  const MeshFile file{c.model, MeshFormat::kUnknown, CorpusFile("models/" + c.model + ".stl")};
  auto job = slicing::MakeLocalSlicing()->Slice(
      {}, InputOf({file}, {{.rotate_deg = {0, 0, c.turn_deg}}}), slicing);
  if (!job.ok()) return job.status();
  const BeadingOptions walls{.generator = c.generator, .perimeters = c.walls};
  const LayerRange range{0, static_cast<int32_t>(job->layers.size())};
  auto walled = beading::MakeLocalBeading()->Bead({}, {range, job->layers}, BeadingTable{walls});
  if (!walled.ok()) return walled.status();
  return Part{std::move(job->layers), *std::move(walled)};
}

absl::StatusOr<std::vector<FilledLayer>> Filled(const Part& part, int32_t skins) {
  InfillOptions options;
  options.top_solid_layers = options.bottom_solid_layers = skins;
  const LayerRange range{0, static_cast<int32_t>(part.layers.size())};
  const std::vector<LayerPlan> plans(part.layers.size());
  return infill::MakeLocalInfill()->Fill({}, part.walled, {range, part.layers}, plans,
                                         InfillTable{options});
}

MultiPolygon FillAreaOf(const WalledLayer& layer) {
  MultiPolygon area;
  for (const WalledSection& section : layer.sections)
    for (const WalledIsland& island : section.islands)
      for (const FillArea& fill : island.fill_areas)
        area.insert(area.end(), fill.area.begin(), fill.area.end());
  return area;
}

bool IsSolid(Feature feature) {
  return feature == Feature::kSolidInfill || feature == Feature::kTopSolidInfill ||
         feature == Feature::kBridgeInfill;
}

/// Calls visit(path, from, to) for each edge of each line of infill.
template <typename Visit>
void ForEachLine(const FilledLayer& layer, Visit visit) {
  for (const FilledSection& section : layer.sections)
    for (const FilledIsland& island : section.islands)
      for (const FillGroup& group : island.fills)
        for (const Path& path : group.paths) {
          for (size_t i = 0; i + 1 < path.points.size(); ++i)
            visit(path, path.points[i], path.points[i + 1]);
          if (path.closed) visit(path, path.points.back(), path.points.front());
        }
}

/// Returns the length of an edge in a region, mm.
double LengthIn(const Raster& region, Point a, Point b) {
  const double length = Distance(a, b);
  const int steps = static_cast<int>(length / 50'000) + 1;
  int held = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps;
    held += region.Holds({a.x + std::llround(t * static_cast<double>(b.x - a.x)),
                          a.y + std::llround(t * static_cast<double>(b.y - a.y))});
  }
  return ToMm(length) * held / steps;
}

/// Computes from a raster the areas of each layer that must be solid, and the areas that must not
/// be.
class SkinOracle {
 public:
  SkinOracle(const Part& part, int32_t skins) : part_(part), skins_(skins) {
    Box box;
    for (const SlicedLayer& layer : part.layers)
      for (const ObjectSection& section : layer.sections)
        for (const PolygonWithHoles& island : OutlineOf(section))
          for (const Point p : island.outer) box.Add(p);
    frame_ = FrameAround(box, 1'000'000, 100'000);
  }

  struct Due {
    Raster solid;
    Raster sparse;
  };
  Due Of(int32_t layer) {
    Raster fill(frame_);
    fill.Fill(FillAreaOf(part_.walled[static_cast<size_t>(layer)]));
    Due due{Raster(frame_), fill};
    Raster bare(frame_);
    for (int32_t i = -skins_; i <= skins_; ++i) {
      if (i == 0) continue;
      Raster missing = fill;
      missing -= OutlineAt(layer + i);
      if (missing.Empty()) continue;
      due.solid |= missing.Grown(-kDiscNm).Grown(kDiscNm - kSeamNm);
      bare |= missing;
    }
    if (!bare.Empty()) {
      due.sparse -= bare.Grown(kAnchorNm);
      due.sparse = due.sparse.Grown(-kSparseDiscNm).Grown(kSparseDiscNm - kSeamNm);
    }
    outlines_.erase(outlines_.begin(), outlines_.lower_bound(layer - skins_));
    return due;
  }

  const RasterFrame& frame() const { return frame_; }

 private:
  const Raster& OutlineAt(int32_t layer) {
    const auto [found, fresh] = outlines_.try_emplace(layer, frame_);
    if (fresh && layer >= 0 && layer < static_cast<int32_t>(part_.layers.size()))
      for (const ObjectSection& section : part_.layers[static_cast<size_t>(layer)].sections)
        found->second.Fill(OutlineOf(section));
    return found->second;
  }

  const Part& part_;
  const int32_t skins_;
  RasterFrame frame_;
  std::map<int32_t, Raster> outlines_;
};

/// Errors in the lines of a layer.
struct Faults {
  double sparse_mm = 0;  ///< sparse lines in solid areas
  /// Solid lines in sparse areas; for bridges: farther than a cell from solid areas.
  double solid_mm = 0;
  double open_mm2 = 0;  ///< solid areas with no solid line near
};

Faults FaultsOf(const FilledLayer& layer, const SkinOracle::Due& due, const RasterFrame& frame) {
  Faults faults;
  Raster open = due.solid, solid(frame);
  const Raster far = due.sparse.Grown(-kCellNm);
  const bool any = !open.Empty();
  ForEachLine(layer, [&](const Path& path, Point a, Point b) {
    if (path.feature == Feature::kInternalInfill) faults.sparse_mm += LengthIn(due.solid, a, b);
    if (!IsSolid(path.feature)) return;
    faults.solid_mm += LengthIn(path.feature == Feature::kBridgeInfill ? far : due.sparse, a, b);
    if (any) solid.Stroke(a, b, 1.5 * kWidthNm);
  });
  open -= solid;
  faults.open_mm2 = open.AreaMm2();
  return faults;
}

/// Checks the skins of a case. Returns the area that had to be solid, in mm2.
double ExpectSkins(const Case& c) {
  SCOPED_TRACE(testing::PrintToString(c));
  const auto part = PartOf(c);
  EXPECT_TRUE(part.ok()) << part.status();
  if (!part.ok()) return 0;
  const auto filled = Filled(*part, c.skins);
  EXPECT_TRUE(filled.ok()) << filled.status();
  if (!filled.ok()) return 0;
  SkinOracle oracle(*part, c.skins);
  double due_mm2 = 0;
  for (size_t i = 0; i < filled->size(); ++i) {
    const SkinOracle::Due due = oracle.Of(static_cast<int32_t>(i));
    due_mm2 += due.solid.AreaMm2();
    const Faults faults = FaultsOf((*filled)[i], due, oracle.frame());
    EXPECT_LT(faults.sparse_mm, 0.5) << "layer " << i;
    EXPECT_LT(faults.solid_mm, 0.5) << "layer " << i;
    EXPECT_LT(faults.open_mm2, 0.1) << "layer " << i;
  }
  return due_mm2;
}

std::vector<Case> Table() {
  using enum WallGenerator;
  std::vector<Case> cases = {{"cable_cover", 0, 0.25, 2, kArachne, 4},
                             {"printhead_rear", 23, 0.25, 3, kArachne, 4}};
  for (const char* model : {"busted", "textbox", "featuretype", "thin_walls", "spot", "cable_cover",
                            "printhead_rear", "mini_x_carriage", "benchy"})
    for (const double turn_deg : {0.0, 23.0, 90.0})
      for (const double height_mm : {0.1, 0.2, 0.25})
        for (int32_t walls = 1; walls <= 5; ++walls)
          cases.push_back({model, turn_deg, height_mm, walls,
                           (walls + static_cast<int>(turn_deg)) % 2 ? kArachne : kClassic,
                           walls % 2 ? 4 : 5});
  return cases;
}

TEST(SkinOracle, SkinsAreWhereSectionsEnd) {
  const std::vector<Case> cases = Table();
  const auto count = static_cast<size_t>(FromEnvironment("SLICEFARM_SKIN_CASES", 2));
  const auto first = static_cast<size_t>(FromEnvironment("SLICEFARM_SKIN_FIRST", 0));
  double due_mm2 = 0;
  for (size_t i = first; i < std::min(first + count, cases.size()); ++i)
    due_mm2 += ExpectSkins(cases[i]);
  EXPECT_GT(due_mm2, 1);
}

/// Moves each corner by up to 20 nm.
void AddNoise(MultiPolygon& region, std::minstd_rand& random) {
  const auto move = [&random](Polygon& ring) {
    for (Point& p : ring) {
      p.x += static_cast<Coord>(random() % 41) - 20;
      p.y += static_cast<Coord>(random() % 41) - 20;
    }
  };
  for (PolygonWithHoles& island : region) {
    move(island.outer);
    for (Polygon& hole : island.holes) move(hole);
  }
}

Part Noisy(Part part, uint32_t seed) {
  std::minstd_rand random(seed);
  for (SlicedLayer& layer : part.layers)
    for (ObjectSection& section : layer.sections)
      for (Region& region : section.regions) AddNoise(region.outlines, random);
  for (WalledLayer& layer : part.walled)
    for (WalledSection& section : layer.sections)
      for (WalledIsland& island : section.islands)
        for (FillArea& fill : island.fill_areas) AddNoise(fill.area, random);
  return part;
}

std::map<Feature, double> AreasOf(const std::vector<FilledLayer>& layers) {
  std::map<Feature, double> areas;
  for (const FilledLayer& layer : layers)
    for (const FilledSection& section : layer.sections)
      for (const FillStats& use : section.uses) areas[use.feature] += use.area_mm2;
  return areas;
}

/// Area that may change between features where a place is exactly as wide as a bead.
constexpr double kDotMm2 = 0.25;

/// Returns the area that may change at bridges. Skins over sparse infill are bridged by whole
/// cells, so noise may add or remove a cell.
double CellsMm2(Feature feature, const std::map<Feature, double>& areas) {
  const auto bridges = areas.find(Feature::kBridgeInfill);
  const bool is_concerned = feature == Feature::kBridgeInfill || feature == Feature::kSolidInfill ||
                            feature == Feature::kInternalInfill;
  return is_concerned && bridges != areas.end() ? 0.04 * bridges->second : 0;
}

// In an upright part, edges of many layers coincide.
TEST(SkinOracle, NoiseOfSomeNanometresMovesNoSkin) {
  for (const char* model : {"cable_cover", "printhead_rear", "featuretype"}) {
    const auto part = PartOf({model, 23, 0.25});
    ASSERT_TRUE(part.ok()) << part.status();
    const auto plain = Filled(*part, 5);
    ASSERT_TRUE(plain.ok()) << plain.status();
    const std::map<Feature, double> areas = AreasOf(*plain);
    for (uint32_t seed = 1; seed <= 3; ++seed) {
      const auto noisy = Filled(Noisy(*part, seed), 5);
      ASSERT_TRUE(noisy.ok()) << noisy.status();
      for (const auto& [feature, area] : AreasOf(*noisy))
        EXPECT_NEAR(area, areas.at(feature), kDotMm2 + 0.001 * area + CellsMm2(feature, areas))
            << model << ' ' << FeatureName(feature) << ' ' << seed;
    }
  }
}

}  // namespace
}  // namespace slicefarm::skin_oracle_test
