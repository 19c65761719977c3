#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/check.hpp"
#include "verification/check/convergence.hpp"
#include "verification/check/figure.hpp"
#include "verification/check/table.hpp"

namespace talus::verification {

/// What a case finds: checks, figures, tables and notes, in the order they were made.
///
/// Each `expect...` returns whether the check passed, and never throws because it failed. The programmer's mistakes
/// throw: a name used twice is std::logic_error; missing words or a malformed figure std::invalid_argument.
class Findings {
 public:
  /// Thrown by the check that completes the needed ones: the rest of the run decides nothing.
  struct Decided {};

  Findings() = default;
  /// Only the checks named `needed` matter, at least one: `Decided` is thrown once all of them are made.
  explicit Findings(std::vector<std::string> needed) : needed_{std::move(needed)} {}

  /// A group of checks, in which those made during its life are: see in().
  class Group {
   public:
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;
    ~Group() { findings_->open_groups_.pop_back(); }

    Findings* operator->() const { return findings_; }
    operator Findings&() const { return *findings_; }

   private:
    friend class Findings;
    Group(Findings& findings, std::string id) : findings_{&findings} { findings.open_groups_.push_back(std::move(id)); }
    Findings* findings_;
  };

  /// Puts checks into a group, whose id claims refer to: one check by `findings.in("overlaps")->expect(...)`, or all
  /// that are made while the group that is returned lives. Groups nest; a check is in all that are open. A group with
  /// the id of a requirement of the solver's lists, such as "integrator.rk4", is a claim of it.
  /// Errors: std::invalid_argument if the id is empty.
  [[nodiscard]] Group in(std::string id);

  /// Compares `measured` with `reference` within `tolerance`.
  bool expect(std::string name, double measured, double reference, const Tolerance& tolerance, std::string unit = "1");

  /// Demands `low <= measured <= high`; `why` says where both ends come from.
  bool expect_between(std::string name, double measured, double low, double high, std::string why,
                      std::string unit = "1");

  /// Demands that `holds` is true: for identities that have no size (same bits, a refused scene).
  bool expect_true(std::string name, bool holds, std::string why);

  /// Demands that the order fitted to all points of `convergence` lies in [low, high]: too steep is a failure, too.
  bool expect_order(std::string name, const Convergence& convergence, double low, double high, std::string why);

  /// Adds a figure. A point that is not finite adds a failed check; points not positive on a log axis are left out and
  /// counted in the caption.
  void figure(Figure figure);
  void table(Table table);
  /// Adds a file of data that several figures are drawn from.
  void data(DataFile file);
  /// A paragraph of Markdown for the page, e.g. what does not match and by how much.
  void note(std::string markdown);
  /// Adds to the number of force evaluations (or right-hand sides) that the case has spent.
  void count(std::integral auto evaluations) { evaluations_ += static_cast<std::uint64_t>(evaluations); }

  [[nodiscard]] const std::vector<Check>& checks() const { return checks_; }
  /// Of each check the groups that it is in, outermost first.
  [[nodiscard]] const std::vector<std::vector<std::string>>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<Figure>& figures() const { return figures_; }
  [[nodiscard]] const std::vector<Table>& tables() const { return tables_; }
  [[nodiscard]] const std::vector<DataFile>& data_files() const { return data_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] std::uint64_t evaluations() const { return evaluations_; }

  /// The check called `name`, or nullptr.
  [[nodiscard]] const Check* find(const std::string& name) const;

 private:
  bool add(Check check);

  std::vector<std::string> needed_;  ///< Not made so far.
  std::vector<Check> checks_;
  std::vector<std::vector<std::string>> groups_;  ///< of each check
  std::vector<std::string> open_groups_;
  std::vector<Figure> figures_;
  std::vector<Table> tables_;
  std::vector<DataFile> data_;
  std::vector<std::string> notes_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace talus::verification
