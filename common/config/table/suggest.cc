#include "common/config/table/suggest.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/config/table/settings_table.h"

namespace slicefarm::config {
namespace {

constexpr size_t kMaxKey = 100;  // longer ones are no typing errors

bool Contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace

int EditDistance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1);
  std::vector<int> above(b.size() + 1);
  std::vector<int> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) above[j] = static_cast<int>(j);
  for (size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[b.size()];
}

std::string Nearest(std::string_view word, std::span<const std::string_view> names) {
  if (word.size() > kMaxKey) return "";
  std::string_view nearest;
  const int most = std::max(2, static_cast<int>(word.size()) / 4);
  std::pair<int, int> least = {most + 1, 0};
  for (const std::string_view name : names) {
    const bool contained = word.size() >= 5 && (Contains(name, word) || Contains(word, name));
    const int edits = EditDistance(word, name);
    const std::pair<int, int> distance = {contained ? std::min(edits, 2) : edits, edits};
    if (distance < least) {
      least = distance;
      nearest = name;
    }
  }
  return std::string(nearest);
}

std::string NearestSetting(std::string_view key, Process process) {
  std::vector<std::string_view> keys;
  for (const SettingSpec& spec : SettingsTable(process)) keys.push_back(spec.key);
  return Nearest(key, keys);
}

}  // namespace slicefarm::config
