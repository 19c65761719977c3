#include "solver/app/capacity/capacity_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "solver/app/sweep/executed_runs.hpp"
#include "solver/base/error.hpp"

namespace talus::app {
namespace {

/// What random numbers are for, so that no two purposes have the same ones.
enum Purpose : std::uint32_t { for_trials, for_audit, for_hazard, for_rock };

/// Errors: InputError for a finished run whose verdict is not known: its file was changed, or is of another version.
RockEnd end_of(const SweepResult& result, const SweepFolder& folder) {
  if (result.end != SweepEnd::finished) return RockEnd::failed;
  return value_named<RockEnd>(fmt::format("{}: verdict of run {}", folder.folder.string(), result.id), result.verdict);
}

/// What the random numbers of a trial are for: place of its node, and height, spin and position of its rocks, which a
/// finer map and a question about more rocks share, so that their runs count there, too.
std::vector<std::uint32_t> purpose_of(const RockMap& map, MapNode node, std::size_t trial) {
  const int cells = map.map.rules().cells, i = std::gcd(node.i, cells), j = std::gcd(node.j, cells);
  std::vector<std::uint32_t> purpose{for_trials};
  for (const double number : {map.rock.height, map.rock.spin, map.rock.along}) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    purpose.insert(purpose.end(), {static_cast<std::uint32_t>(bits >> 32U), static_cast<std::uint32_t>(bits)});
  }
  for (const int word : {node.i / i, cells / i, node.j / j, cells / j})
    purpose.push_back(static_cast<std::uint32_t>(word));
  purpose.push_back(static_cast<std::uint32_t>(trial));
  return purpose;
}

/// Standard normal quantile of a number in [-1, 1), its middle being the median.
double normal_of(double number) {
  // The first number would be at minus infinity.
  const double inside = std::max(number, -1.0 + 0x1p-52);
  return std::numbers::sqrt2 * boost::math::erf_inv(inside);
}

}  // namespace

std::array<std::size_t, 6> RockTrials::ends() const {
  std::array<std::size_t, 6> counts{};
  for (const RockTrial& trial : trials)
    ++counts[static_cast<std::size_t>(trial.end)];
  return counts;
}

bool RockTrials::all_failed() const {
  return !trials.empty() && std::ranges::all_of(trials, [](const RockTrial& of) { return of.end == RockEnd::failed; });
}

std::vector<double> RockTrials::values(std::size_t output) const {
  std::vector<double> values;
  for (const RockTrial& trial : trials)
    if (trial.end != RockEnd::failed) values.push_back(trial.outputs[output]);
  return values;
}

CapacityStudy::CapacityStudy(const CapacityFile& file, const SweepFolder& folder, const SweepBase& base,
                             const RockRuns& rocks, unsigned threads)
    : file_{&file}, folder_{&folder}, base_{&base}, rocks_{&rocks}, threads_{threads} {
  write_sweep_folder(folder);
  for (SweepResult& result : all_results(folder)) {
    std::string id = result.id;
    known_.emplace(std::move(id), std::move(result));
  }
  const auto or_own = [](const std::vector<double>& list, double own) {
    return list.empty() ? std::vector{own} : list;
  };
  for (const double height : or_own(file.heights, rocks.own().height)) {
    for (const double spin : or_own(file.spins, rocks.own().spin)) {
      for (const double along : or_own(file.positions, rocks.own().along)) {
        RockMap map{{.height = height, .spin = spin, .along = along}, CapacityMap{file.map}, {}, {}, {}, 0};
        map.nodes.resize(static_cast<std::size_t>(map.map.side()) * static_cast<std::size_t>(map.map.side()));
        maps_.push_back(std::move(map));
      }
    }
  }
}

Rock CapacityStudy::rock_at(const RockMap& map, MapNode node) const {
  const double count = map.map.rules().cells;
  Rock rock = map.rock;
  rock.mass = std::lerp(file_->mass[0], file_->mass[1], node.i / count);
  rock.speed = std::lerp(file_->speed[0], file_->speed[1], node.j / count);
  return rock;
}

