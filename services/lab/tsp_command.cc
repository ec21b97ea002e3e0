#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "common/base/text.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/lab/commands.h"
#include "services/lab/tours/christofides.h"
#include "services/lab/tours/first_tours.h"
#include "services/lab/tours/spanning_tree.h"
#include "services/ordering/algo/tours/constructions.h"
#include "services/ordering/algo/tours/tour_search.h"
#include "services/ordering/algo/tours/tsplib.h"

namespace slicefarm::lab {
namespace {

using ordering::SearchDepth;
using ordering::Tour;
using Clock = std::chrono::steady_clock;

constexpr int64_t kMaxBytes = 256 << 20;
constexpr size_t kNeighbours = 5;
constexpr size_t kPerQuadrant = 3;
/// Number of moves per second that a machine with other work reaches. The search ends after a
/// number of moves, so that a seed always gives the same tour. On a machine that is too slow for
/// this, the search ends by time.
constexpr double kMovesPerSecond = 6e6;
/// Number of exchanges between two checks of the clock.
constexpr int64_t kExchangesAtOnce = 64;
/// Cost model of the bound. kPairsPerMove: pairs of nodes that a 1-tree visits in the time of one
/// move. kBoundShare: share of all work that is spent on the bound. kMostIterations: more
/// iterations improve the bound only slightly.
constexpr double kPairsPerMove = 20;
constexpr double kBoundShare = 0.2;
constexpr double kMostIterations = 300;

enum class Start { kNearest, kGreedy, kInsertion, kChristofides };

struct TspOptions {
  std::string file;
  std::string tour;
  double seconds = 1;
  uint32_t seed = 1;
  Start start = Start::kGreedy;
  SearchDepth depth = SearchDepth::kChains;
  bool local = false;
  bool bounds = false;
};

Tour StartingTour(const ordering::TspInstance& instance, const ordering::Neighbours& neighbours,
                  Start start) {
  const ordering::Costs& costs = instance.costs;
  if (start == Start::kGreedy) return GreedyEdgeTour(costs, neighbours, instance.fixed);
  const Tour tour = start == Start::kNearest     ? NearestNeighbourTour(costs, 0)
                    : start == Start::kInsertion ? InsertionTour(costs)
                                                 : ChristofidesTour(costs);
  return WithFixedEdges(tour, ordering::FixedEdges(costs.size(), instance.fixed));
}

struct Solution {
  Tour tour;
  int64_t lower_bound = 0;
};

Solution Solve(const ordering::TspInstance& instance, const TspOptions& options,
               Clock::time_point end) {
  const ordering::Costs& costs = instance.costs;
  const ordering::Neighbours neighbours(costs, kNeighbours, kPerQuadrant);
  const ordering::TourRules rules{.fixed = instance.fixed, .before = {}};
  ordering::TourSearch search(costs, neighbours, rules,
                              StartingTour(instance, neighbours, options.start), options.depth,
                              options.seed);
  ordering::WorkBudget unlimited{std::numeric_limits<int64_t>::max()};
  search.Improve(unlimited);
  const double pairs = static_cast<double>(costs.size()) * costs.size() / 2;
  const double moves = options.seconds * kMovesPerSecond;
  const double iterations =
      std::clamp(kBoundShare * moves * kPairsPerMove / pairs, 10.0, kMostIterations);
  const int64_t bound = OneTreeBound(costs, instance.fixed,
                                     {.iterations = static_cast<int>(iterations),
                                      .upper_bound = TourLength(costs, search.tour())});
  ordering::WorkBudget budget{static_cast<int64_t>((1 - kBoundShare) * moves)};
  while (!options.local && budget.moves > 0 && Clock::now() < end &&
         TourLength(costs, search.tour()) > bound) {
    search.Iterate(kExchangesAtOnce, budget);
  }
  return {search.tour(), bound};
}

std::string BoundRows(const ordering::Costs& costs) {
  const SpanningTree tree = MinimumSpanningTree(costs);
  std::vector<int> degree(static_cast<size_t>(costs.size()), 0);
  for (const ordering::NodePair& edge : tree.edges) {
    ++degree[static_cast<size_t>(edge.a)];
    ++degree[static_cast<size_t>(edge.b)];
  }
  std::vector<int32_t> odd;
  for (int32_t node = 0; node < costs.size(); ++node) {
    if (degree[static_cast<size_t>(node)] % 2 == 1) odd.push_back(node);
  }
  int64_t matching = 0;
  for (const ordering::NodePair& pair : MinimumMatching(costs, odd))
    matching += costs(pair.a, pair.b);
  return fmt::format("spanning_tree {}\nodd_matching {}\n", tree.length, matching);
}

cli::ExitCode Tsp(const TspOptions& options) {
  const Clock::time_point start = Clock::now();
  const auto text = cli::ReadFile(options.file, kMaxBytes);
  if (!text.ok()) return cli::Fail(text.status());
  const auto instance = ordering::ReadTsplib(*text);
  if (!instance.ok()) return cli::Fail(cli::InFile(options.file, instance.status()));
  const auto limit =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds));
  const Solution solution = Solve(*instance, options, start + limit);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const std::string name = ReplaceControls(instance->name, ' ');
  if (!options.tour.empty()) {
    const absl::Status written =
        cli::WriteFile(options.tour, ordering::PrintTour(name, solution.tour));
    if (!written.ok()) return cli::Fail(written);
  }
  cli::Print(fmt::format("name {}\nn {}\nlength {}\nlower_bound {}\nseconds {:.3f}\n",
                         name.empty() ? "-" : name, instance->costs.size(),
                         TourLength(instance->costs, solution.tour), solution.lower_bound,
                         seconds));
  if (options.bounds) cli::Print(BoundRows(instance->costs));
  return cli::ExitCode::kOk;
}

}  // namespace

