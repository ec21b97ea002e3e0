#include "services/slicing/algo/holes/printable_overhangs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::slicing {
namespace {

/// Returns the holes of a layer that stay open.
MultiPolygon OpenHoles(const MultiPolygon& outlines, double most_mm2) {
  constexpr double kNm2PerMm2 = 1e12;
  MultiPolygon open;
  for (const PolygonWithHoles& island : outlines)
    for (const Polygon& hole : island.holes)
      if (-SignedArea(hole) <= most_mm2 * kNm2PerMm2)
        open.push_back({Polygon(hole.rbegin(), hole.rend()), {}});
  Canonicalize(open);
  return open;
}

/// Adds material to the region of a section with the settings of `like`.
void AddTo(const Region& like, const MultiPolygon& material, ObjectSection& section) {
  const auto same = std::ranges::find_if(section.regions, [&](const Region& region) {
    return region.role == like.role && region.settings == like.settings && region.tool == like.tool;
  });
  if (same != section.regions.end()) {
    same->outlines = Union(same->outlines, material);
    return;
  }
  Region& added = section.regions.emplace_back(like);
  added.outlines = material;
}

/// Adds the material below the layer `above` to the layer `here`.
void Underpin(const ObjectSection& above, const PrintableOverhangs& options, ObjectSection& here) {
  const double reach_nm = static_cast<double>(here.height_nm) * Tan(options.angle_rad);
  const MultiPolygon wanted = FastOffset(OutlineOf(above), -std::llround(reach_nm));
  MultiPolygon material = Difference(wanted, OutlineOf(here));
  if (material.empty()) return;
  if (options.hole_mm2 > 0)
    material = Difference(material, OpenHoles(OutlineOf(here), options.hole_mm2));
  if (material.empty()) return;
  const MultiPolygon whole = Union(OutlineOf(here), material);
  for (const Region& region : above.regions) {
    const MultiPolygon part =
        above.regions.size() == 1 ? material : Intersection(material, region.outlines);
    if (!part.empty()) AddTo(region, part, here);
  }
  here.whole = here.regions.size() > 1 ? whole : MultiPolygon{};
}

}  // namespace

void MakeOverhangsPrintable(const PrintableOverhangs& options,
                            std::span<ObjectSection* const> sections, const CancelToken& cancel) {
  constexpr double kUpright = std::numbers::pi / 2 - 1e-6;
  if (!options.on || options.angle_rad >= kUpright) return;
  for (size_t i = sections.size(); i-- > 1 && !cancel.Cancelled();)
    if (!sections[i]->hollow && !sections[i - 1]->hollow)
      Underpin(*sections[i], options, *sections[i - 1]);
}

}  // namespace slicefarm::slicing
