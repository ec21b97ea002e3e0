#include "services/cli/job/summary.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/base/duration_text.h"

namespace slicefarm::cli {
namespace {

/// Returns a text such as ", such as a = 1, b = 2 and 3 more, which change the print".
std::string ChangesText(const std::vector<std::string>& changing) {
  constexpr size_t kNamed = 3;
  if (changing.empty()) return "";
  std::string text = ", such as ";
  for (size_t i = 0; i < std::min(kNamed, changing.size()); ++i)
    text += (i == 0 ? "" : ", ") + changing[i].substr(0, changing[i].find(": "));
  if (changing.size() > kNamed) text += fmt::format(" and {} more", changing.size() - kNamed);
  return text + (changing.size() == 1 ? ", which changes the print" : ", which change the print");
}

}  // namespace

std::string SummaryText(const Summary& summary) {
  std::string text = summary.output.empty() ? "" : summary.output + ": ";
  text += fmt::format("{} {}, {} {}", summary.layers,
                      summary.layers == 1 ? summary.words.one : summary.words.many,
                      DurationText(summary.print_time_s), summary.words.to_make);
  // Not every process needs filament.
  if (summary.filament_mm > 0)
    text += fmt::format(", {:.2f} m of filament", summary.filament_mm / 1000);
  if (summary.filament_g > 0) text += fmt::format(" ({:.1f} g)", summary.filament_g);
  if (!summary.cost.empty()) text += ", " + summary.cost;
  if (summary.cached) text += "; from the cache";
  if (!summary.job.empty()) text += "; job " + summary.job;
  text += '\n';
  const int64_t matter = summary.settings_without_effect - summary.beside_print;
  if (matter <= 0) return text;
  text +=
      fmt::format("{} of the given settings {} no effect", matter, matter == 1 ? "has" : "have");
  text += ChangesText(summary.changing);
  if (summary.beside_print > 0)
    text += fmt::format(" ({} other settings without effect do not matter to this print)",
                        summary.beside_print);
  return text + fmt::format("; {}\n", summary.report.empty()
                                          ? "--report FILE.json lists these settings"
                                          : "listed in " + summary.report);
}

std::string MoneyText(double amount, const std::string& currency) {
  if (amount <= 0) return "";
  return fmt::format("{:.2f}{}{}", amount, currency.empty() ? "" : " ", currency);
}

}  // namespace slicefarm::cli
