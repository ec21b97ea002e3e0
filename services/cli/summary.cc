#include "services/cli/summary.h"

#include <fmt/core.h>

#include "common/base/duration_text.h"

namespace slicefarm::cli {

std::string SummaryText(const Summary& summary) {
  std::string text = summary.output.empty() ? "" : summary.output + ": ";
  text += fmt::format("{} {}, {} {}", summary.layers,
                      summary.layers == 1 ? summary.words.one : summary.words.many,
                      DurationText(summary.print_time_s), summary.words.to_make);
  // Not every process needs any.
  if (summary.filament_mm > 0)
    text += fmt::format(", {:.2f} m of filament", summary.filament_mm / 1000);
  if (summary.filament_g > 0) text += fmt::format(" ({:.1f} g)", summary.filament_g);
  if (!summary.cost.empty()) text += ", " + summary.cost;
  if (summary.cached) text += "; found by content, not made anew";
  text += '\n';
  if (summary.settings_without_effect > 0) {
    text += fmt::format(
        "{} of the given settings {} no effect; {}\n", summary.settings_without_effect,
        summary.settings_without_effect == 1 ? "has" : "have",
        summary.report.empty() ? "--report FILE.json lists them" : "listed in " + summary.report);
  }
  return text;
}

std::string MoneyText(double amount, const std::string& currency) {
  return amount > 0 ? fmt::format("{:.2f} {}", amount, currency) : "";
}

}  // namespace slicefarm::cli