void AddTsp(CLI::App& app, cli::CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("tsp", "Compute a short tour of a travelling-salesman instance");
  const auto options = std::make_shared<TspOptions>();
  command->add_option("FILE.tsp", options->file, "Instance in TSPLIB format")->required();
  command
      ->add_option("--seconds", options->seconds,
                   "Time limit in seconds, not counting a first tour and a bound")
      ->check(cli::InRange(0.0, 86400.0))
      ->capture_default_str()
      ->type_name("S");
  command->add_option("--seed", options->seed, "Seed of the random exchanges")
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--tour", options->tour, "File for the tour")->type_name("FILE");
  command
      ->add_option("--start", options->start,
                   "Construction of the first tour: nearest, greedy, insertion or christofides")
      ->transform(cli::OneOf(std::map<std::string, Start>{{"nearest", Start::kNearest},
                                                          {"greedy", Start::kGreedy},
                                                          {"insertion", Start::kInsertion},
                                                          {"christofides", Start::kChristofides}}))
      ->default_str("greedy")
      ->type_name("NAME");
  command
      ->add_option("--moves", options->depth,
                   "Improvement: none, 2opt (and Or-opt), 3opt or chains")
      ->transform(
          cli::OneOf(std::map<std::string, SearchDepth>{{"none", SearchDepth::kNone},
                                                        {"2opt", SearchDepth::kTwoOptAndOrOpt},
                                                        {"3opt", SearchDepth::kThreeOpt},
                                                        {"chains", SearchDepth::kChains}}))
      ->default_str("chains")
      ->type_name("NAME");
  command->add_flag("--local", options->local, "Use moves only, no exchanges");
  command->add_flag(
      "--bounds", options->bounds,
      "Print the lengths of the minimum spanning tree and of a matching of its odd nodes too");
  command->footer(
      "Prints rows: name n length lower_bound seconds. The lower bound is the Held-Karp "
      "bound.\nWork is counted in moves: the same seed gives the same tour unless the time limit "
      "ends it.\nExample:\n  slicefarm-lab tsp berlin52.tsp --seconds 1 --seed 7 --tour "
      "berlin52.tour");
  command->callback([options, &context] { context.run = [options] { return Tsp(*options); }; });
}

}  // namespace slicefarm::lab
