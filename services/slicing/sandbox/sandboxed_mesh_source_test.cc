#include "services/slicing/sandbox/sandboxed_mesh_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "services/slicing/sandbox/processes_test.h"
#include "services/slicing/sandbox/sanitized_build.h"
#include "tests/corpus_file.h"

namespace slicefarm::slicing::sandboxed_mesh_source_test {
namespace {

using testing::HasSubstr;

constexpr double kLimit = 10'000;
constexpr ReaderLimits kUsual = {.memory_bytes = 256 << 20, .cpu_s = 600};

SandboxedMeshSource Product() { return SandboxedMeshSource({.program = MESH_READER}); }

/// Returns a source with a reader that does the misbehaviour named in the file.
SandboxedMeshSource TakenOver(Confinement confinement = Confinement::kStrict,
                              const ReaderLimits& limits = kUsual) {
  return SandboxedMeshSource({.confinement = confinement,
                              .program = MISBEHAVING_READER,
                              .limits = [limits](std::string_view) { return limits; }});
}

absl::Status Do(const SandboxedMeshSource& source, const std::string& deed,
                const CancelToken& cancel = {}) {
  return source.Read(deed, MeshFormat::kUnknown, kLimit, ReadDepth::kMeshes, cancel).status();
}

Reason ReasonOf(const absl::Status& status) { return DetailOf(status).reason; }

using Contents = absl::StatusOr<MeshFileContents>;

void ExpectTheSame(const Contents& a, const Contents& b, const std::string& what) {
  ASSERT_EQ(a.ok(), b.ok()) << what << ": " << a.status() << " / " << b.status();
  if (a.ok()) {
    ASSERT_EQ(a->meshes.size(), b->meshes.size()) << what;
    for (size_t i = 0; i < a->meshes.size(); ++i) {
      EXPECT_EQ(a->meshes[i].positions, b->meshes[i].positions) << what;
      EXPECT_EQ(a->meshes[i].triangles, b->meshes[i].triangles) << what;
    }
    EXPECT_EQ(a->project, b->project) << what;
    return;
  }
  EXPECT_EQ(a.status().code(), b.status().code()) << what;
  EXPECT_EQ(a.status().message(), b.status().message()) << what;
  EXPECT_EQ(DetailOf(a.status()).reason, DetailOf(b.status()).reason) << what;
  EXPECT_EQ(DetailOf(a.status()).metadata, DetailOf(b.status()).metadata) << what;
}

void ExpectTheSameAsDirectly(const std::string& bytes, const std::string& what) {
  for (const ReadDepth depth : {ReadDepth::kStructure, ReadDepth::kMeshes})
    ExpectTheSame(Product().Read(bytes, MeshFormat::kUnknown, kLimit, depth, {}),
                  ReadMeshFile(bytes, MeshFormat::kUnknown, kLimit, depth, {}), what);
}

std::vector<std::string> CorpusNames(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SLICEFARM_CORPUS "/") + folder))
    names.push_back(folder + "/" + entry.path().filename().string());
  EXPECT_FALSE(names.empty()) << folder;
  return names;
}

TEST(SandboxedMeshSource, GivesTheTrianglesOfEveryModel) {
  for (const std::string& name : CorpusNames("models"))
    ExpectTheSameAsDirectly(CorpusFile(name), name);
}

TEST(SandboxedMeshSource, GivesTheErrorsOfDirectReading) {
  for (const std::string folder : {"fuzz/stl", "fuzz/obj", "fuzz/ply", "fuzz/3mf", "fuzz/slice"}) {
    for (const std::string& name : CorpusNames(folder)) {
      const std::string bytes = CorpusFile(name);
      ExpectTheSameAsDirectly(bytes, name);
      for (const size_t divisor : {2, 3, 7})
        ExpectTheSameAsDirectly(bytes.substr(0, bytes.size() / divisor), name + ", cut");
    }
  }
  const std::string box = ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30}));
  for (const std::string& bytes : {std::string(), std::string("hello"), "PK\x03\x04" + box})
    ExpectTheSameAsDirectly(bytes, "no mesh");
  constexpr ReadDepth kDepth = ReadDepth::kMeshes;
  ExpectTheSame(Product().Read(box, MeshFormat::kObj, kLimit, kDepth, {}),
                ReadMeshFile(box, MeshFormat::kObj, kLimit, kDepth, {}), "another format");
  ExpectTheSame(Product().Read(box, MeshFormat::kStl, 25, kDepth, {}),
                ReadMeshFile(box, MeshFormat::kStl, 25, kDepth, {}), "beyond the limit");
}

