// Tests of export and erasure of a tenant, with a real server and real stores.
#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "services/coordinator/server/api/coordinator_client_test.h"
#include "services/coordinator/server/api/served_coordinator_test.h"

namespace slicefarm::coordinator::tenant_data_test {
namespace {

class Client : public CoordinatorClient {
 public:
  Client(const std::string& address, const std::string& token) {
    rpc::ChannelOptions options;
    options.token = token;
    Connect(address, options);
  }

  absl::StatusOr<std::string> Export(const std::string& tenant) {
    grpc::ClientContext context;
    v1::ExportTenantRequest request;
    request.set_tenant(tenant);
    const auto stream = jobs_->ExportTenant(&context, request);
    std::string archive;
    v1::DownloadResponse response;
    while (stream->Read(&response)) archive += response.data();
    const grpc::Status status = stream->Finish();
    if (!status.ok()) return rpc::FromGrpc(status);
    return archive;
  }

  absl::StatusOr<v1::EraseTenantResponse> Erase(const std::string& tenant) {
    grpc::ClientContext context;
    v1::EraseTenantRequest request;
    request.set_tenant(tenant);
    v1::EraseTenantResponse response;
    const grpc::Status status = jobs_->EraseTenant(&context, request, &response);
    if (!status.ok()) return rpc::FromGrpc(status);
    return response;
  }

  void PutProfile(const std::string& name, const std::string& layer_height) {
    grpc::ClientContext context;
    v1::PutProfileRequest request;
    request.set_name(name);
    v1::Setting& setting = *request.add_settings();
    setting.set_key("layer_height");
    setting.set_value(layer_height);
    v1::Profile profile;
    EXPECT_TRUE(profiles_->PutProfile(&context, request, &profile).ok());
  }

  void ImportPresets(const std::string& name) {
    grpc::ClientContext context;
    v1::ImportPresetsRequest request;
    request.set_name(name);
    v1::PresetFile& file = *request.add_files();
    file.set_path("acme.ini");
    file.set_content("[print:P]\nlayer_height = 0.2\n");
    v1::PresetBundle bundle;
    EXPECT_TRUE(presets_->ImportPresets(&context, request, &bundle).ok());
  }
};

class TenantDataTest : public ServedCoordinatorTest {
 protected:
  TenantDataTest() {
    auto tenants = std::make_shared<Tenants>();
    for (const char* name : {"a", "b"})
      (*tenants)[name].tokens = {{Sha256Hex(name), {Scope::kSubmit, Scope::kRead}}};
    (*tenants)["ops"].tokens = {{Sha256Hex("ops"), {Scope::kAdmin}}};
    (*tenants)["reader"].tokens = {{Sha256Hex("reader"), {Scope::kRead}}};
    CoordinatorOptions options = Options();
    options.tenants = [tenants] { return tenants; };
    Serve(options);
  }

  Client As(const std::string& token) { return {address(), token}; }

  /// Unpacks an archive. Returns the relative paths of its files with their contents.
  std::map<std::string, std::string> Unpack(const std::string& archive) {
    const TempDirectory directory;
    std::ofstream(directory.path() + "/a.tar", std::ios::binary) << archive;
    std::filesystem::create_directory(directory.path() + "/out");
    const std::string command =
        "tar -xf '" + directory.path() + "/a.tar' -C '" + directory.path() + "/out'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::map<std::string, std::string> files;
    const std::filesystem::path out = directory.path() + "/out";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(out)) {
      if (!entry.is_regular_file()) continue;
      std::ostringstream text;
      text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
      files[std::filesystem::relative(entry.path(), out)] = text.str();
    }
    return files;
  }
};

TEST_F(TenantDataTest, AnExportHasAllThatIsKept) {
  Client a = As("a");
  a.PutProfile("..", "0.1");
  a.PutProfile("..", "0.2");
  a.ImportPresets("acme");
  const v1::Job job = a.AwaitEnd(a.Submit("xx"));
  ASSERT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED);
  ASSERT_TRUE(As("b").Upload("of b").ok());
  const auto archive = a.Export("a");
  ASSERT_TRUE(archive.ok()) << archive.status();
  const auto files = Unpack(*archive);
  EXPECT_THAT(files.at("jobs/" + job.id() + ".json"), testing::HasSubstr(job.id()));
  EXPECT_EQ(files.at("blobs/" + Sha256Hex("xx")), "xx");
  for (const std::string& digest : {job.result().gcode_sha256(), job.result().report_sha256()})
    EXPECT_EQ(Sha256Hex(files.at("blobs/" + digest)), digest);
  EXPECT_THAT(files.at("profiles/1-1.json"), testing::HasSubstr("0.1"));
  EXPECT_THAT(files.at("profiles/1-2.json"), testing::HasSubstr("0.2"));
  EXPECT_THAT(files.at("presets/1-1.json"), testing::HasSubstr("\"path\": \"acme.ini\""));
  EXPECT_FALSE(files.contains("blobs/" + Sha256Hex("of b")));
  EXPECT_EQ(*As("ops").Export("a"), *a.Export("a"));
}

TEST_F(TenantDataTest, ErasureLeavesNothingOfOneAndAllOfOthers) {
  Client a = As("a");
  Client b = As("b");
  a.PutProfile("p", "0.1");
  b.PutProfile("p", "0.1");
  a.ImportPresets("acme");
  a.AwaitEnd(a.Submit("xx"));
  const std::string of_b = b.Submit("xx");
  b.AwaitEnd(of_b);
  ranges_->Hold();
  a.Submit("running");
  ranges_->AwaitCall();
  ASSERT_TRUE(a.Upload("half", 0, 2).ok());
  const auto erased = a.Erase("a");
  ASSERT_TRUE(erased.ok()) << erased.status();
  EXPECT_EQ(erased->jobs(), 2);
  EXPECT_GE(erased->blobs(), 5) << "two meshes, a program, a report, an upload";
  EXPECT_EQ(erased->profiles(), 1);
  EXPECT_EQ(erased->preset_bundles(), 1);
  EXPECT_EQ(erased->shared_blobs(), 0);
  EXPECT_THAT(a.List(), testing::IsEmpty());
  EXPECT_EQ(Unpack(*a.Export("a")).size(), 0U);
  ranges_->LetGo();
  EXPECT_THAT(b.List(), testing::ElementsAre(of_b));
  EXPECT_EQ(Unpack(*b.Export("b")).at("blobs/" + Sha256Hex("xx")), "xx");
}

TEST_F(TenantDataTest, OnlyOnesOwnUnlessOneIsAnAdministrator) {
  Client a = As("a");
  const auto denied = [](const absl::Status& status) {
    return DetailOf(status).reason == Reason::kPermissionDenied;
  };
  for (const char* other : {"b", "", "never"}) {
    EXPECT_TRUE(denied(a.Export(other).status())) << other;
    EXPECT_TRUE(denied(a.Erase(other).status())) << other;
  }
  EXPECT_TRUE(denied(As("reader").Erase("reader").status()));
  ASSERT_TRUE(a.Upload("xx").ok());
  EXPECT_EQ(As("ops").Erase("a")->blobs(), 1);
}

}  // namespace
}  // namespace slicefarm::coordinator::tenant_data_test
