#include "services/coordinator/server/api/audit_log.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"
#include "common/rpc/observe/call_metrics.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

const std::set<std::string_view> kAudited = {
    "/slicefarm.v1.Jobs/CreateJob",
    "/slicefarm.v1.Jobs/BatchCreateJobs",
    "/slicefarm.v1.Jobs/CreatePlates",
    "/slicefarm.v1.Jobs/CancelJob",
    "/slicefarm.v1.Jobs/BatchCancelJobs",
    "/slicefarm.v1.Jobs/UpdateJob",
    "/slicefarm.v1.Jobs/DeleteJob",
    "/slicefarm.v1.Meshes/UploadMesh",
    "/slicefarm.v1.Meshes/DeleteMesh",
    "/slicefarm.v1.Profiles/PutProfile",
    "/slicefarm.v1.Profiles/DeleteProfile",
    "/slicefarm.v1.Jobs/ExportTenant",
    "/slicefarm.v1.Jobs/EraseTenant",
    "/slicefarm.v1.Presets/ImportPresets",
    "/slicefarm.v1.Presets/DeletePresetBundle",
};

/// Names of the fields that identify an object in a request or an answer.
const std::set<std::string_view> kNames = {"id",     "ids",  "job_id", "name",     "sha256",
                                           "tenant", "jobs", "job",    "outcomes", "request_id"};

constexpr size_t kObjectsALine = 50;

/// Collects the texts of the fields that identify objects. Also searches messages in fields with
/// these names.
void Collect(const Message& message, std::vector<std::string>& objects) {
  const auto& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (!kNames.contains(field->name())) continue;
    const bool text = field->cpp_type() == FieldDescriptor::CPPTYPE_STRING;
    const bool nested = field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    const int count = field->is_repeated() ? reflection.FieldSize(message, field) : 1;
    for (int i = 0; i < count; ++i) {
      if (text && field->is_repeated())
        objects.push_back(reflection.GetRepeatedString(message, field, i));
      if (text && !field->is_repeated()) objects.push_back(reflection.GetString(message, field));
      if (nested && field->is_repeated())
        Collect(reflection.GetRepeatedMessage(message, field, i), objects);
      if (nested && !field->is_repeated()) Collect(reflection.GetMessage(message, field), objects);
    }
  }
}

class AuditLog : public grpc::experimental::Interceptor {
 public:
  AuditLog(const Callers& callers, const rpc::JsonLog& log, grpc::experimental::ServerRpcInfo& info)
      : callers_(callers), log_(log), info_(info) {}

  void Intercept(grpc::experimental::InterceptorBatchMethods* methods) override {
    using Hook = grpc::experimental::InterceptionHookPoints;
    if (methods->QueryInterceptionHookPoint(Hook::POST_RECV_MESSAGE) && objects_.empty())
      Note(static_cast<const Message*>(methods->GetRecvMessage()));
    if (methods->QueryInterceptionHookPoint(Hook::PRE_SEND_MESSAGE))
      Note(static_cast<const Message*>(methods->GetSendMessage()));
    if (methods->QueryInterceptionHookPoint(Hook::PRE_SEND_STATUS)) Write(methods->GetSendStatus());
    methods->Proceed();
  }

 private:
  void Note(const Message* message) {
    std::vector<std::string> named;
    if (message != nullptr) Collect(*message, named);
    for (std::string& name : named)
      if (std::ranges::find(objects_, name) == objects_.end()) objects_.push_back(std::move(name));
  }

  void Write(const grpc::Status& status) {
    rpc::LogFields fields = {{"method", std::string(info_.method())}};
    const auto add = [&](std::string_view name, std::string value) {
      if (!value.empty()) fields.push_back({name, std::move(value)});
    };
    const CallerMarks marks = callers_.MarksOf(*info_.server_context());
    add("tenant", marks.tenant);
    add("token", marks.token);
    add("certificate", marks.certificate);
    add("address", marks.address);
    add("code", rpc::CodeName(status.error_code()));
    if (!status.ok())
      add("reason", std::string(ReasonName(DetailOf(rpc::FromGrpc(status)).reason)));
    size_t next = 0;
    do {
      rpc::LogFields line = fields;
      std::string objects;
      for (const size_t end = next + kObjectsALine; next < objects_.size() && next < end; ++next)
        objects += (objects.empty() ? "" : " ") + objects_[next];
      if (!objects.empty()) line.push_back({"objects", std::move(objects)});
      log_.Info("audit", line);
    } while (next < objects_.size());
  }

  const Callers& callers_;
  const rpc::JsonLog& log_;
  grpc::experimental::ServerRpcInfo& info_;
  std::vector<std::string> objects_;
};

}  // namespace

grpc::experimental::Interceptor* AuditLogFactory::CreateServerInterceptor(
    grpc::experimental::ServerRpcInfo* info) {
  if (!kAudited.contains(info->method())) return nullptr;
  return new AuditLog(callers_, log_, *info);  // gRPC owns the object
}

}  // namespace slicefarm::coordinator
