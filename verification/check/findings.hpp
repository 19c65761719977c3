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

/// Name of a check, and optionally its id: {"overlaps", "overlaps of ten contacts, largest error"}. The definition of a
/// case refers to a check by name or id, and to several checks by an id that they share: checks {"overlaps/apart", ...}
/// and {"overlaps/pressed", ...} are both "overlaps".
struct CheckName {
  CheckName(std::string text) : name{std::move(text)} {}
  CheckName(const char* text) : name{text} {}
  CheckName(std::string id_of_check, std::string text) : id{std::move(id_of_check)}, name{std::move(text)} {}

  std::string id{};  ///< Empty: none.
  std::string name;
};

/// Results of a case: checks, figures, tables and notes, in order of creation.
///
/// Each `expect...` returns whether the check passed, and never throws because it failed. Programming errors throw:
/// std::logic_error for a name used twice, std::invalid_argument for missing text or a malformed figure.
class Findings {
 public:
  /// Thrown by the check that decides the result: the rest of the run adds nothing to it.
  struct Decided {};

  Findings() = default;
  /// Only the checks named `needed` are required, at least one: `Decided` is thrown once all of them are made.
  explicit Findings(std::vector<std::string> needed) : needed_{std::move(needed)} {}
  /// Only whether all checks pass is required: the first that does not throws `Decided`.
  static Findings until_one_fails() {
    Findings findings;
    findings.until_one_fails_ = true;
    return findings;
  }

  /// A scope whose checks belong to a group: see in().
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

  /// Adds all checks made during the lifetime of the returned group to it; the definition of the case refers to them by
  /// its id. Groups nest; a check belongs to all open groups, and to that of its CheckName. A group whose id is a
  /// requirement of the solver's lists, such as "integrator.rk4", claims it. Errors: std::invalid_argument if the id is
  /// empty.
  [[nodiscard]] Group in(std::string id);

  /// Checks `measured` against `reference` within `tolerance`.
  bool expect(CheckName name, double measured, double reference, const Tolerance& tolerance, std::string unit = "1");

  /// The same with a tolerance of one kind, whose bound and justification follow the reference: see Tolerance.
  bool expect_exact(CheckName name, double measured, double reference, std::string why, std::string unit = "1");
  bool expect_round_off(CheckName name, double measured, double reference, double bound, std::string why,
                        std::string unit = "1");
  bool expect_truncation(CheckName name, double measured, double reference, double predicted_error, double factor,
                         std::string why, std::string unit = "1");
  bool expect_model(CheckName name, double measured, double reference, double bound, std::string why,
                    std::string unit = "1");

  /// Checks `low <= measured <= high`; `why` explains both ends.
  bool expect_between(CheckName name, double measured, double low, double high, std::string why,
                      std::string unit = "1");

  /// Checks that `holds` is true: for identities without a size (bit-identical results, a rejected scene).
  bool expect_true(CheckName name, bool holds, std::string why);

  /// Checks that the order fitted to all points of `convergence` lies in [low, high]; too high an order fails, too.
  bool expect_order(CheckName name, const Convergence& convergence, double low, double high, std::string why);

  /// Adds a figure. A point that is not finite adds a failed check; points that are not positive on a log axis are
  /// omitted and counted in the caption.
  void figure(Figure figure);
  void table(Table table);
  /// Adds a data file from which several figures are drawn.
  void data(DataFile file);
  /// Adds a paragraph of Markdown to the page, for example what does not match and by how much.
  void note(std::string markdown);
  /// Adds to the number of force evaluations (or right-hand sides) of the case.
  void count(std::integral auto evaluations) { evaluations_ += static_cast<std::uint64_t>(evaluations); }

  [[nodiscard]] const std::vector<Check>& checks() const { return checks_; }
  /// For each check, the groups that it belongs to, outermost first.
  [[nodiscard]] const std::vector<std::vector<std::string>>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<Figure>& figures() const { return figures_; }
  [[nodiscard]] const std::vector<Table>& tables() const { return tables_; }
  [[nodiscard]] const std::vector<DataFile>& data_files() const { return data_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] std::uint64_t evaluations() const { return evaluations_; }

  /// The check called `name`, or nullptr.
  [[nodiscard]] const Check* find(const std::string& name) const;

 private:
  bool add(Check check, std::string id);

  std::vector<std::string> needed_;  ///< Not yet made.
  bool until_one_fails_ = false;
  std::vector<Check> checks_;
  std::vector<std::vector<std::string>> groups_;  ///< for each check
  std::vector<std::string> open_groups_;
  std::vector<Figure> figures_;
  std::vector<Table> tables_;
  std::vector<DataFile> data_;
  std::vector<std::string> notes_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace talus::verification