/// The file has a million faces in the fewest bytes, and as many corners as possible.
TEST(SandboxedMeshSource, HasMemoryEnoughForHostileFiles) {
  std::string fans = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int face = 0; face < 1000; ++face) {
    fans += "f";
    for (int corner = 0; corner < 1002; ++corner) fans += corner % 3 == 0 ? " 1" : " 2";
    fans += "\n";
  }
  ExpectTheSameAsDirectly(fans, "fans");
  RawMesh soup;
  for (uint32_t i = 0; i < 200'000; ++i) {
    for (int corner = 0; corner < 3; ++corner)
      soup.positions.push_back({i * 0.001, corner * 1.0, i % 7 * 1.0});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  ExpectTheSameAsDirectly(ToBinaryStl(soup), "soup");
}

TEST(SandboxedMeshSource, ACrashIsTheMeshsFault) {
  const absl::Status status = Do(TakenOver(), "crash");
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_EQ(ReasonOf(status), Reason::kMeshReaderCrashed);
  if (kSanitizedBuild) return;  // its runtime turns signals into exit codes
  EXPECT_EQ(DetailOf(status).metadata["signal"], std::to_string(SIGSEGV));
  EXPECT_THAT(std::string(status.message()), HasSubstr("Segmentation fault"));
}

TEST(SandboxedMeshSource, StrictKillsAtSystemCalls) {
  for (const std::string deed : {"open", "socket", "fork", "exec", "hide", "write"}) {
    if (kSanitizedBuild && deed == "write") continue;  // its runtime reports on stderr
    const absl::Status status = Do(TakenOver(), deed);
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << deed << status;
    EXPECT_EQ(ReasonOf(status), Reason::kMeshReaderCrashed) << deed;
    EXPECT_EQ(DetailOf(status).metadata["signal"], std::to_string(SIGSYS)) << deed << status;
  }
}

TEST(SandboxedMeshSource, LimitsLeaveNoFilesNorSockets) {
  if (kSanitizedBuild) GTEST_SKIP() << "files are not limited";
  for (const std::string deed : {"open", "socket"}) {
    const absl::Status status = Do(TakenOver(Confinement::kLimits), deed);
    EXPECT_EQ(ReasonOf(status), Reason::kMeshMalformed) << deed << status;
    EXPECT_EQ(status.message(), "EMFILE") << deed;
  }
}

TEST(SandboxedMeshSource, TheReaderKnowsNothingOfTheService) {
  setenv("SECRET", "x", 1);
  const absl::Status status = Do(TakenOver(Confinement::kLimits), "look around");
  const std::string reported = kSanitizedBuild ? "told" : "untold";
  EXPECT_EQ(status.message(),
            reported + " 0 open, dumpable 0, no new privileges 1, deaf to 1 2 3 15");
}

TEST(SandboxedMeshSource, MemoryIsBounded) {
  if (kSanitizedBuild) GTEST_SKIP() << "memory is not limited";
  for (const Confinement confinement : {Confinement::kLimits, Confinement::kStrict}) {
    const absl::Status status = Do(TakenOver(confinement), "eat");
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_EQ(ReasonOf(status), Reason::kMeshTooExpensive);
    EXPECT_EQ(DetailOf(status).metadata["resource"], "memory_bytes");
    EXPECT_EQ(DetailOf(status).metadata["limit"], std::to_string(kUsual.memory_bytes));
  }
}

TEST(SandboxedMeshSource, ReadersShareTheirMemory) {
  ByteBudget memory(128 << 20);
  const auto source = [&](const char* program) {
    return SandboxedMeshSource(
        {.program = program, .limits = [](std::string_view) { return kUsual; }, .memory = &memory});
  };
  {
    const auto others = memory.Take(1, {});
    ASSERT_TRUE(others.ok());
    int polls = 0;
    const CancelToken soon([&polls] { return ++polls > 2; });
    EXPECT_EQ(ReasonOf(Do(source(MISBEHAVING_READER), "eat", soon)), Reason::kCancelled)
        << "it waits for room";
  }
  EXPECT_TRUE(source(MESH_READER).Probe().ok()) << source(MESH_READER).Probe();
  if (kSanitizedBuild) return;  // memory is not limited
  const absl::Status status = Do(source(MISBEHAVING_READER), "eat");
  EXPECT_EQ(ReasonOf(status), Reason::kMeshTooExpensive) << status;
  EXPECT_EQ(DetailOf(status).metadata["limit"], std::to_string(memory.limit()));
}

