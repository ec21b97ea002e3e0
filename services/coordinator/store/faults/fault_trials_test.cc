#include "services/coordinator/store/faults/fault_trials_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>
#include <set>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/temp_directory_test.h"

namespace slicefarm::coordinator {
namespace {

constexpr int kTries = 3;
/// Largest number of reported violations; it is sufficient to find the cause.
constexpr size_t kMaxViolations = 20;

struct TrialResults {
  int64_t calls = 0;              ///< number of calls of a life without faults
  std::set<std::string> sites{};  ///< call sites: function and part of the directory
  int64_t trials = 0;
  std::vector<std::string> violations{};
};

struct ErrorPlan {
  int64_t call = 0;
  Fault fault = Fault::kEio;
  bool lasts = false;
  bool reopens = false;  ///< true if the state is opened again after a failed step
};

/// Runs the steps. Returns all failures except errors that state their cause.
std::vector<std::string> Live(StoreLife& life, DiskCalls& disk, const ErrorPlan& plan) {
  std::vector<std::string> violations;
  std::vector<LifeStep> steps = life.Steps();
  steps.insert(steps.begin(), {"open", [&] { return life.Open(); }});
  for (const LifeStep& step : steps) {
    absl::Status status;
    for (int i = 0; i < kTries; ++i) {
      status = step.run();
      if (status.ok()) break;
      if (!disk.struck()) violations.push_back(step.name + " fails without a reason");
      if (!life.Reports(status, plan.fault))
        violations.push_back(absl::StrCat(step.name, ": ", status.ToString()));
      if (plan.reopens) life.Close();
      disk.Heal();
      if (plan.reopens && step.name != "open") {
        if (const absl::Status opened = life.Open(); !opened.ok()) return {opened.ToString()};
      }
    }
    if (!status.ok()) {
      violations.push_back(absl::StrCat(step.name, " does not work again: ", status.ToString()));
      return violations;
    }
  }
  return violations;
}

/// Returns a directory in memory if there is one, so that no test waits for a disk.
std::string FastPlace() {
  return access("/dev/shm/", W_OK) == 0 ? "/dev/shm/" : testing::TempDir();
}

/// Content of a directory before a life.
class Beginning {
 public:
  explicit Beginning(const TrialOptions& options) {
    std::filesystem::create_directory(path());
    options.prepare(path());
  }
  std::string path() const { return directory_.path() + "/state"; }

 private:
  TempDirectory directory_{FastPlace()};
};

/// Directory for one life.
class Place {
 public:
  explicit Place(const Beginning& beginning) {
    std::filesystem::copy(beginning.path(), path(), std::filesystem::copy_options::recursive);
  }
  std::string path() const { return directory_.path() + "/state"; }

