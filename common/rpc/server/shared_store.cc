#include "common/rpc/server/shared_store.h"

#include <fmt/core.h>

#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/model/limits.h"
#include "slicefarm/v1/shared.grpc.pb.h"

namespace slicefarm::rpc {
namespace {

using Stream = grpc::ServerReaderWriter<v1::KeepResponse, v1::KeepRequest>;

/// Limits of concurrent uploads. A coordinator sends a value once, so only many coordinators cause
/// more than a few uploads at the same time.
constexpr CallLimiterOptions kGate{.slots = 4, .queue = 32};

absl::Status Refused(const char* field, const char* why) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("{} {}", field, why), {{"field", field}});
}

absl::Status Check(const v1::KeepStart& start) {
  if (!IsSha256Hex(start.digest())) return Refused("start.digest", "is no SHA-256");
  if (start.kind().empty()) return Refused("start.kind", "is missing");
  if (start.size() < 0) return Refused("start.size", "is negative");
  if (start.size() > limits::kMaxSharedBytes)
    return LimitError(Reason::kRequestTooLarge, "bytes that the calls of a job share",
                      limits::kMaxSharedBytes, start.size());
  return absl::OkStatus();
}

/// Reads the pieces and returns them as one text.
absl::StatusOr<std::string> ReadPieces(Stream& stream, int64_t size, const CancelToken& cancel) {
  std::string bytes;
  for (v1::KeepRequest request; stream.Read(&request);) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    if (!request.has_piece() || std::ssize(bytes) + std::ssize(request.piece()) > size)
      return Refused("piece", "is missing, or more than was announced");
    bytes += request.piece();
  }
  if (std::ssize(bytes) != size) return Refused("piece", "fewer bytes than were announced");
  return bytes;
}

class SharedService final : public v1::SharedValues::Service {
 public:
  SharedService(SharedCache& cache, ByteBudget& arriving, CallLimiter& gate)
      : cache_(cache), arriving_(arriving), gate_(gate) {}

  grpc::Status Keep(grpc::ServerContext* context, Stream* stream) override {
    return gate_.Run(*context, "Keep", [&](Call& call) { return Take(call, *stream); });
  }

 private:
  absl::Status Take(Call& call, Stream& stream) const {
    v1::KeepRequest first;
    if (!stream.Read(&first) || !first.has_start()) return Refused("start", "does not come first");
    v1::KeepStart& start = *first.mutable_start();
    if (absl::Status ok = Check(start); !ok.ok()) return ok;
    call.about = {{"kind", start.kind()}, {"bytes", start.size()}};
    if (cache_.Has(start.digest())) return absl::OkStatus();
    const auto share = arriving_.Take(start.size(), call.cancel);
    if (!share.ok()) return share.status();
    absl::StatusOr<std::string> bytes = ReadPieces(stream, start.size(), call.cancel);
    if (!bytes.ok()) return bytes.status();
    if (SharedDigest(start.kind(), *bytes) != start.digest())
      return MakeError(absl::StatusCode::kDataLoss, Reason::kBlobDigestMismatch,
                       "the received bytes do not match their digest");
    cache_.Put(
        {std::move(*start.mutable_kind()), std::move(*start.mutable_digest()), *std::move(bytes)});
    return absl::OkStatus();
  }

  SharedCache& cache_;
  ByteBudget& arriving_;
  CallLimiter& gate_;
};

}  // namespace

SharedStore::SharedStore(JsonLog log)
    : cache_(limits::kMaxKeptSharedBytes),
      arriving_(limits::kMaxSharedBytes),
      gate_(kGate, std::move(log)),
      service_(std::make_unique<SharedService>(cache_, arriving_, gate_)) {}

SharedStore::~SharedStore() = default;

}  // namespace slicefarm::rpc