std::optional<std::vector<RockTrial>> CapacityStudy::executed(const std::vector<Request>& requests) {
  std::vector<std::string> ids;
  const std::size_t before = runs_.size();
  for (const Request& request : requests) {
    SweptRun run = rocks_->run(request.rock, random_numbers(file_->seed, request.purpose));
    ids.push_back(run.id);
    if (ids_.insert(run.id).second) runs_.push_back(std::move(run));
  }
  std::vector<const SweptRun*> missing;
  for (std::size_t i = before; i < runs_.size(); ++i)
    if (!known_.contains(runs_[i].id)) missing.push_back(&runs_[i]);
  execute(*folder_, *base_, missing, threads_, interrupted_, [&](SweepResult&& result) {
    std::string id = result.id;
    known_.emplace(std::move(id), std::move(result));
    progress_(known_.size());
  });
  if (interrupted_()) return {};
  std::vector<RockTrial> trials;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const SweepResult& result = known_.at(ids[i]);
    RockTrial trial{requests[i].rock, end_of(result, *folder_), result.reason, result.values};
    for (std::size_t k = 0; k < trial.outputs.size(); ++k)
      trial.outputs[k] *= si_size(base_->units(), base_->outputs()[k].dimension);
    trials.push_back(std::move(trial));
  }
  return trials;
}

bool CapacityStudy::run_map(RockMap& map) {
  for (std::vector<MapTrials> wanted = map.map.next(); !wanted.empty(); wanted = map.map.next()) {
    std::vector<Request> requests;
    std::vector<MapNode> nodes;
    for (const MapTrials& trials : wanted) {
      for (std::size_t trial = trials.first; trial < trials.last; ++trial) {
        requests.push_back({rock_at(map, trials.node), purpose_of(map, trials.node, trial)});
        nodes.push_back(trials.node);
      }
    }
    std::optional<std::vector<RockTrial>> trials = executed(requests);
    if (!trials) return false;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      map.map.add(nodes[i], (*trials)[i].end == RockEnd::stopped);
      map.nodes[map.map.number(nodes[i])].trials.push_back(std::move((*trials)[i]));
    }
  }
  map.states = map.map.states();
  return true;
}

bool CapacityStudy::audit(RockMap& map) {
  std::vector<MapNode> without;
  for (int j = 0; j < map.map.side(); ++j)
    for (int i = 0; i < map.map.side(); ++i)
      if (map.map.trials({i, j}) == 0) without.push_back({i, j});
  if (without.empty()) return true;
  std::vector<Request> requests;
  std::vector<MapNode> nodes;
  for (std::uint32_t trial = 0; trial < file_->audit; ++trial) {
    const double fraction = 0.5 + 0.5 * random_numbers(file_->seed, {for_audit, trial, 0})[0];
    nodes.push_back(without[static_cast<std::size_t>(fraction * static_cast<double>(without.size()))]);
    requests.push_back({rock_at(map, nodes.back()), {for_audit, trial, 1}});
  }
  std::optional<std::vector<RockTrial>> trials = executed(requests);
  if (!trials) return false;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const MapState state = map.states[map.map.number(nodes[i])];
    if (state == MapState::open) continue;
    map.contradicted += ((*trials)[i].end == RockEnd::stopped) != (state == MapState::above) ? 1 : 0;
    map.audit.trials.push_back(std::move((*trials)[i]));
  }
  return true;
}

bool CapacityStudy::run_hazard() {
  if (!file_->hazard) return true;
  const RockHazard& hazard = *file_->hazard;
  std::vector<Request> requests;
  for (std::uint32_t trial = 0; trial < hazard.runs; ++trial) {
    const std::array<double, 5> numbers = random_numbers(file_->seed, {for_rock, trial});
    Rock rock{hazard.mass.at(normal_of(numbers[0])), hazard.speed.at(normal_of(numbers[1])),
              hazard.height.at(normal_of(numbers[2])), 0.0, 0.0};
    if (!hazard.table.empty()) {
      const double row = (0.5 + 0.5 * numbers[0]) * static_cast<double>(hazard.table.size());
      rock = hazard.table[static_cast<std::size_t>(row)];
    }
    const auto uniform = [](const std::optional<std::array<double, 2>>& ends, double number, double own) {
      return ends ? std::lerp((*ends)[0], (*ends)[1], 0.5 + 0.5 * number) : own;
    };
    if (!hazard.table_has_spin) rock.spin = uniform(hazard.spin, numbers[3], rocks_->own().spin);
    if (!hazard.table_has_along) rock.along = uniform(hazard.along, numbers[4], rocks_->own().along);
    requests.push_back({rock, {for_hazard, trial}});
  }
  std::optional<std::vector<RockTrial>> trials = executed(requests);
  if (!trials) return false;
  hazard_.trials = std::move(*trials);
  return true;
}

bool CapacityStudy::run(const std::function<bool()>& interrupted, const std::function<void(std::size_t)>& progress) {
  interrupted_ = interrupted, progress_ = progress;
  for (RockMap& map : maps_)
    if (!run_map(map) || !audit(map)) return false;
  return run_hazard();
}

}  // namespace talus::app
