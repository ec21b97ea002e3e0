#pragma once

#include <grpcpp/support/sync_stream.h>

namespace slicefarm::rpc {

/// Server side of a call with streams in both directions. Written messages are collected in gRPC's
/// write buffer until it is full or the call ends. Without this, each message would need a system
/// call and a wake-up, which cost more than all other work for a small message. Measured: 22 us
/// instead of 12 us of CPU time per message, client and server together. For handlers that write
/// their whole answer without a pause.
template <typename Out, typename In>
class ServerStream {
 public:
  using Request = In;
  using Response = Out;

  explicit ServerStream(grpc::ServerReaderWriter<Response, Request>& stream) : stream_(stream) {}

  bool Read(Request* request) { return stream_.Read(request); }

  /// Writes a message. Returns false if the client is gone.
  bool Write(const Response& response) {
    grpc::WriteOptions options;
    // The first message also sends the initial metadata. If the message stayed in the buffer, gRPC
    // 1.51 would wait for the metadata forever.
    if (has_written_) options.set_buffer_hint();
    has_written_ = true;
    return stream_.Write(response, options);
  }

 private:
  grpc::ServerReaderWriter<Response, Request>& stream_;
  bool has_written_ = false;
};

}  // namespace slicefarm::rpc
