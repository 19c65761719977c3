/// Statistics of mutants and of the cases that detected them.
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

/// Wilson interval of 95 % for a sample fraction (Wilson 1927): the expected score of all candidates.
struct Interval {
  double low{};
  double high{};
};
[[nodiscard]] Interval wilson(std::size_t successes, std::size_t all);

/// The generated mutants, without the manually written bugs.
[[nodiscard]] std::vector<const MutantRecord*> generated(const Mutants& mutants);
/// The manually written bugs.
[[nodiscard]] std::vector<const MutantRecord*> written(const Mutants& mutants);

/// Scores grouped by the result of `name`, e.g. folder or operation.
template <class Name>
[[nodiscard]] std::map<std::string, Score> scores_by(const std::vector<const MutantRecord*>& mutants, Name&& name) {
  std::map<std::string, Score> scores;
  for (const MutantRecord* mutant : mutants)
    count(scores[name(*mutant)], *mutant);
  return scores;
}
[[nodiscard]] Score score_of(const std::vector<const MutantRecord*>& mutants);

/// The mutants without the cases that compare with recorded results: mutants killed only by these have survived.
[[nodiscard]] Mutants without_recorded(Mutants mutants);

/// The mutants with the cases of the matrix alone: those killed only by longer cases have survived.
[[nodiscard]] Mutants of_matrix(Mutants mutants);

/// True if a trial would still be red if every bound of its checks were multiplied by `factor`.
[[nodiscard]] bool kills_at(const Trial& trial, double factor);

/// Fraction of the counted mutants that would be killed at that factor, by cases of a family (empty: of all).
[[nodiscard]] double fraction_at(const Mutants& mutants, const std::vector<const MutantRecord*>& of, double factor,
                                 const std::string& family);

/// One case of the greedy order, and the number of mutants that it kills in addition to those before it.
struct Greedy {
  std::string case_id{};
  std::size_t more{};
};
/// Cases ordered by the number of mutants each adds, largest first; ties are broken by speed. Cases that add none are
/// omitted. Requires the whole matrix.
[[nodiscard]] std::vector<Greedy> greedy_order(const Mutants& mutants, const std::vector<const MutantRecord*>& of);

/// Cases that kill a mutant that no other case kills, with the number of such mutants. Requires the whole matrix.
[[nodiscard]] std::map<std::string, std::size_t> lone_killers(const std::vector<const MutantRecord*>& of);
/// Cases that killed at least one mutant.
[[nodiscard]] std::set<std::string> killers(const std::vector<const MutantRecord*>& of);

}  // namespace talus::reports
