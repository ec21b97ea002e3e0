#include "services/lab/fill_files.h"

#include <fmt/core.h>

namespace slicefarm::lab {

std::string PrintFill(const std::vector<Path>& paths) {
  std::string text;
  const auto append = [&text](Point p) {
    text += fmt::format(" {:.6f} {:.6f}", ToMm(static_cast<double>(p.x)),
                        ToMm(static_cast<double>(p.y)));
  };
  for (const Path& path : paths) {
    text += std::to_string(path.points.size() + (path.closed ? 1 : 0));
    for (const Point p : path.points) append(p);
    if (path.closed) append(path.points.front());
    text += '\n';
  }
  return text;
}

}  // namespace slicefarm::lab
