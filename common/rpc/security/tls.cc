#include "common/rpc/security/tls.h"

#include <grpc/grpc_security_constants.h>
#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_certificate_verifier.h>
#include <grpcpp/security/tls_credentials_options.h>

#include <atomic>
#include <functional>
#include <utility>
#include <vector>

namespace slicefarm::rpc {
namespace {

using grpc::experimental::ExternalCertificateVerifier;
using grpc::experimental::TlsChannelCredentialsOptions;

constexpr unsigned kLookEveryS = 1;

/// Accepts only servers with a certificate of one identity. gRPC has already checked the chain up
/// to a CA, and the dates.
class IdentityVerifier : public ExternalCertificateVerifier {
 public:
  IdentityVerifier(std::string identity, JsonLog log)
      : identity_(std::move(identity)), log_(std::move(log)) {}

  bool Verify(grpc::experimental::TlsCustomVerificationCheckRequest* request,
              std::function<void(grpc::Status)> /*for other threads*/,
              grpc::Status* status) override {
    const std::vector<grpc::string_ref> uris = request->uri_names();
    if (uris.size() == 1 && uris[0] == grpc::string_ref(identity_)) {
      refused_ = false;
      *status = grpc::Status::OK;
      return true;
    }
    std::string shown;
    for (const grpc::string_ref& uri : uris) shown.append(uri.data(), uri.size()).append(" ");
    *status = {grpc::StatusCode::UNAUTHENTICATED, "the server is not " + identity_};
    // Logs the refusal once, not with each connection attempt.
    if (!refused_.exchange(true)) {
      log_.Warn("server refused: its certificate is another's",
                {{"expected", identity_}, {"shown", shown}});
    }
    return true;
  }

  void Cancel(grpc::experimental::TlsCustomVerificationCheckRequest* /*never waits*/) override {}

 private:
  const std::string identity_;
  const JsonLog log_;
  std::atomic<bool> refused_ = false;
};

template <typename Options>
void Watch(bool has_certificate, Options& options) {
  options.watch_root_certs();
  if (has_certificate) options.watch_identity_key_cert_pairs();
}

}  // namespace

absl::StatusOr<std::shared_ptr<const Tls>> Tls::Open(const TlsFiles& files) {
  if (absl::Status usable = CheckTlsFiles(files); !usable.ok()) return usable;
  auto provider = files.has_certificate()
                      ? std::make_shared<Provider>(files.key, files.cert, files.ca, kLookEveryS)
                      : std::make_shared<Provider>(files.ca, kLookEveryS);
  return std::shared_ptr<const Tls>(new Tls(files.has_certificate(), std::move(provider)));
}

std::shared_ptr<grpc::ServerCredentials> Tls::ForServer(ClientCerts client_certs) const {
  grpc::experimental::TlsServerCredentialsOptions options(provider_);
  Watch(has_certificate_, options);
  options.set_cert_request_type(client_certs == ClientCerts::kRequired
                                    ? GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY
                                    : GRPC_SSL_REQUEST_CLIENT_CERTIFICATE_AND_VERIFY);
  return grpc::experimental::TlsServerCredentials(options);
}

std::shared_ptr<grpc::ChannelCredentials> Tls::ForServerName() const {
  TlsChannelCredentialsOptions options;
  options.set_certificate_provider(provider_);
  Watch(has_certificate_, options);
  return grpc::experimental::TlsCredentials(options);
}

std::shared_ptr<grpc::ChannelCredentials> Tls::ForIdentity(const std::string& identity,
                                                           const JsonLog& log) const {
  TlsChannelCredentialsOptions options;
  options.set_certificate_provider(provider_);
  Watch(has_certificate_, options);
  options.set_certificate_verifier(
      ExternalCertificateVerifier::Create<IdentityVerifier>(identity, log));
  options.set_check_call_host(false);  // the verifier makes all necessary checks
  return grpc::experimental::TlsCredentials(options);
}

}  // namespace slicefarm::rpc
