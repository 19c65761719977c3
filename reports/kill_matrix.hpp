/// What mutants and the cases that noticed them add up to.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "verification/record/mutants.hpp"

namespace talus::reports {

using records::MutantRecord;
using records::Mutants;
using records::Score;
using records::Trial;

/// Share of a sample and its Wilson interval of 95 % (Wilson 1927): what all candidates would score.
struct Interval {
  double low{};
  double high{};
};
[[nodiscard]] Interval wilson(std::size_t successes, std::size_t all);

/// The generated mutants, without the written bugs.
[[nodiscard]] std::vector<const MutantRecord*> generated(const Mutants& mutants);
/// The bugs written by hand.
[[nodiscard]] std::vector<const MutantRecord*> written(const Mutants& mutants);

/// Scores by what `name` gives, e.g. folder or operation.
template <class Name>
[[nodiscard]] std::map<std::string, Score> scores_by(const std::vector<const MutantRecord*>& mutants, Name&& name) {
  std::map<std::string, Score> scores;
  for (const MutantRecord* mutant : mutants)
    count(scores[name(*mutant)], *mutant);
  return scores;
}
[[nodiscard]] Score score_of(const std::vector<const MutantRecord*>& mutants);

/// The same without the cases that compare with recorded results: what they alone killed has survived.
[[nodiscard]] Mutants without_recorded(Mutants mutants);

/// Whether a trial would still be red if every bound of its checks were `factor` times as large (or, below 1, as small).
[[nodiscard]] bool kills_at(const Trial& trial, double factor);

/// Share of the mutants that count which would be killed at that factor, by cases of a family (empty: of all).
[[nodiscard]] double share_at(const Mutants& mutants, const std::vector<const MutantRecord*>& of, double factor,
                              const std::string& family);

/// One case of the greedy order and the mutants that it kills beside those before it.
struct Greedy {
  std::string case_id{};
  std::size_t more{};
};
/// Cases by how many mutants each adds, the largest first; of equal ones the faster first. Cases that add none are left
/// out. It needs the whole matrix.
[[nodiscard]] std::vector<Greedy> greedy_order(const Mutants& mutants, const std::vector<const MutantRecord*>& of);

/// Cases that kill a mutant that no other case kills, with the numbers of such mutants. It needs the whole matrix.
[[nodiscard]] std::map<std::string, std::size_t> lone_killers(const std::vector<const MutantRecord*>& of);
/// Cases that killed any.
[[nodiscard]] std::set<std::string> killers(const std::vector<const MutantRecord*>& of);

}  // namespace talus::reports
