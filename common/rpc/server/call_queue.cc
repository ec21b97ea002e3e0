#include "common/rpc/server/call_queue.h"

namespace slicefarm::rpc {

// `false`: the queue is not one of the queues that listen for calls; otherwise gRPC would use no
// other queue for this.
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
