#include "reports/pages/kill_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus::reports {

namespace {

std::vector<const MutantRecord*> chosen(const Mutants& mutants, bool bugs) {
  std::vector<const MutantRecord*> list;
  for (const MutantRecord& mutant : mutants.mutants) {
    if ((mutant.operation == "bug") == bugs) list.push_back(&mutant);
  }
  return list;
}

std::set<std::string> killers_of(const MutantRecord& mutant) {
  std::set<std::string> cases;
  for (const Trial& trial : mutant.trials) {
    if (kills(trial)) cases.insert(trial.case_id);
  }
  return cases;
}

}  // namespace

Interval wilson(std::size_t successes, std::size_t all) {
  if (all == 0) return {0.0, 1.0};
  constexpr double z = 1.959963984540054;  // quantile of the normal distribution: 2.5 % lie above
  const double n = static_cast<double>(all);
  const double p = static_cast<double>(successes) / n;
  const double middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

std::vector<const MutantRecord*> generated(const Mutants& mutants) { return chosen(mutants, false); }
std::vector<const MutantRecord*> written(const Mutants& mutants) { return chosen(mutants, true); }

Score score_of(const std::vector<const MutantRecord*>& mutants) {
  Score score;
  for (const MutantRecord* mutant : mutants)
    count(score, *mutant);
  return score;
}

namespace {

/// Leaves out the cases for which `omitted` holds.
template <class Omitted>
Mutants without(Mutants mutants, Omitted omitted) {
  std::set<std::string> left_out;
  for (const records::UnchangedCase& one : mutants.cases) {
    if (omitted(one)) left_out.insert(one.id);
  }
  std::erase_if(mutants.cases, omitted);
  for (MutantRecord& mutant : mutants.mutants) {
    std::erase_if(mutant.trials, [&](const Trial& trial) { return left_out.contains(trial.case_id); });
    std::erase_if(mutant.covered_by, [&](const std::string& id) { return left_out.contains(id); });
    const bool noticed = std::any_of(mutant.trials.begin(), mutant.trials.end(), records::kills);
    if (mutant.status == records::MutantStatus::killed && !noticed)
      mutant.status = mutant.covered_by.empty() ? records::MutantStatus::unreached : records::MutantStatus::survived;
  }
  return mutants;
}

}  // namespace

Mutants without_recorded(Mutants mutants) {
  return without(std::move(mutants), [](const records::UnchangedCase& one) { return one.recorded; });
}

Mutants of_matrix(Mutants mutants) {
  return without(std::move(mutants), [](const records::UnchangedCase& one) { return !one.in_matrix; });
}

bool kills_at(const Trial& trial, double factor) {
  if (trial.end != records::TrialEnd::pass && trial.end != records::TrialEnd::fail) return true;
  return trial.ratio > factor;
}

double fraction_at(const Mutants& mutants, const std::vector<const MutantRecord*>& of, double factor,
                   const std::string& family) {
  std::set<std::string> members;
  for (const records::UnchangedCase& one : mutants.cases) {
    if (family.empty() || one.family == family) members.insert(one.id);
  }
  std::size_t killed = 0;
  std::size_t counted = 0;
  for (const MutantRecord* mutant : of) {
    if (mutant->status == records::MutantStatus::equivalent) continue;
    ++counted;
    const bool noticed = std::any_of(mutant->trials.begin(), mutant->trials.end(), [&](const Trial& trial) {
      return members.count(trial.case_id) > 0 && kills_at(trial, factor);
    });
    killed += noticed ? 1 : 0;
  }
  return counted == 0 ? 0.0 : static_cast<double>(killed) / static_cast<double>(counted);
}

std::vector<Greedy> greedy_order(const Mutants& mutants, const std::vector<const MutantRecord*>& of) {
  std::vector<std::set<std::string>> left;
  for (const MutantRecord* mutant : of)
    left.push_back(killers_of(*mutant));
  std::vector<records::UnchangedCase> cases = mutants.cases;
  std::stable_sort(cases.begin(), cases.end(), [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  std::vector<Greedy> order;
  while (true) {
    Greedy best;
    for (const records::UnchangedCase& one : cases) {
      const auto more = static_cast<std::size_t>(
          std::count_if(left.begin(), left.end(), [&](const auto& killing) { return killing.count(one.id) > 0; }));
      if (more > best.more) best = {one.id, more};
    }
    if (best.more == 0) return order;
    order.push_back(best);
    std::erase_if(left, [&](const auto& killing) { return killing.count(best.case_id) > 0; });
  }
}

std::map<std::string, std::size_t> lone_killers(const std::vector<const MutantRecord*>& of) {
  std::map<std::string, std::size_t> alone;
  for (const MutantRecord* mutant : of) {
    const auto killing = killers_of(*mutant);
    if (killing.size() == 1) ++alone[*killing.begin()];
  }
  return alone;
}

std::set<std::string> killers(const std::vector<const MutantRecord*>& of) {
  std::set<std::string> cases;
  for (const MutantRecord* mutant : of)
    cases.merge(killers_of(*mutant));
  return cases;
}

}  // namespace talus::reports
