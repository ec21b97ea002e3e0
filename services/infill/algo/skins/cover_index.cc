#include "services/infill/algo/skins/cover_index.h"

#include <memory>
#include <vector>

namespace slicefarm::infill {
namespace {

/// Number of islands from which an outline has an index.
constexpr size_t kManyIslands = 32;

/// Returns the islands of a layer near a box. Without any, one island elsewhere stays, because an
/// empty outline would mean that the object ends in this layer.
MultiPolygon PartOf(const MultiPolygon& layer, const BoxIndex& index, const Box& box) {
  MultiPolygon near = IslandsNear(box, layer, index);
  if (near.empty()) near.push_back(layer.front());
  return near;
}

}  // namespace

CoverIndex::CoverIndex(const Cover& cover, const MultiPolygon* outline)
    : cover_(cover), outline_(outline) {
  for (const auto* layers : {&cover.above, &cover.below, &cover.bearers})
    for (const MultiPolygon* layer : *layers) Add(layer);
}

void CoverIndex::Add(const MultiPolygon* layer) {
  if (layer == nullptr || layer == outline_ || layer->size() < kManyIslands) return;
  if (!indices_.contains(layer)) indices_.emplace(layer, *layer);
}

Cover CoverIndex::Near(const Box& box) const {
  Cover near = cover_;
  if (indices_.empty()) return near;
  std::map<const MultiPolygon*, const MultiPolygon*> replaced;
  for (auto* layers : {&near.above, &near.below, &near.bearers}) {
    for (const MultiPolygon*& layer : *layers) {
      const auto index = indices_.find(layer);
      if (index == indices_.end()) continue;
      const MultiPolygon*& part = replaced[layer];
      if (part == nullptr)
        part = near.own
                   .emplace_back(
                       std::make_shared<const MultiPolygon>(PartOf(*layer, index->second, box)))
                   .get();
      layer = part;
    }
  }
  return near;
}

}  // namespace slicefarm::infill
