// Tests a farm of real processes with certificates and tokens: access, refusals and their messages,
// and changes of certificates and tokens while it runs.
#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "common/rpc/security/dev_certs_test.h"
#include "common/rpc/security/tls.h"
#include "services/coordinator/server/api/coordinator_client_test.h"
#include "tests/corpus_file.h"
#include "tests/integration/child_process.h"

namespace slicefarm::secure_farm_test {
namespace {

using Arguments = std::vector<std::string>;

Arguments operator+(Arguments all, const Arguments& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

Arguments TlsFlags(const rpc::TlsFiles& files) {
  Arguments flags = {"--tls-ca", files.ca};
  if (files.has_certificate()) {
    flags = flags + Arguments{"--tls-cert", files.cert, "--tls-key", files.key};
  }
  return flags;
}

std::string ReadFile(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class Client : public coordinator::CoordinatorClient {
 public:
  Client(const std::string& address, const rpc::TlsFiles& files, const std::string& token = "") {
    rpc::ChannelOptions options;
    options.token = token;
    options.credentials = (*rpc::Tls::Open(files))->ForServerName();
    Connect(address, options);
  }

  absl::StatusOr<std::string> Gcode(const std::string& id) {
    return Download(id, v1::ARTIFACT_GCODE);
  }
};

/// Server process with the certificate of its role.
struct SecureServer {
  SecureServer(rpc::DevCerts& certs, const std::string& program, const std::string& role,
               const Arguments& more = {})
      : files(certs.Make(role)), server(program, TlsFlags(files) + more) {}

  const rpc::TlsFiles files;
  ServerProcess server;
  const std::string& address() const { return server.address; }
};

class SecureFarmTest : public testing::Test {
 protected:
  SecureFarmTest() {
    WriteTenants(R"({"tenants": {
        "a": {"tokens": [)" +
                 Token("a-1", R"("submit", "read")") + "," + Token("a-2", R"("read")") +
                 R"(]}, "b": {"tokens": [)" + Token("b-1", R"("submit", "read")") + "]}}}");
    tenant_a_ = certs_.Make("tenant/a");
    tenant_b_ = certs_.Make("tenant/b");
    nobody_.ca = tenant_a_.ca;
  }

  static std::string Token(const std::string& token, const std::string& scopes) {
    return R"({"sha256": ")" + Sha256Hex(token) + R"(", "scopes": [)" + scopes + "]}";
  }

  void WriteTenants(const std::string& json) {
    std::ofstream(tenants_file_ + ".new") << json;
    std::filesystem::rename(tenants_file_ + ".new", tenants_file_);
  }

  Arguments CoordinatorFlags(const rpc::TlsFiles& files, const Arguments& more) const {
    return Arguments{"--state-dir", state_.path(),       "--slicing", slicing_.address(),
                     "--planning",  planning_.address(), "--motion",  motion_.address(),
                     "--tenants",   tenants_file_} +
           TlsFlags(files) + more;
  }

  void StartCoordinator(const Arguments& more = {}) {
    if (!worker_) worker_.emplace(certs_, "slicefarm-worker", "worker", Arguments{"--slots", "1"});
    coordinator_.emplace("slicefarm-coordinator",
                         CoordinatorFlags(certs_.Make("coordinator"),
                                          Arguments{"--workers", worker_->address()} + more));
  }

  struct Outcome {
    int code = 0;
    std::string error;
  };
  /// Returns the outcome of `list` with these options.
  Outcome List(const Arguments& options) const {
    return Run("list", coordinator_->address, options);
  }
  static Outcome Run(const std::string& command, const std::string& address,
                     const Arguments& options) {
    ChildProcess process("slicefarm",
                         Arguments{command, "--server", address, "--patience", "0.2"} + options,
                         ChildProcess::Stderr::kWithStdout);
    std::string error = process.AwaitLine("error: ");
    return {process.Wait(), std::move(error)};
  }

  /// Submits the mesh, waits for the job and returns its G-code's digest.
  static std::string Print(Client& client, const std::string& mesh) {
    const v1::Job end = client.AwaitEnd(client.Submit(mesh));
    EXPECT_EQ(end.state(), v1::JOB_STATE_SUCCEEDED) << end.error().message();
    return end.result().gcode_sha256();
  }

  const std::string mesh_ = CorpusFile("models/textbox.stl");
  TempDirectory state_;
  TempDirectory directory_;
  const std::string tenants_file_ = directory_.path() + "/tenants.json";
  rpc::DevCerts certs_;
  rpc::TlsFiles tenant_a_;
  rpc::TlsFiles tenant_b_;
  rpc::TlsFiles nobody_;
  SecureServer slicing_{certs_, "slicefarm-slicing", "stage/slicing"};
  SecureServer planning_{certs_, "slicefarm-planning", "stage/planning"};
  SecureServer motion_{certs_, "slicefarm-motion", "stage/motion"};
  std::optional<SecureServer> worker_;
  std::optional<ServerProcess> coordinator_;
};

TEST_F(SecureFarmTest, WorkersAndSplitStagesGiveTheSameBytes) {
  StartCoordinator();
  Client client(coordinator_->address, tenant_a_);
  const std::string fused = Print(client, mesh_);
  coordinator_.reset();
  const TempDirectory other_state;
  const SecureServer beading(certs_, "slicefarm-beading", "stage/beading");
  const SecureServer infill(certs_, "slicefarm-infill", "stage/infill");
  const SecureServer ordering(certs_, "slicefarm-ordering", "stage/ordering");
  const ServerProcess split(
      "slicefarm-coordinator",
      Arguments{"--state-dir", other_state.path(), "--slicing", slicing_.address(), "--planning",
                planning_.address(), "--motion", motion_.address(), "--beading", beading.address(),
                "--infill", infill.address(), "--ordering", ordering.address()} +
          TlsFlags(certs_.Make("coordinator")));
  Client other(split.address, tenant_b_);
  EXPECT_EQ(Print(other, mesh_), fused);
}

TEST_F(SecureFarmTest, TheCommandLineSubmitsAndIsToldWhatIsWrong) {
  StartCoordinator();
  const std::string out = directory_.path() + "/out.gcode";
  const std::string model = directory_.path() + "/part.stl";
  std::ofstream(model, std::ios::binary) << mesh_;
  EXPECT_EQ(ChildProcess("slicefarm", Arguments{"submit", model, "-o", out, "-q", "--generic",
                                                "--server", coordinator_->address} +
                                          TlsFlags(tenant_a_))
                .Wait(),
            0);
  EXPECT_THAT(ReadFile(out), testing::StartsWith("; generated by slicefarm"));
  EXPECT_EQ(ChildProcess("slicefarm",
                         Arguments{"health", coordinator_->address} + TlsFlags(worker_->files))
                .Wait(),
            0);

  EXPECT_EQ(List(TlsFlags(tenant_a_)).code, 0);
  const Outcome without = List(TlsFlags(nobody_));
  EXPECT_EQ(without.code, 5);
  EXPECT_THAT(without.error, testing::HasSubstr("require a client certificate (--tls-cert"));
  const Outcome plain = List({});
  EXPECT_EQ(plain.code, 5);
  EXPECT_THAT(plain.error, testing::HasSubstr("may require TLS (--tls-ca)"));
  const Outcome late = List(TlsFlags(certs_.Make("tenant/late", 0)));
  EXPECT_EQ(late.code, 2);
  EXPECT_THAT(late.error, testing::HasSubstr("tenant-late/cert.pem expired on "));
  const Outcome role = List(TlsFlags(worker_->files));
  EXPECT_EQ(role.code, 2);
  EXPECT_EQ(role.error, "the certificate is spiffe://slicefarm/worker's, and no tenant's");
  const Outcome stranger = List(TlsFlags(certs_.Make("tenant/stranger")));
  EXPECT_EQ(stranger.code, 2);
  EXPECT_EQ(stranger.error, "the tenant of the certificate is unknown");
  rpc::DevCerts others;
  rpc::TlsFiles forged = others.Make("tenant/a");
  forged.ca = tenant_a_.ca;
  EXPECT_EQ(List(TlsFlags(forged)).code, 5);
  for (const SecureServer* service : {&slicing_, &planning_}) {
    const Outcome stage = Run("list", service->address(), TlsFlags(tenant_a_));
    EXPECT_EQ(stage.code, 2);
    EXPECT_EQ(stage.error, "spiffe://slicefarm/tenant/a may not call /slicefarm.v1.Jobs/ListJobs");
  }
}

// This client does not check the certificate itself, unlike the command line.
TEST_F(SecureFarmTest, AnExpiredCertificateIsRefusedByTheServer) {
  StartCoordinator();
  rpc::SwappedDirectory files(certs_.path() + "/tenant-a");
  const auto tls = *rpc::Tls::Open(rpc::DevCerts::In(files.path()));
  const auto list = [&] {
    Client client(coordinator_->address, tenant_a_);
    rpc::ChannelOptions options;
    options.credentials = tls->ForServerName();
    client.Connect(coordinator_->address, options);
    v1::ListJobsResponse response;
    grpc::ClientContext context;
    return client.jobs_->ListJobs(&context, {}, &response).error_code();
  };
  EXPECT_EQ(list(), grpc::StatusCode::OK);
  certs_.Make("tenant/late", 0);
  files.PointTo(certs_.path() + "/tenant-late");
  while (list() == grpc::StatusCode::OK) std::this_thread::yield();
  EXPECT_EQ(list(), grpc::StatusCode::UNAVAILABLE);
}

TEST_F(SecureFarmTest, TokensDecideWhereCertificatesAreOptional) {
  StartCoordinator({"--client-certs", "optional"});
  const auto token_file = [&](const std::string& token) {
    const std::string path = directory_.path() + "/token";
    std::ofstream(path) << token << "\n";
    return Arguments{"--token-file", path};
  };
  EXPECT_EQ(List(TlsFlags(nobody_) + token_file("a-1")).code, 0);
  EXPECT_EQ(List(TlsFlags(tenant_a_)).code, 0);
  EXPECT_EQ(List(TlsFlags(tenant_a_) + token_file("a-2")).code, 0);
  const Outcome none = List(TlsFlags(nobody_));
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(none.error, "a token is needed: `authorization: Bearer TOKEN`");
  const Outcome wrong = List(TlsFlags(nobody_) + token_file("a-3"));
  EXPECT_EQ(wrong.code, 2);
  EXPECT_EQ(wrong.error, "the token is unknown or has expired");
  const Outcome mixed = List(TlsFlags(tenant_b_) + token_file("a-1"));
  EXPECT_EQ(mixed.code, 2);
  EXPECT_EQ(mixed.error, "token and certificate belong to different tenants");

  Client reader(coordinator_->address, nobody_, "a-2");
  const absl::Status scope = reader.Upload(mesh_).status();
  EXPECT_EQ(DetailOf(scope).reason, Reason::kPermissionDenied);
  EXPECT_EQ(DetailOf(scope).metadata["scope"], "submit");

  // New tokens are valid while the farm runs, and the old ones until they are removed.
  WriteTenants(R"({"tenants": {"a": {"tokens": [)" + Token("a-1", R"("read")") + "," +
               Token("a-3", R"("read")") + "]}}}");
  while (List(TlsFlags(nobody_) + token_file("a-3")).code != 0) std::this_thread::yield();
  EXPECT_EQ(List(TlsFlags(nobody_) + token_file("a-1")).code, 0);
  WriteTenants(R"({"tenants": {"a": {"tokens": [)" + Token("a-3", R"("read")") + "]}}}");
  while (List(TlsFlags(nobody_) + token_file("a-1")).code == 0) std::this_thread::yield();
  EXPECT_EQ(List(TlsFlags(nobody_) + token_file("a-3")).code, 0);
}

TEST_F(SecureFarmTest, TenantsKnowNothingOfEachOther) {
  StartCoordinator();
  Client a(coordinator_->address, tenant_a_);
  Client b(coordinator_->address, tenant_b_);
  const std::string unused = "0123456789abcdef0123456789abcdef";
  ASSERT_TRUE(b.Upload(mesh_).ok());
  const auto of_b = b.Create(Client::RequestFor(mesh_));
  ASSERT_TRUE(of_b.ok()) << of_b.status();
  EXPECT_EQ(b.AwaitEnd(of_b->id()).state(), v1::JOB_STATE_SUCCEEDED);
  // Returns the error text for an id, without the id. The text must not depend on the id.
  const auto error_text = [&](const std::string& id) {
    grpc::ClientContext context;
    v1::GetJobRequest request;
    request.set_id(id);
    v1::Job job;
    const grpc::Status status = a.jobs_->GetJob(&context, request, &job);
    std::string all = status.error_message() + status.error_details();
    for (size_t at = 0; (at = all.find(id)) != std::string::npos;) all.replace(at, id.size(), "ID");
    return all;
  };
  EXPECT_EQ(error_text(of_b->id()), error_text(unused));
  EXPECT_EQ(DetailOf(a.Gcode(of_b->id()).status()).reason, Reason::kJobNotFound);
  EXPECT_EQ(a.GetUpload(Sha256Hex(mesh_)).committed_size(), 0);
  EXPECT_EQ(DetailOf(a.Create(Client::RequestFor(mesh_)).status()).reason, Reason::kBlobNotFound);
  ASSERT_TRUE(a.Upload(mesh_).ok());
  const auto of_a = a.Create(Client::RequestFor(mesh_));
  EXPECT_FALSE(a.AwaitEnd(of_a->id()).result().cached());
  EXPECT_EQ(*a.Gcode(of_a->id()), *b.Gcode(of_b->id()));
}

TEST_F(SecureFarmTest, CertificatesAreRenewedWhileItRuns) {
  StartCoordinator();
  const auto shown = [&] {
    Client client(coordinator_->address, tenant_a_);
    grpc::ClientContext context;
    v1::ListJobsResponse response;
    EXPECT_TRUE(client.jobs_->ListJobs(&context, {}, &response).ok());
    const auto pem = context.auth_context()->FindPropertyValues("x509_pem_cert");
    return pem.empty() ? "" : std::string(pem[0].data(), pem[0].size());
  };
  Client old(coordinator_->address, tenant_a_);
  const std::string quiet = Print(old, mesh_);
  const std::string before = shown();
  certs_.Make("coordinator");
  while (shown() == before) std::this_thread::yield();

  // A worker that is restarted with a renewed certificate joins and works for the coordinator. The
  // coordinator uses its own renewed certificate.
  const std::string address = worker_->address();
  worker_.reset();
  worker_.emplace(certs_, "slicefarm-worker", "worker",
                  Arguments{"--slots", "1", "--listen", address});
  v1::CreateJobRequest request = Client::RequestFor(mesh_);
  request.mutable_spec()->mutable_objects(0)->set_name("another part.stl");
  const auto job = old.Create(request);  // over the existing connection
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(old.AwaitEnd(job->id()).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(Print(old, mesh_), quiet);
}

// Names are only displayed: they lead to no file, and none becomes a command.
TEST_F(SecureFarmTest, NamesGoNowhere) {
  StartCoordinator();
  Client client(coordinator_->address, tenant_a_);
  ASSERT_TRUE(client.Upload(mesh_).ok());
  const auto gcode_of = [&](const std::string& name, bool labelled = false) {
    v1::CreateJobRequest request = Client::RequestFor(mesh_);
    request.mutable_spec()->mutable_objects(0)->set_name(name);
    request.set_request_id(name + (labelled ? " labelled" : ""));
    for (const auto& [key, value] :
         {std::pair{"gcode_flavor", "klipper"}, std::pair{"gcode_label_objects", "firmware"}}) {
      if (!labelled) break;
      v1::Setting& setting = *request.mutable_spec()->add_settings();
      setting.set_key(key);
      setting.set_value(value);
    }
    (*request.mutable_labels())[name] = name;
    const auto job = client.Create(request);
    EXPECT_TRUE(job.ok()) << job.status();
    client.AwaitEnd(job->id());
    EXPECT_EQ(client.Get(job->id())->labels().at(name), name);
    return client.Gcode(job->id()).value_or("");
  };
  const auto commands_of = [](const std::string& gcode) {
    std::string commands;
    std::istringstream lines(gcode);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with(';')) commands += line + "\n";
    }
    return commands;
  };
  // Labels tell the firmware the object's name as one word, for any name.
  const auto labelled = [&](const std::string& name) {
    static const std::regex kName("NAME=\\S+");
    return std::regex_replace(commands_of(gcode_of(name, true)), kName, "NAME=");
  };
  const auto files = [&] {
    size_t count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory_.path())) {
      count += entry.is_regular_file();
    }
    return count;
  };
  const std::string plain = commands_of(gcode_of("part"));
  const std::string plain_labelled = labelled("part");
  EXPECT_THAT(plain_labelled, testing::HasSubstr("\nEXCLUDE_OBJECT_START NAME=\n"));
  const size_t before = files();
  for (const std::string& name :
       {"../../" + std::filesystem::path(directory_.path()).filename().string() + "/owned",
        directory_.path() + "/owned", std::string("\"]}; M112 {if 1}%s$(reboot)`'\\n\\r")}) {
    const std::string gcode = gcode_of(name);
    EXPECT_EQ(commands_of(gcode), plain) << name;
    EXPECT_EQ(labelled(name), plain_labelled) << name;
  }
  EXPECT_EQ(files(), before);
  for (const std::string& name :
       {std::string("a\nM112"), std::string("a\rM112"), std::string("a\0M112", 6),
        std::string("a\x1b[2J"), std::string("a\u2028M112")}) {
    v1::CreateJobRequest request = Client::RequestFor(mesh_);
    request.mutable_spec()->mutable_objects(0)->set_name(name);
    EXPECT_EQ(DetailOf(client.Create(request).status()).reason, Reason::kRequestMalformed);
    request = Client::RequestFor(mesh_);
    (*request.mutable_labels())["order"] = name;
    EXPECT_EQ(DetailOf(client.Create(request).status()).reason, Reason::kRequestMalformed);
    request = Client::RequestFor(mesh_);
    request.set_request_id(name);
    EXPECT_EQ(DetailOf(client.Create(request).status()).reason, Reason::kRequestMalformed);
  }
}

TEST_F(SecureFarmTest, ACoordinatorThatCannotBeSafeDoesNotStart) {
  const rpc::TlsFiles files = certs_.Make("coordinator");
  const Arguments nowhere = {"--state-dir", state_.path(), "--slicing", "127.0.0.1:1",
                             "--planning",  "127.0.0.1:1", "--motion",  "127.0.0.1:1",
                             "--workers",   "127.0.0.1:1"};
  const auto refusal = [&](const Arguments& arguments, const std::string& line) {
    ChildProcess process("slicefarm-coordinator", nowhere + arguments,
                         ChildProcess::Stderr::kWithStdout);
    EXPECT_NE(process.AwaitLine(line), "") << line;
    EXPECT_NE(process.Wait(), 0);
  };
  refusal({"--tenants", tenants_file_, "--listen", "0.0.0.0:0"}, "--tenants needs --tls-cert: ");
  refusal(TlsFlags(files) + Arguments{"--client-certs", "optional"}, "--client-certs optional ");
  refusal({"--tls-cert", files.cert, "--tls-key", files.key}, "--tls-cert requires ");
  refusal({"--tls-ca", files.ca}, "--tls-ca requires ");
  refusal({"--tenants", directory_.path() + "/none.json"}, "--tenants: File does not exist");

  const auto fails = [&](const Arguments& arguments) {
    return ChildProcess("slicefarm-coordinator", nowhere + arguments).Wait();
  };
  EXPECT_EQ(fails(TlsFlags(certs_.Make("coordinator", 0))), 1);
  WriteTenants(R"({"tenants": {"a": {"quota": 1}}})");
  EXPECT_EQ(fails({"--tenants", tenants_file_}), 1);
}

}  // namespace
}  // namespace slicefarm::secure_farm_test
