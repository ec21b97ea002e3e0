#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/config/process_settings.h"

namespace slicefarm::cli {

/// Short summary of a result for the user.
struct Summary {
  std::string output = {};  ///< file of the result; empty: none yet
  config::ResultWords words = {};
  int layers = 0;
  double print_time_s = 0;
  double filament_mm = 0;
  double filament_g = 0;  ///< mass of the filament, in g; 0: the density is not known
  std::string cost = {};  ///< for example "12.50 EUR"; empty: no cost
  bool cached = false;
  std::string job = {};  ///< id of the job; empty: this program has made the result
  int64_t settings_without_effect = 0;
  std::vector<std::string> changing =
      {};  ///< settings without effect that change the print, in the form `key = value: why`
  int64_t beside_print = 0;  ///< number of settings without effect that do not change the print
  std::string report = {};   ///< file of the report; empty: none
};

/// Returns the summary as a few lines of text.
std::string SummaryText(const Summary& summary);

/// Returns a text such as "12.50 EUR"; empty for a zero amount.
std::string MoneyText(double amount, const std::string& currency);

}  // namespace slicefarm::cli
