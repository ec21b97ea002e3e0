#include "services/texture/algo/output/csv_text.h"

#include <fmt/format.h>

#include <iterator>

namespace slicefarm::texture {

std::string CsvRows(const LayerPath& path) {
  fmt::memory_buffer text;
  int64_t number = -1;
  bool before = true;
  for (const ToolPoint& point : path.points) {
    if (!point.on && before) ++number;
    before = point.on;
    const auto& [p, n, on] = point;
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", number, path.layer,
                   p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), on ? 1 : 0);
  }
  return fmt::to_string(text);
}

}  // namespace slicefarm::texture