 private:
  TempDirectory directory_{FastPlace()};
};

void Report(std::vector<std::string> found, const std::string& where, TrialResults& results) {
  for (const std::string& what : found) {
    if (results.violations.size() < kMaxViolations)
      results.violations.push_back(where + ": " + what);
  }
}

/// Returns the violations that Check finds in the image of a disk.
std::vector<std::string> CheckImage(const StoreLife& life, const CrashDisk& disk, Leftover leftover,
                                    std::mt19937_64& random, size_t changes) {
  TempDirectory directory(FastPlace());
  const std::string image = directory.path() + "/state";
  disk.WriteImage(image, leftover, random);
  std::vector<std::string> found;
  std::vector<DiskChange> during;
  CrashDisk second;
  {
    DiskCalls calls(image);
    second = calls.before();
    found = life.Check(image, changes);
    during = calls.changes();
  }
  if (during.empty() || leftover != Leftover::kAnything) return found;
  const size_t cut = random() % during.size();
  for (size_t i = 0; i < cut; ++i) second.Apply(during[i]);
  const std::string again = directory.path() + "/again";
  second.WriteImage(again, leftover, random);
  DiskCalls quiet(again);
  for (const std::string& what : life.Check(again, changes))
    found.push_back("after a second power cut: " + what);
  return found;
}

void RunWithError(const TrialOptions& options, const Beginning& beginning, const ErrorPlan& plan,
                  TrialResults& results) {
  Place place(beginning);
  std::unique_ptr<DiskCalls> disk = std::make_unique<DiskCalls>(place.path(), options.lie);
  const auto life = options.life(*disk, place.path());
  disk->FailAt(plan.call, plan.fault, plan.lasts);
  std::vector<std::string> found = Live(*life, *disk, plan);
  const DiskCall& call = disk->calls()[plan.call];
  const std::string where =
      absl::StrCat("call ", plan.call, " ", call.function, " ", call.path, " ",
                   std::string(FaultName(plan.fault)), plan.lasts ? " from then on" : " once",
                   plan.reopens ? ", opened again" : "");
  disk->Heal();
  const CrashDisk now = disk->now();
  const size_t changes = disk->changes().size();
  life->Close();
  if (found.empty()) found = life->Check(place.path(), changes);
  Report(std::move(found), where, results);
  disk.reset();
  std::mt19937_64 random(options.seed + plan.call);
  const Leftover leftover = random() % 2 == 0 ? Leftover::kNothing : Leftover::kAnything;
  Report(CheckImage(*life, now, leftover, random, changes), where + ", then a power cut", results);
  ++results.trials;
}

std::string SiteOf(const DiskCall& call) {
  return call.function + " " + call.path.substr(0, call.path.find('/'));
}

void Describe(const DiskCalls& disk, TrialResults& results) {
  results.calls = static_cast<int64_t>(disk.calls().size());
  for (const DiskCall& call : disk.calls()) results.sites.insert(SiteOf(call));
}

/// Returns the planned errors by call site.
std::map<std::string, std::vector<ErrorPlan>> PlansFor(const std::vector<DiskCall>& calls) {
  std::map<std::string, std::vector<ErrorPlan>> by_site;
  for (size_t i = 0; i < calls.size(); ++i) {
    std::vector<ErrorPlan>& plans = by_site[SiteOf(calls[i])];
    for (const Fault fault : calls[i].faults) {
      const auto call = static_cast<int64_t>(i);
      plans.push_back({call, fault, /*lasts=*/false, /*reopens=*/false});
      if (fault == Fault::kEintr) continue;  // a lasting EINTR would not be an interruption
      plans.push_back({call, fault, /*lasts=*/true, /*reopens=*/false});
      plans.push_back({call, fault, /*lasts=*/true, /*reopens=*/true});
    }
  }
  return by_site;
}

TrialResults InjectErrors(const TrialOptions& options) {
  TrialResults results;
  const Beginning beginning(options);
  std::map<std::string, std::vector<ErrorPlan>> by_site;
  {
    Place place(beginning);
    DiskCalls disk(place.path(), options.lie);
    const auto life = options.life(disk, place.path());
    Report(Live(*life, disk, {}), "without a fault", results);
    Describe(disk, results);
    by_site = PlansFor(disk.calls());
  }
  for (const auto& [site, plans] : by_site) {
    const int64_t step = (std::ssize(plans) - 1) / options.errors_a_site + 1;
    for (int64_t i = options.seed % step; i < std::ssize(plans); i += step)
      RunWithError(options, beginning, plans[i], results);
  }
  return results;
}

TrialResults CutPower(const TrialOptions& options) {
  TrialResults results;
  Place place((Beginning(options)));
  auto disk = std::make_unique<DiskCalls>(place.path(), options.lie);
  const auto life = options.life(*disk, place.path());
  Report(Live(*life, *disk, {}), "without a fault", results);
  Describe(*disk, results);
  life->Close();
  CrashDisk state = disk->before();
  const std::vector<DiskChange> changes = disk->changes();
  disk.reset();

  std::mt19937_64 random(options.seed);
  for (int64_t cut = 0; cut <= std::ssize(changes); ++cut) {
    if (cut > 0) state.Apply(changes[cut - 1]);
    if (cut % options.cut_every != options.seed % options.cut_every) continue;
    constexpr std::array kLeftovers = {Leftover::kNothing, Leftover::kEverything,
                                       Leftover::kAnything, Leftover::kAnything};
    const Leftover leftover = kLeftovers[random() % kLeftovers.size()];
    Report(CheckImage(*life, state, leftover, random, cut),
           absl::StrCat("power cut after change ", cut, " of ", changes.size()), results);
    ++results.trials;
  }
  return results;
}

void RecordTrials(const TrialResults& results) {
  const auto record = [](const char* name, size_t value) {
    std::cout << "  " << name << ": " << value << "\n";
    testing::Test::RecordProperty(name, std::to_string(value));
  };
  record("calls", results.calls);
  record("sites", results.sites.size());
  record("trials", results.trials);
  record("violations", results.violations.size());
}

}  // namespace

bool StoreLife::Reports(const absl::Status& status, Fault) const {
  const Reason reason = DetailOf(status).reason;
  return reason == Reason::kStoreFailed || reason == Reason::kDiskFull;
}

void ExpectErrorsAreSeenTo(const TrialOptions& options) {
  const TrialResults results = InjectErrors(options);
  EXPECT_THAT(results.violations, testing::IsEmpty());
  RecordTrials(results);
}

void ExpectPowerCutsAreSurvived(TrialOptions options, int64_t seeds) {
  for (options.seed = 1; options.seed <= seeds; ++options.seed) {
    const TrialResults results = CutPower(options);
    EXPECT_THAT(results.violations, testing::IsEmpty()) << "seed " << options.seed;
    RecordTrials(results);
  }
}

void ExpectNoticed(Lie lie, TrialOptions options) {
  options.lie = lie;
  EXPECT_THAT(CutPower(options).violations, testing::Not(testing::IsEmpty()));
}

}  // namespace slicefarm::coordinator
