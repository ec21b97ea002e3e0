#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"
#include "common/stage/slice_input_test.h"
#include "services/slicing/sandbox/processes_test.h"
#include "tests/corpus_file.h"
#include "tests/integration/child_process.h"
#include "tests/integration/remote_clients.h"

namespace slicefarm::mesh_sandbox_test {
namespace {

namespace fs = std::filesystem;
using slicing::ChildrenOf;
using slicing::IsRunning;
using slicing::OpenFiles;

SliceInput PartOf(std::string bytes) {
  return InputOf({{"part", MeshFormat::kUnknown, std::move(bytes)}});
}

/// slicefarm-slicing, copied to a folder with another program as its mesh reader.
class SlicingElsewhere {
 public:
  /// `reader`: path of that program; empty: none.
  explicit SlicingElsewhere(const std::string& reader) {
    fs::copy_file(fs::path(SLICEFARM_BIN) / "slicefarm-slicing", program());
    if (!reader.empty()) fs::copy_file(reader, directory_.path() + "/slicefarm-mesh-reader");
  }

  std::string program() const { return directory_.path() + "/slicefarm-slicing"; }

 private:
  const TempDirectory directory_;
};

// The test reader executes commands in the file, like a reader that a file has taken over.
TEST(MeshSandbox, TheServiceOutlivesItsReaders) {
  const SlicingElsewhere elsewhere(MISBEHAVING_READER);
  const ServerProcess server(elsewhere.program());
  const RemoteClients remote(server.address);
  const std::string good = CorpusFile("models/textbox.stl");
  const auto slice = [&](const std::string& bytes) {
    return remote.slicing.Slice({}, PartOf(bytes), {});
  };
  const auto before = slice(good);
  ASSERT_TRUE(before.ok()) << before.status();
  const std::string pid = std::to_string(server.process.pid());
  const int files = OpenFiles(pid);
  for (int i = 0; i < 50; ++i) {
    for (const std::string deed : {"crash", "socket", "break  ", "excuse"}) {
      const auto job = slice(deed);
      EXPECT_TRUE(absl::IsInvalidArgument(job.status())) << deed << job.status();
      EXPECT_EQ(DetailOf(job.status()).reason, Reason::kMeshReaderCrashed) << deed;
    }
    EXPECT_EQ(DetailOf(slice(good.substr(0, 1000)).status()).reason, Reason::kMeshTruncated);
  }
  EXPECT_EQ(OpenFiles(pid), files);
  EXPECT_THAT(ChildrenOf(server.process.pid()), testing::IsEmpty());
  const auto after = slice(good);
  ASSERT_TRUE(after.ok()) << after.status();
  EXPECT_EQ(after->layers, before->layers);
}

TEST(MeshSandbox, AClientThatGivesUpEndsItsReader) {
  const SlicingElsewhere elsewhere(MISBEHAVING_READER);
  const ServerProcess server(elsewhere.program());
  const RemoteClients remote(server.address);
  const pid_t pid = server.process.pid();
  const CancelToken once_it_reads([pid] { return !ChildrenOf(pid).empty(); });
  const auto job =
      remote.slicing.Slice({.job_id = "", .cancel = once_it_reads}, PartOf("spin"), {});
  EXPECT_TRUE(absl::IsCancelled(job.status())) << job.status();
  while (!ChildrenOf(pid).empty()) {
  }
}

TEST(MeshSandbox, AReaderEndsWithItsService) {
  const SlicingElsewhere elsewhere(MISBEHAVING_READER);
  ServerProcess server(elsewhere.program());
  const RemoteClients remote(server.address);
  std::vector<pid_t> readers;
  const CancelToken once_it_reads([&] {
    readers = ChildrenOf(server.process.pid());
    if (readers.empty()) return false;
    server.process.Signal(SIGKILL);
    return true;
  });
  (void)remote.slicing.Slice({.job_id = "", .cancel = once_it_reads}, PartOf("spin"), {});
  ASSERT_EQ(readers.size(), 1u);
  while (IsRunning(readers[0])) {
  }
}

TEST(MeshSandbox, EachModeGivesTheSameAndIsNamedInTheLog) {
  const std::string good = CorpusFile("models/textbox.stl");
  std::vector<SlicedJob> jobs;
  for (const std::string mode : {"off", "limits", "strict"}) {
    ChildProcess process("slicefarm-slicing", {"--mesh-sandbox", mode},
                         ChildProcess::Stderr::kWithStdout);
    EXPECT_THAT(process.AwaitLine("{"), testing::HasSubstr("\"mesh_sandbox\":\"" + mode + "\""));
    const RemoteClients remote(process.AwaitLine("listening on "));
    auto job = remote.slicing.Slice({}, PartOf(good), {});
    ASSERT_TRUE(job.ok()) << mode << job.status();
    jobs.push_back(*std::move(job));
  }
  for (const SlicedJob& job : jobs) {
    EXPECT_EQ(job.layers, jobs[0].layers);
    EXPECT_EQ(job.meshes, jobs[0].meshes);
    EXPECT_EQ(job.thumbnails, jobs[0].thumbnails);
  }
}

TEST(MeshSandbox, WithoutAReaderTheServiceRefusesToStartAndSaysWhatToDo) {
  const SlicingElsewhere alone("");
  ChildProcess refused(alone.program(), {}, ChildProcess::Stderr::kWithStdout);
  EXPECT_THAT(refused.AwaitLine("{"), testing::HasSubstr("--mesh-sandbox off"));
  EXPECT_EQ(refused.Wait(), 1);
  const ServerProcess trusting(alone.program(), {"--mesh-sandbox", "off"});
}

TEST(MeshSandbox, WithoutSeccompTheServiceRefusesToStartUnlessLimitsAreEnough) {
  const std::string slicing = SLICEFARM_BIN "/slicefarm-slicing";
  ChildProcess refused(WITHOUT_SECCOMP, {slicing}, ChildProcess::Stderr::kWithStdout);
  EXPECT_THAT(refused.AwaitLine("{"),
              testing::AllOf(testing::HasSubstr("seccomp"), testing::HasSubstr("Operation not"),
                             testing::HasSubstr("--mesh-sandbox limits")));
  EXPECT_EQ(refused.Wait(), 1);
  const ServerProcess limited(WITHOUT_SECCOMP, {slicing, "--mesh-sandbox", "limits"});
}

}  // namespace
}  // namespace slicefarm::mesh_sandbox_test
