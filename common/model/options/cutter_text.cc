#include "common/model/options/cutter_text.h"

#include <fmt/core.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "absl/strings/str_split.h"
#include "common/base/error.h"
#include "common/base/text.h"

namespace slicefarm {
namespace {

struct CutterKind {
  std::string_view name;
  size_t measures;
  absl::StatusOr<Cutter> (*make)(const std::vector<double>& m);
};

constexpr std::array kCutterKinds = {
    CutterKind{"cyl", 1, [](const std::vector<double>& m) { return Cutter::Cylinder(m[0]); }},
    CutterKind{"ball", 1, [](const std::vector<double>& m) { return Cutter::Ball(m[0]); }},
    CutterKind{"bull", 2, [](const std::vector<double>& m) { return Cutter::Bull(m[0], m[1]); }},
    CutterKind{"cone", 2, [](const std::vector<double>& m) { return Cutter::Cone(m[0], m[1]); }},
    CutterKind{"ballcone", 3,
               [](const std::vector<double>& m) { return Cutter::BallCone(m[0], m[1], m[2]); }},
    CutterKind{
        "bullcone", 4,
        [](const std::vector<double>& m) { return Cutter::BullCone(m[0], m[1], m[2], m[3]); }},
    CutterKind{
        "conecone", 4,
        [](const std::vector<double>& m) { return Cutter::ConeCone(m[0], m[1], m[2], m[3]); }},
};

}  // namespace

absl::StatusOr<Cutter> ParseCutter(std::string_view text) {
  const std::vector<std::string> words = absl::StrSplit(std::string(text), ':');
  std::vector<double> measures;
  for (size_t i = 1; i < words.size(); ++i)
    if (const std::optional<double> number = ToNumber(words[i])) measures.push_back(*number);
  for (const CutterKind& kind : kCutterKinds) {
    if (kind.name == words[0] && measures.size() == kind.measures &&
        words.size() == kind.measures + 1)
      return kind.make(measures);
  }
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("the cutter '{}' is not one of {}", text, kCutterForms),
                   {{"setting", "cutter"}});
}

}  // namespace slicefarm
