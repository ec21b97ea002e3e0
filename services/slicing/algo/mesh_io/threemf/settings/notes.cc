#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"

#include <fmt/core.h>

#include <algorithm>

#include "absl/strings/str_join.h"

namespace slicefarm::slicing::threemf {
namespace {

constexpr size_t kMostNames = 8;

}  // namespace

void Notes::Add(std::string_view what, std::string_view object) {
  auto note = std::find_if(notes_.begin(), notes_.end(),
                           [what](const Note& each) { return each.what == what; });
  if (note == notes_.end()) {
    notes_.push_back({std::string(what), {}, 0});
    note = notes_.end() - 1;
  }
  if (object.empty()) return;
  if (note->objects.size() < kMostNames) note->objects.push_back(fmt::format("`{}`", object));
  ++note->count;
}

std::vector<std::string> Notes::Lines() const {
  std::vector<std::string> lines;
  for (const Note& note : notes_) {
    std::string line = note.what;
    if (note.count > 0) line += fmt::format(" of {}", absl::StrJoin(note.objects, ", "));
    if (note.count > kMostNames) line += fmt::format(" and {} more", note.count - kMostNames);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace slicefarm::slicing::threemf
