#pragma once

#include <grpcpp/support/sync_stream.h>

namespace slicefarm::rpc {

/// Server side of a call with streams in both directions. gRPC collects written messages in its
/// buffer until the buffer is full or the call ends. Without buffering, each small message would
/// need a system call and a wake-up, which cost more than all other work for it. Measured CPU time
/// per message, client and server together: 12 us instead of 22 us. For handlers that write their
/// whole answer without a pause.
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
    // The first message is not buffered, because it also sends the initial metadata. If it remained
    // in the buffer, gRPC 1.51 would wait for the metadata forever.
    if (has_written_) options.set_buffer_hint();
    has_written_ = true;
    return stream_.Write(response, options);
  }

 private:
  grpc::ServerReaderWriter<Response, Request>& stream_;
  bool has_written_ = false;
};

}  // namespace slicefarm::rpc
