#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/config/process_settings.h"

namespace slicefarm::cli {

/// What a user wants to know of a result at a glance.
struct Summary {
  std::string output = {};  ///< where the result is; empty: nowhere yet
  config::ResultWords words = {};
  int layers = 0;
  double print_time_s = 0;
  double filament_mm = 0;
  double filament_g = 0;  ///< 0: the density is not known
  std::string cost = {};  ///< "12.50 EUR"; empty: nothing is charged
  bool cached = false;
  std::string job = {};  ///< its id; empty: it was made here
  int64_t settings_without_effect = 0;
  std::vector<std::string> changing =
      {};                    ///< those of them that change the print: `key = value: why`
  int64_t beside_print = 0;  ///< of these, those that do not matter to it
  std::string report = {};  ///< where the report is; empty: nowhere
};

/// A few lines of text.
std::string SummaryText(const Summary& summary);

/// "12.50 EUR"; empty if there is nothing to pay.
std::string MoneyText(double amount, const std::string& currency);

}  // namespace slicefarm::cli
