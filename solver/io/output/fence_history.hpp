#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/io/fence1993/fence_codes.hpp"
#include "solver/run/history.hpp"

namespace talus {

/// The histories that a deck requests: each of its elements with each of its codes, every `history_every` steps from
/// the start and at the last step, each row from a state whose parts are all at the same time. Pairs of element and
/// code that do not fit (the tension at a rock) are skipped, never written as zeros.
class FenceHistory {
 public:
  /// All arguments must outlive it. Errors: InputError naming the codes that have no history, and why.
  FenceHistory(const scenes::Fence& fence, const scenes::FenceScene& made, const Dynamics& dynamics);

  /// Adds a row if one is due and all its numbers are finite. A row added only because the run stops is removed when
  /// the run is resumed.
  void operator()(const Snapshot& snapshot, const StepInfo& info);

  /// Saves or restores the rows; a FenceHistory of the same run continues from them.
  void serialize(Archive& archive) { history_.serialize(archive); }

  /// Columns "time", "element3.top_joint_force", ...
  const History& history() const { return history_; }
  /// Skipped pairs, as text: "element 2: codes 51, 52 skipped: ...".
  const std::vector<std::string>& skipped() const { return skipped_; }

  /// The history as CSV, after lines beginning with # that list the skipped pairs.
  [[nodiscard]] std::string csv_text() const;
  /// The history as JSON: title, unit system, one entry for each column with element, code, the name of 1993, unit and
  /// values, and the skipped pairs.
  [[nodiscard]] std::string json_text() const;

 private:
  struct Series {
    int element{};
    const FenceCode* code{};
  };
  const scenes::FenceElement& element(int number) const;
  std::string_view refusal_reason(int number, const FenceCode& code) const;
  void choose(int number);

  const scenes::Fence* fence_;
  const scenes::FenceScene* made_;
  const Dynamics* dynamics_;
  std::vector<Series> series_;
  std::vector<std::string> skipped_;
  History history_;
};

}  // namespace talus
