#include "tests/sim/work.h"

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/split_mix.h"

namespace slicefarm::coordinator::sim {

absl::Status BadInput() {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed, "a bad mesh");
}

uint64_t LayerHash(int64_t work, const std::string& build, int32_t layer) {
  uint64_t hash = MixedBits(static_cast<uint64_t>(work) + 1);
  for (const char c : build) hash = MixedBits(hash ^ static_cast<unsigned char>(c));
  return MixedBits(hash ^ (static_cast<uint64_t>(layer) + 1));
}

std::string GcodeOf(const std::vector<uint64_t>& layers) {
  uint64_t hash = layers.size();
  for (const uint64_t layer : layers) hash = MixedBits(hash ^ layer);
  return absl::StrCat("g", absl::Hex(hash));
}

std::string ExpectedGcode(const Work& work, const std::string& build) {
  std::vector<uint64_t> layers;
  for (int32_t i = 0; i < work.layers; ++i) layers.push_back(LayerHash(work.id, build, i));
  return GcodeOf(layers);
}

std::string MeshOf(const Work& work) { return absl::StrCat("mesh-", work.id); }

std::string ActionOf(const Work& work, const std::string& build) {
  return absl::StrCat("a", work.id, "-", build);
}

}  // namespace slicefarm::coordinator::sim
