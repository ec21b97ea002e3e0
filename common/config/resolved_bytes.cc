#include "common/config/resolved_bytes.h"

#include <array>
#include <set>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/model/limits.h"

namespace slicefarm::config {
namespace {

/// Approximate size of a resolved set without its texts: the structs of all stages.
constexpr int64_t kBytesOfASet = 4096;

/// Divisor for the size of a shared text. Each set still scans the text, which takes a sixteenth of
/// the time of parsing it.
constexpr int64_t kPassedOver = 16;

/// Settings of an object, part or range, as a digest and a size.
struct Own {
  std::string digest;  ///< SHA-256 of the settings; empty: no settings
  int64_t bytes = 0;
};

Own OwnOf(const std::vector<Setting>& settings) {
  if (settings.empty()) return {};
  Sha256 sha;
  for (const Setting& setting : settings) {
    sha.Add(setting.key);
    sha.Add(std::string(1, '\0'));
    sha.Add(setting.value);
    sha.Add(std::string(1, '\0'));
  }
  return {sha.Hex(), BytesOf(settings)};
}

class Counter {
 public:
  explicit Counter(std::span<const Setting> job) : job_(BytesOfJob(job)) {}

  absl::Status Add(const Own& object, const Own& part, const Own& range) {
    if (!seen_.insert({object.digest, part.digest, range.digest}).second) return absl::OkStatus();
    return total_.Add(job_ + object.bytes + part.bytes + range.bytes);
  }

 private:
  const int64_t job_;
  std::set<std::array<std::string, 3>> seen_;
  ResolvedBytes total_;
};

absl::Status AddObject(const SceneObject& object, Counter& counter) {
  const Own own = OwnOf(object.settings);
  std::vector<Own> ranges = {Own()};
  for (const HeightRange& range : object.ranges) ranges.push_back(OwnOf(range.settings));
  std::vector<Own> parts = {Own()};
  for (const Part& part : object.parts) parts.push_back(OwnOf(part.settings));
  for (const Own& part : parts)
    for (const Own& range : ranges)
      if (absl::Status ok = counter.Add(own, part, range); !ok.ok()) return ok;
  return absl::OkStatus();
}

}  // namespace

int64_t BytesOf(std::span<const Setting> settings) {
  int64_t bytes = 0;
  for (const Setting& setting : settings)
    bytes += std::ssize(setting.key) + std::ssize(setting.value);
  return bytes;
}

int64_t BytesOfJob(std::span<const Setting> settings) {
  int64_t bytes = 0;
  for (const Setting& setting : settings) {
    const int64_t text = std::ssize(setting.value);
    bytes += std::ssize(setting.key) + (text < limits::kLongTextBytes ? text : text / kPassedOver);
  }
  return bytes;
}

absl::Status ResolvedBytes::Add(int64_t bytes) {
  bytes_ += bytes + kBytesOfASet;
  if (bytes_ <= limits::kMaxResolvedBytes) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge,
                    "bytes of settings, those of the job counted for each object, part and range "
                    "of heights with settings of its own",
                    limits::kMaxResolvedBytes, bytes_);
}

absl::Status CheckResolvedBytes(std::span<const Setting> job,
                                std::span<const SceneObject> objects) {
  Counter counter(job);
  for (const SceneObject& object : objects)
    if (absl::Status ok = AddObject(object, counter); !ok.ok()) return ok;
  return absl::OkStatus();
}

}  // namespace slicefarm::config
