#include "services/slicing/algo/mesh_io/threemf/settings/height_ranges.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/text_lines.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"
#include "services/slicing/algo/mesh_io/threemf/settings/setting_list.h"

namespace slicefarm::slicing::threemf {
namespace {

std::optional<double> HeightOf(XmlAttributes attributes, std::string_view name) {
  const std::optional<double> height = ParseNumber(Find(attributes, name).value_or(""));
  if (!height || !(std::abs(*height) <= limits::kMaxMeshCoordinateMm)) return std::nullopt;
  return height;
}

/// Handler of <objects><object id><range min_z max_z><option opt_key>text</option>
class HeightRangesHandler : public XmlHandler {
 public:
  absl::Status Start(std::string_view name, XmlAttributes attributes, int64_t) override {
    ++depth_;
    if (depth_ == 2 && name == "object") return Object(attributes);
    if (depth_ == 3 && name == "range") return Range(attributes);
    in_option_ = depth_ == 4 && name == "option" && of_range_;
    if (in_option_) key_ = Find(attributes, "opt_key").value_or("");
    value_.clear();
    return absl::OkStatus();
  }

  absl::Status End(std::string_view) override {
    const bool ends_option = in_option_ && depth_ == 4;
    if (depth_ <= 3) of_range_ = false;
    if (depth_-- == 2) ranges_ = nullptr;
    if (!ends_option) return absl::OkStatus();
    in_option_ = false;
    if (NamesScripts(key_)) return absl::OkStatus();
    return AddSetting(key_, ReplaceControls(Trim(value_), ' '), ranges_->back().settings);
  }

  absl::Status Text(std::string_view text) override {
    if (in_option_ && value_.size() <= static_cast<size_t>(limits::kMaxSettingBytes))
      value_ += text;
    return absl::OkStatus();
  }

  HeightRanges Take() && { return std::move(all_); }

 private:
  absl::Status Object(XmlAttributes attributes) {
    const std::string_view text = Find(attributes, "id").value_or("");
    int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1)
      return Malformed("an object's number is missing");
    if (static_cast<int64_t>(all_.size()) >= limits::kMaxObjects)
      return LimitError(Reason::kMeshTooLarge, "objects with height ranges", limits::kMaxObjects,
                        limits::kMaxObjects + 1);
    ranges_ = &all_[number];
    return absl::OkStatus();
  }

  absl::Status Range(XmlAttributes attributes) {
    if (ranges_ == nullptr) return absl::OkStatus();
    const std::optional<double> from = HeightOf(attributes, "min_z"),
                                to = HeightOf(attributes, "max_z");
    if (!from || !to || !(*from < *to)) return Malformed("a range must have min_z below max_z");
    if (static_cast<int64_t>(ranges_->size()) >= limits::kMaxHeightRanges)
      return LimitError(Reason::kMeshTooLarge, "height ranges of an object",
                        limits::kMaxHeightRanges, limits::kMaxHeightRanges + 1);
    ranges_->push_back({*from, *to, {}});
    of_range_ = true;
    return absl::OkStatus();
  }

  HeightRanges all_;
  std::vector<HeightRange>* ranges_ = nullptr;  ///< ranges of the object being read
  bool of_range_ = false;
  bool in_option_ = false;
  std::string key_;
  std::string value_;
  int depth_ = 0;
};

}  // namespace

absl::StatusOr<HeightRanges> ReadHeightRanges(std::string_view text, const std::string& part) {
  HeightRangesHandler handler;
  absl::Status status = ParseXml(text, part, handler);
  if (!status.ok()) return status;
  return std::move(handler).Take();
}

}  // namespace slicefarm::slicing::threemf
