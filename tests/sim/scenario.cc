#include "tests/sim/scenario.h"

#include <map>

#include "absl/strings/str_cat.h"

namespace slicefarm::coordinator::sim {
namespace {

Work MakeWork(Random& random, int64_t id) {
  Work work;
  work.id = id;
  work.layers = static_cast<int32_t>(random.Between(1, 40));
  work.layer_us = random.Between(1, random.Chance(500) ? 20 : 150) * kMillisecondUs;
  if (random.Chance(120)) work.fault = static_cast<Work::Fault>(1 + random.Below(3));
  return work;
}

Priority MakePriority(Random& random) {
  return random.Chance(600) ? Priority::kNormal : static_cast<Priority>(random.Below(3));
}

/// Returns the requests of the clients. Some clients request the same work. Some of these are
/// repeated requests of one client, and some of the repetitions have other work under the same
/// request_id.
std::vector<ClientPlan> MakeRequests(Random& random) {
  std::vector<Work> works;
  std::vector<ClientPlan> clients;
  std::map<std::string, int> made;  // number of request ids by tenant
  const int count = 1 + random.Below(random.Chance(700) ? 6 : 12);
  const int tenants = 1 + random.Below(3);
  for (int i = 0; i < count; ++i) {
    const bool again = i > 0 && random.Chance(250);
    if (!again) works.push_back(MakeWork(random, static_cast<int64_t>(works.size())));
    const Work& work = again ? works[random.Below(static_cast<int>(works.size()))] : works.back();
    if (again && random.Chance(500)) {
      clients.push_back(clients[random.Below(i)]);
      if (random.Chance(150)) clients.back().work = work;
      continue;
    }
    ClientPlan client;
    client.work = work;
    client.tenant = absl::StrCat("t", random.Below(tenants));
    client.priority = MakePriority(random);
    // Each tenant numbers its own request ids.
    if (!random.Chance(100)) client.request_id = absl::StrCat("r", made[client.tenant]++);
    clients.push_back(client);
  }
  return clients;
}

std::vector<ClientPlan> MakeClients(Random& random, int64_t until_us) {
  std::vector<ClientPlan> clients = MakeRequests(random);
  const bool crowd = random.Chance(300);  // all at once, so that there are queues
  const bool hurry = random.Chance(300);
  for (ClientPlan& client : clients) {
    client.begin_us = random.Between(0, crowd ? kSecondUs : until_us * 3 / 4);
    if (hurry && random.Chance(500)) client.deadline_us = random.Between(0, 20 * kSecondUs);
    if (random.Chance(250)) client.cancel_after_us = random.Between(0, 5 * kSecondUs);
    client.deletes = random.Chance(400);
  }
  if (random.Chance(250))
    clients.front().yesterday = clients.front().work.fault == Work::Fault::kNone;
  return clients;
}

/// Returns 0 in half of the cases, otherwise a number up to `most`.
int Permille(Random& random, int most) { return random.Chance(500) ? 0 : random.Below(most + 1); }

void MakeCast(Random& random, Scenario& scenario) {
  const bool two_builds = random.Chance(200);
  const bool skewed = random.Chance(300);
  for (int i = random.Below(3); i >= 0; --i) {
    const bool other = two_builds && random.Chance(500);
    scenario.coordinators.push_back(
        {other ? "b2" : "b1", skewed ? random.Between(-2 * kSecondUs, 2 * kSecondUs) : 0});
  }
  for (int i = random.Below(random.Chance(500) ? 8 : 3); i >= 0; --i) {
    scenario.workers.push_back({1 + random.Below(3), random.Chance(200) ? 8 : 1 + random.Below(2)});
  }
}

/// Distributes the jobs over two processes. Some workers support only one of them, but each process
/// has a worker.
void MixProcesses(Random& random, Scenario& scenario) {
  // Equal work has the same process.
  const uint64_t pattern = static_cast<uint64_t>(random.Below(1 << 20));
  for (ClientPlan& client : scenario.clients)
    client.work.process = slicefarm::kProcesses[pattern >> (client.work.id % 20) & 1].process;
  std::vector<WorkerPlan>& workers = scenario.workers;
  if (workers.size() < 2) return;
  for (size_t i = 0; i < workers.size(); ++i) {
    if (i < 2 || random.Chance(300)) workers[i].can = {slicefarm::kProcesses[i % 2].process};
  }
}

/// Makes one work kill the coordinators that run it. Does nothing if there are two builds, because
/// each build counts the lost runs anew.
void MixKiller(Scenario& scenario) {
  for (const CoordinatorPlan& coordinator : scenario.coordinators)
    if (coordinator.build != scenario.coordinators.front().build) return;
  const int64_t killer = scenario.clients.back().work.id;
  for (ClientPlan& client : scenario.clients)
    if (client.work.id == killer) client.work.fault = Work::Fault::kKillsCoordinators;
}

/// Makes a storm: for most of an hour, a coordinator is killed every few seconds.
void MakeStorm(Random& random, Scenario& scenario) {
  scenario.faults = {Fault::kKillCoordinator};
  scenario.quiet_from_us = 3000 * kSecondUs;
  scenario.fault_every_us = random.Between(2, 10) * kSecondUs;
}

}  // namespace

Scenario MakeScenario(Random& random) {
  Scenario scenario;
  MakeCast(random, scenario);
  scenario.quiet_from_us = random.Between(5, 40) * kSecondUs;
  scenario.clients = MakeClients(random, scenario.quiet_from_us);
  for (const ClientPlan& client : scenario.clients) {
    if (random.Chance(500)) scenario.meshes.push_back({client.tenant, MeshOf(client.work)});
  }
  for (int i = 0; i < kFaults; ++i) {
    if (random.Chance(400)) scenario.faults.push_back(static_cast<Fault>(i));
  }
  scenario.fault_every_us = random.Between(300, 6000) * kMillisecondUs;
  if (random.Chance(200)) scenario.max_open = random.Between(1, 3);
  scenario.sweep_every_us = random.Between(1, 20) * kSecondUs;
  if (random.Chance(200)) scenario.keep_jobs_s = static_cast<double>(random.Between(1, 20));
  scenario.changes_told = !random.Chance(200);
  scenario.lost_permille = Permille(random, 100);
  scenario.doubled_permille = Permille(random, 100);
  scenario.store_fault_permille = Permille(random, 100);
  scenario.worker_fault_permille = Permille(random, 150);
  if (random.Chance(400)) MixProcesses(random, scenario);
  if (random.Chance(20)) MixKiller(scenario);
  if (random.Chance(5)) MakeStorm(random, scenario);
  return scenario;
}

}  // namespace slicefarm::coordinator::sim
