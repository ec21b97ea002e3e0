#include "services/lab/bead_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <system_error>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "services/cli/console/files.h"

namespace slicefarm::lab {
namespace {

namespace fs = std::filesystem;

constexpr double kMaxMm = 2'000;
constexpr int64_t kMaxOutlineBytes = int64_t{256} << 20;

class NumberReader {
 public:
  explicit NumberReader(std::string_view text) : text_(text) {}

  bool AtEnd() {
    const size_t start = text_.find_first_not_of(" \t\r\n");
    text_.remove_prefix(start == std::string_view::npos ? text_.size() : start);
    return text_.empty();
  }
  template <typename Number>
  bool Read(Number& number) {
    if (AtEnd()) return false;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), number);
    if (error != std::errc()) return false;
    text_.remove_prefix(static_cast<size_t>(end - text_.data()));
    return true;
  }
  size_t left() const { return text_.size(); }

 private:
  std::string_view text_;
};

bool ReadPoint(NumberReader& reader, Point& point) {
  double x = 0, y = 0;
  if (!reader.Read(x) || !reader.Read(y)) return false;
  if (!(std::abs(x) <= kMaxMm && std::abs(y) <= kMaxMm)) return false;
  point = {FromMm(x), FromMm(y)};
  return true;
}

absl::Status NotOutlines(size_t ring) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed,
                   fmt::format("ring {} is not a number of points followed by as many pairs of "
                               "coordinates, in mm and at most {} from 0",
                               ring, kMaxMm));
}

}  // namespace

absl::StatusOr<MultiPolygon> ParseOutlines(std::string_view text) {
  NumberReader reader(text);
  double unused = 0;
  if (!reader.Read(unused) || !reader.Read(unused)) return NotOutlines(0);
  std::vector<Polygon> rings;
  while (!reader.AtEnd()) {
    size_t count = 0;
    if (!reader.Read(count) || count > reader.left()) return NotOutlines(rings.size() + 1);
    Polygon& ring = rings.emplace_back(count);
    for (Point& point : ring)
      if (!ReadPoint(reader, point)) return NotOutlines(rings.size());
  }
  return Union(rings, FillRule::kEvenOdd);
}

absl::StatusOr<std::vector<fs::path>> OutlineFiles(const std::string& directory) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error))
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  if (error || files.empty()) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     fmt::format("{}: {}", directory,
                                 error ? error.message() : "has no file that ends in .txt"));
  }
  std::sort(files.begin(), files.end());
  return files;
}

absl::StatusOr<MultiPolygon> ReadOutlines(const fs::path& file) {
  const auto text = cli::ReadFile(file.string(), kMaxOutlineBytes);
  if (!text.ok()) return text.status();
  auto islands = ParseOutlines(*text);
  if (islands.ok()) return islands;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed,
                   fmt::format("{}: {}", file.string(), std::string(islands.status().message())));
}

std::string PrintBeads(const std::vector<beading::WallLine>& lines) {
  std::string text;
  for (const auto& [inset, is_middle, line] : lines) {
    text += fmt::format("{} {:d} {:d} {}", inset, is_middle, line.closed, line.points.size());
    for (size_t i = 0; i < line.points.size(); ++i) {
      text += fmt::format(" {:.6f} {:.6f} {:.6f}", ToMm(line.points[i].x), ToMm(line.points[i].y),
                          ToMm(line.thickness_nm[i]));
    }
    text += '\n';
  }
  return text;
}

}  // namespace slicefarm::lab