TEST(SandboxedMeshSource, TimeIsBounded) {
  const absl::Status status =
      Do(TakenOver(Confinement::kStrict, {.memory_bytes = 256 << 20, .cpu_s = 1}), "spin");
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_EQ(ReasonOf(status), Reason::kMeshTooExpensive);
  EXPECT_EQ(DetailOf(status).metadata["resource"], "cpu_s");
  EXPECT_EQ(DetailOf(status).metadata["limit"], "1");
}

TEST(SandboxedMeshSource, NoAnswerIsBelievedUnchecked) {
  for (const std::string deed :
       {"babble", "break", "boast", "wrap", "swell", "multiply", "withhold", "refer beyond",
        "say no role", "say no text", "invent", "ramble", "excuse", "overreach", "say nan",
        "say infinity", "say far", "be another"}) {
    const absl::Status status = Do(TakenOver(), deed + std::string(100, ' '));
    const bool of_another_build = deed == "babble" || deed == "be another";
    EXPECT_EQ(ReasonOf(status),
              of_another_build ? Reason::kBuildMismatch : Reason::kMeshReaderCrashed)
        << deed << status;
  }
}

/// The test kills the reader like a system without memory: it chooses the process that offered
/// itself.
TEST(SandboxedMeshSource, AKillFromOutsideIsToldAsSuch) {
  const auto offers_itself = [](pid_t pid) { return ProcText(pid, "oom_score_adj") == "1000"; };
  std::thread killer([&] {
    std::vector<pid_t> readers;
    while (readers.empty() || !offers_itself(readers[0])) readers = ChildrenOf(getpid());
    kill(readers[0], SIGKILL);
  });
  const absl::Status status = Do(TakenOver(), "spin");
  killer.join();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_EQ(ReasonOf(status), Reason::kMeshReaderKilled);
}

TEST(SandboxedMeshSource, CancelKillsTheReader) {
  for (const std::string deed : {"spin", "hide"}) {
    const CancelToken once_it_runs([] { return !ChildrenOf(getpid()).empty(); });
    const absl::Status status = Do(TakenOver(Confinement::kLimits), deed, once_it_runs);
    EXPECT_TRUE(absl::IsCancelled(status)) << deed << status;
    EXPECT_THAT(ChildrenOf(getpid()), testing::IsEmpty()) << deed;
  }
  const CancelToken before([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(Do(Product(), "", before)) ||
              absl::IsCancelled(Do(Product(), "v", before)));
}

TEST(SandboxedMeshSource, AThousandCallsOfManyThreadsLeaveNothingBehind) {
  const std::string box = ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30}));
  const SandboxedMeshSource source = TakenOver();
  const int files = OpenFiles();
  std::atomic<int> wrong = 0;
  const auto calls = [&] {
    for (int i = 0; i < 250; ++i) {
      int polls = 0;
      const CancelToken soon([&polls] { return ++polls > 2; });
      switch (i % 4) {
        case 0:
          wrong += ReasonOf(Do(source, "crash")) != Reason::kMeshReaderCrashed;
          break;
        case 1:
          wrong += ReasonOf(Do(source, "break  ")) != Reason::kMeshReaderCrashed;
          break;
        case 2:
          wrong += ReasonOf(Do(source, "spin", soon)) != Reason::kCancelled;
          break;
        case 3:
          wrong += source.Read(box, MeshFormat::kUnknown, kLimit, ReadDepth::kMeshes, {})
                       ->meshes[0]
                       .triangles.size() != 12;
          break;
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) threads.emplace_back(calls);
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(OpenFiles(), files);
  EXPECT_THAT(ChildrenOf(getpid()), testing::IsEmpty());
}

TEST(SandboxedMeshSource, ProbeTellsWhetherItWorks) {
  EXPECT_TRUE(Product().Probe().ok()) << Product().Probe();
  const SandboxedMeshSource nowhere({.program = "/nowhere/slicefarm-mesh-reader"});
  EXPECT_TRUE(absl::IsUnavailable(nowhere.Probe())) << nowhere.Probe();
  const SandboxedMeshSource no_reader({.program = "/bin/true"});
  EXPECT_FALSE(no_reader.Probe().ok());
}

}  // namespace
}  // namespace slicefarm::slicing::sandboxed_mesh_source_test
