#pragma once

#include <string>
#include <utility>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/dynamics/candidates.hpp"
#include "solver/dynamics/dynamics.hpp"

namespace talus {

/// Two bodies that overlap and have no contact between them.
struct UndeclaredOverlap {
  BodyId a{};
  BodyId b{};
  double ratio{};  ///< overlap of the outlines over half the minimum width of the smaller body
};

/// Pairs of bodies with outlines, at least one of which moves, that have no contact between them: they pass through
/// each other without a force. That is rarely intended, and a run does not show it by any error of its balances.
class MissingContacts {
 public:
  /// Number of pairs beyond which none is checked, because their list would take more memory than the run (20 MB).
  static constexpr std::size_t maximum_pairs = 200'000;

  explicit MissingContacts(const Dynamics& dynamics);

  /// Number of pairs without a contact; `maximum_pairs` + 1 if there are more.
  std::size_t size() const { return size_; }
  /// True if the pairs are checked.
  bool is_checked() const { return size_ > 0 && !is_too_large(); }
  /// True if there are more pairs than are checked.
  bool is_too_large() const { return size_ > maximum_pairs; }
  /// The pairs, in the order of the bodies; empty if they are not checked.
  const std::vector<Candidate>& pairs() const { return search_.pairs(); }

  /// Pairs that overlap by more than plausible_overlap in a state, of which `geometry` has the poses, and that no
  /// earlier call returned. The outlines are compared only if a point of a body has moved by a twentieth of half its
  /// minimum width since the last comparison, so that most calls cost a few operations for each body.
  [[nodiscard]] std::vector<UndeclaredOverlap> new_overlaps(const Workspace& geometry);

  /// All pairs returned so far, in the order of the bodies.
  [[nodiscard]] std::vector<std::pair<BodyId, BodyId>> returned() const;

  /// Serializes what determines the results of later calls.
  void serialize(Archive& archive);

 private:
  const Dynamics* dynamics_;
  std::size_t size_{};
  ContactSearch search_;
  Sweep sweep_;                 ///< its positions are those of the last comparison
  std::vector<char> near_;      ///< for each pair; zero between two calls
  std::vector<char> returned_;  ///< for each pair
};

/// "bodies 'ball' and 'floor' overlap by 12 % of half the width of the smaller one, and no [[contact]] is declared
/// between them: they pass through each other without a force".
[[nodiscard]] std::string overlap_text(const UndeclaredOverlap& overlap, const Model& model);

/// Warning that the overlaps of pairs without a contact are not checked, because there are more than maximum_pairs.
[[nodiscard]] std::string unchecked_pairs_warning();

/// Warning about bodies that overlap in the first state of a scene without a contact between them, with the largest of
/// these overlaps, or that there are too many pairs to check; empty if there are none.
[[nodiscard]] std::string missing_contact_warning(const Dynamics& dynamics, const State& state);

}  // namespace talus
