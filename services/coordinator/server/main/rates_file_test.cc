#include "services/coordinator/server/main/rates_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "common/base/temp_directory_test.h"

namespace slicefarm::coordinator::rates_file_test {
namespace {

TEST(ParseRates, TakesWhatIsThere) {
  const Rates all = {"CHF", 1.5, 2, 0.3, 120, 25};
  EXPECT_EQ(*ParseRates(R"({"currency": "CHF", "setup": 1.5, "machine_per_hour": 2,
                            "energy_per_kwh": 0.3, "printer_power_w": 120,
                            "filament_per_kg": 25})"),
            all);
  EXPECT_EQ(*ParseRates("{}"), Rates());
}

TEST(ParseRates, NamesWhatItCannotTake) {
  const std::pair<const char*, const char*> kCases[] = {
      {"", "JSON object"},
      {"[1]", "JSON object"},
      {R"({"setup": 1,})", "JSON object"},
      {R"({"machine_per_hours": 1})", "machine_per_hours: unknown key"},
      {R"({"setup": "1"})", "setup: a number"},
      {R"({"setup": -1})", "setup: a number"},
      {R"({"setup": null})", "setup: a number"},
      {R"({"currency": 7})", "currency: a text"},
      {R"({"currency": "a long word of a currency"})", "currency: a text"},
  };
  for (const auto& [text, said] : kCases) {
    const absl::Status refused = ParseRates(text).status();
    EXPECT_TRUE(absl::IsInvalidArgument(refused)) << text;
    EXPECT_NE(refused.message().find(said), absl::string_view::npos) << refused;
  }
}

TEST(ReadRates, ReadsAFile) {
  const TempDirectory directory;
  const std::string path = directory.path() + "/rates.json";
  EXPECT_FALSE(ReadRates(path).ok());
  EXPECT_FALSE(ReadRates(directory.path()).ok());
  std::ofstream(path) << R"({"setup": 3})";
  EXPECT_EQ(ReadRates(path)->setup, 3);
}

}  // namespace
}  // namespace slicefarm::coordinator::rates_file_test
