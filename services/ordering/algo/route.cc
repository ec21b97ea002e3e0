#include "services/ordering/algo/route.h"

#include <algorithm>

namespace slicefarm::ordering {

void Reverse(Path& path) {
  const ptrdiff_t kept = path.closed ? 1 : 0;
  std::reverse(path.points.begin() + kept, path.points.end());
  if (path.widths_nm.size() > 1) {
    std::reverse(path.widths_nm.begin() + kept, path.widths_nm.end());
  }
}

void Route::Print(Path path, bool reversed) {
  if (reversed) Reverse(path);
  at_ = EndOf(path);
  paths_.push_back(std::move(path));
}

void Route::PrintLoop(Path loop, LoopPlace start) {
  StartAt(start, loop);
  Print(std::move(loop));
}

}  // namespace slicefarm::ordering
