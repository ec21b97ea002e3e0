#include "services/coordinator/server/webhooks/webhook_message.h"

#include <fmt/core.h>
#include <google/protobuf/util/json_util.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <array>

#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator {

std::string WebhookBody(const JobRecord& job) {
  v1::Job proto = ToProto(job);
  ClearSettings(*proto.mutable_spec());
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  std::string json;
  if (!google::protobuf::util::MessageToJsonString(proto, &json, options).ok()) json = "{}";
  return fmt::format(R"({{"type":"job.ended","job":{}}})", json);
}

std::string WebhookSignature(const std::vector<std::string>& secrets, int64_t time_s,
                             const std::string& body) {
  const std::string text = fmt::format("{}.{}", time_s, body);
  std::string signature = fmt::format("t={}", time_s);
  for (const std::string& secret : secrets) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest = {};
    unsigned int size = 0;
    HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()),
         reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data(), &size);
    signature += ",v1=";
    for (unsigned int i = 0; i < size; ++i) signature += fmt::format("{:02x}", digest[i]);
  }
  return signature;
}

}  // namespace slicefarm::coordinator
