#include "tests/load/generator/client/upload_call.h"

#include <algorithm>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::load {
namespace {

/// UploadMesh call. Deletes itself.
class UploadCall final : public grpc::ClientWriteReactor<v1::UploadMeshRequest> {
 public:
  UploadCall(v1::Meshes::Stub& stub, PartPtr part, int64_t offset, const CallContext& context,
             Ended ended)
      : part_(std::move(part)), next_(offset), log_(*context.log), ended_(std::move(ended)) {
    context_.set_deadline(context.deadline);
    stub.async()->UploadMesh(&context_, &response_, this);
    chunk_.set_sha256(part_->sha256);
    chunk_.set_size(size());
    chunk_.set_write_offset(offset);
    WriteNext();
    StartCall();
  }

  void OnWriteDone(bool ok) override {
    if (!ok || next_ == size()) return;  // the status of the call gives the reason
    chunk_.Clear();
    WriteNext();
  }

  void OnDone(const grpc::Status& status) override {
    absl::Status outcome = rpc::FromGrpc(status);
    if (outcome.ok() && !response_.complete()) {
      outcome = MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                          "the server ended an upload before its end");
    }
    const Ended ended = std::move(ended_);
    delete this;  // first, for the reason in StartUnary
    ended(std::move(outcome));
  }

 private:
  int64_t size() const { return static_cast<int64_t>(part_->bytes.size()); }

  void WriteNext() {
    const int64_t bytes = std::min(limits::kUploadChunkBytes, size() - next_);
    chunk_.set_data(part_->bytes.data() + next_, static_cast<size_t>(bytes));
    next_ += bytes;
    log_.Add(Tally::kBytesSent, bytes);
    if (next_ == size()) {
      StartWriteLast(&chunk_, grpc::WriteOptions());
    } else {
      StartWrite(&chunk_);
    }
  }

  const PartPtr part_;
  int64_t next_;
  RunLog& log_;
  Ended ended_;
  grpc::ClientContext context_;
  v1::UploadMeshRequest chunk_;
  v1::Upload response_;
};

}  // namespace

void StartUpload(v1::Meshes::Stub& stub, const PartPtr& part, int64_t offset,
                 const CallContext& context, Ended ended) {
  new UploadCall(stub, part, offset, context, std::move(ended));
}

}  // namespace slicefarm::load
