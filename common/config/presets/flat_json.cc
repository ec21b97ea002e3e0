#include "common/config/presets/flat_json.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/base/error.h"
#include "common/config/table/setting_limits.h"
#include "common/config/table/value.h"

namespace slicefarm::config::presets {
namespace {

using nlohmann::json;

absl::Status NotFlatJson(std::string_view why) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("this is not a preset: {}", why));
}

/// Receiver of the JSON parser's events. At depth 1 the parser is inside the object, at depth 2
/// inside a list.
class FlatJsonHandler : public nlohmann::json_sax<json> {
 public:
  bool null() override { return Other(); }
  bool boolean(bool /*value*/) override { return Other(); }
  bool number_integer(number_integer_t /*value*/) override { return Other(); }
  bool number_unsigned(number_unsigned_t /*value*/) override { return Other(); }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return Other(); }
  bool binary(binary_t& /*value*/) override { return Other(); }

  bool string(string_t& value) override {
    if (depth_ == 1) return Add(Escape(value));
    if (depth_ == 2 && in_list_) {
      list_ += (list_.size() == 1 ? "" : ",") + json(std::move(value)).dump();
      return true;
    }
    return depth_ > 0 || Fail("it is a text, not an object");
  }
  bool key(string_t& value) override {
    if (depth_ == 1) key_ = std::move(value);
    return true;
  }
  bool start_object(size_t /*elements*/) override {
    is_other_ |= depth_ > 0;
    ++depth_;
    return true;
  }
  bool end_object() override {
    --depth_;
    return depth_ != 1 || End();
  }
  bool start_array(size_t /*elements*/) override {
    if (depth_ == 0) return Fail("it is a list, not an object");
    in_list_ |= depth_ == 1;
    is_other_ |= depth_ > 1;
    list_ = "[";
    ++depth_;
    return true;
  }
  bool end_array() override {
    --depth_;
    return depth_ != 1 || End();
  }
  bool parse_error(size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    const std::string_view text = error.what();
    return Fail(text.substr(std::min(text.find("] ") + 2, text.size())));
  }

  absl::StatusOr<FlatJson> Take() && {
    if (!status_.ok()) return status_;
    return std::move(result_);
  }

 private:
  /// Notes a value of a type that presets do not have. The whole member is then ignored.
  bool Other() {
    if (depth_ == 0) return Fail("it is not an object");
    is_other_ = true;
    return depth_ > 1 || End();
  }

  /// Ends a list. Adds it as a member, or adds its name to the ignored members.
  bool End() {
    const bool other = std::exchange(is_other_, false);
    const bool list = std::exchange(in_list_, false);
    if (other) {
      result_.ignored.push_back(key_);
      return Check(CheckSettingCount(std::ssize(result_.ignored)));
    }
    return !list || Add(list_ + "]");
  }

  bool Add(std::string value) {
    absl::Status status = CheckSettingSize(key_, value);
    result_.members.push_back({key_, std::move(value), Source::kProfile});
    status.Update(CheckSettingCount(std::ssize(result_.members)));
    return Check(std::move(status));
  }

  bool Check(absl::Status status) {
    status_.Update(std::move(status));
    return status_.ok();
  }
  bool Fail(std::string_view why) { return Check(NotFlatJson(why)); }

  FlatJson result_;
  absl::Status status_;
  int64_t depth_ = 0;
  std::string key_, list_;
  bool in_list_ = false;
  bool is_other_ = false;
};

}  // namespace

absl::StatusOr<FlatJson> ReadFlatJson(std::string_view text) {
  FlatJsonHandler handler;
  json::sax_parse(text.begin(), text.end(), &handler);
  return std::move(handler).Take();
}

}  // namespace slicefarm::config::presets
