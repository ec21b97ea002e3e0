#include "common/rpc/server/call_queue.h"

namespace slicefarm::rpc {

// It is none of those that listen for calls (false), or else gRPC would have no other one do so.
CallQueue::CallQueue(grpc::ServerBuilder& builder)
    : queue_(builder.AddCompletionQueue(false)), thread_([this] { Run(); }) {}

CallQueue::~CallQueue() {
  queue_->Shutdown();
  thread_.join();
}

void CallQueue::Run() {
  void* tag = nullptr;
  bool ok = false;
  while (queue_->Next(&tag, &ok)) (*static_cast<QueueTag*>(tag))(ok);
}

}  // namespace slicefarm::rpc
