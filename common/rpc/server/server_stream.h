#pragma once

#include <grpcpp/support/sync_stream.h>

namespace slicefarm::rpc {

/// The server's end of a call with streams both ways. What it writes gathers in gRPC's write buffer
/// until that is full or the call ends: a system call and a wake-up for each message cost more than
/// all else about a small one (22 us of CPU time a message against 12, both ends together). For
/// handlers that write their answer in one go.
template <typename Out, typename In>
class ServerStream {
 public:
  using Request = In;
  using Response = Out;

  explicit ServerStream(grpc::ServerReaderWriter<Response, Request>& stream) : stream_(stream) {}

  bool Read(Request* request) { return stream_.Read(request); }

  /// False if the client is gone.
  bool Write(const Response& response) {
    grpc::WriteOptions options;
    // The first one takes the initial metadata along, and gRPC 1.51 would wait for these to be sent
    // for ever.
    if (has_written_) options.set_buffer_hint();
    has_written_ = true;
    return stream_.Write(response, options);
  }

 private:
  grpc::ServerReaderWriter<Response, Request>& stream_;
  bool has_written_ = false;
};

}  // namespace slicefarm::rpc
