#include "services/ordering/algo/route.h"

#include <algorithm>
#include <utility>

#include "services/ordering/algo/near_links.h"

namespace slicefarm::ordering {

void Reverse(Path& path) {
  const ptrdiff_t kept = path.closed ? 1 : 0;
  std::reverse(path.points.begin() + kept, path.points.end());
  if (path.widths_nm.size() > 1) {
    std::reverse(path.widths_nm.begin() + kept, path.widths_nm.end());
  }
}

void Route::Enter(const RouteEdges& edges) {
  edges_ = edges;
  is_linkable_ = false;
}

/// Returns true if a link to `next` would shorten an inner loop although the rules forbid this
/// (RouteEdges::whole_loops).
bool Route::IsKeptWhole(const Path& next) const {
  const auto is_inner = [](const Path& path) { return path.feature == Feature::kPerimeter; };
  return edges_.whole_loops &&
         ((last_is_loop_ && is_inner(paths_.back())) || (next.closed && is_inner(next)));
}

void Route::Print(Path path, bool reversed) {
  if (reversed) Reverse(path);
  const bool is_loop = path.closed;
  if (is_linkable_ && edges_.for_links != nullptr && !IsKeptWhole(path)) {
    auto link = LinkBetween({paths_.back(), last_is_loop_}, path, height_nm_, *edges_.for_links);
    if (link) paths_.push_back(*std::move(link));
  }
  at_ = EndOf(path);
  is_linkable_ = true;
  last_is_loop_ = is_loop;
  paths_.push_back(std::move(path));
}

void Route::PrintLoop(Path loop, LoopPoint start) {
  StartAt(start, loop);
  Print(std::move(loop));
}

}  // namespace slicefarm::ordering
