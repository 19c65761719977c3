#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/run/energy_ledger.hpp"
#include "solver/scenes/scene.hpp"
#include "solver/stability/missing_contacts.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus {

/// Quantities that are monitored during a run.
enum class Watched : std::size_t {
  frequency,  ///< omega h over the method's linear limit, for the mode of the acting springs that is nearest to it
  passing,    ///< step over the longest step in which no body can pass through another unnoticed
  overlap,    ///< largest overlap over half the minimum width of the smaller body
  unseen,     ///< the same for contacts by nodes that overlap with no node inside the other body; only beyond its limit
  contact,    ///< duration of the shortest contact that was closed, in steps
};
inline constexpr std::size_t watched_count = 5;

/// Largest balance error, relative to the largest energy, for which a run gives no warning.
inline constexpr double largest_balance_error = 0.01;

/// Monitors a run: records how near each quantity came to its limit, and when. It never changes the run.
/// - frequency is checked when contacts or cables begin or end to act, at most 512 times a run, and 64 times in any
///   case, for scenes of up to 150 coordinates and methods whose limit is known (linear_limit());
/// - passing and overlap are checked after every step in which something touches, else after every eighth (passing only
///   for fixed steps: methods that locate events limit their steps themselves); unseen after every eighth;
/// - contact is checked when one closes, for methods of fixed step and scenes of up to as many coordinates;
/// - bodies without a contact between them are checked for overlaps at the start, by the constructor, and after every
///   step; each of the first five pairs is reported once; more pairs than MissingContacts::maximum_pairs are not
///   checked, which is a warning;
/// - the energy balance is checked after every step for which it is given, else 64 times, with the ledger on. If it is
///   to warn, the whole run is judged at its end: early errors are small relative to later energies.
class RunMonitor {
 public:
  /// Extreme of one quantity so far.
  struct Extreme {
    double value{};
    double time{};        ///< [T]
    ContactId contact{};  ///< if the quantity belongs to one
    bool seen{};          ///< the quantity was evaluated at least once
  };

  /// Scene and Dynamics must outlive it. `start`: the first state of the run.
  RunMonitor(const Scene& scene, const Dynamics& dynamics, const State& start);

  /// Energy balance of a run so far, from its ledger.
  struct Balance {
    double error{};  ///< of the present state [F L]
    double scale{};  ///< largest energy so far [F L]
  };
  /// Checks the state after a step (0: before the first). Without a balance the monitor computes one, 64 times a run.
  void check(const Snapshot& seen, long step, const std::optional<Balance>& balance = {});

  /// Largest balance error relative to the largest energy, and its time.
  double drift() const { return balance_.scale > 0.0 ? balance_.error / balance_.scale : 0.0; }
  double drift_time() const { return drift_time_; }

  /// The contact that ended last, and when; if `touching`, a contact that acts in the last state checked.
  struct LastContact {
    ContactId contact{};
    double time{};  ///< of the first step after it, or of the last step [T]
    bool touching{};
  };
  /// Empty if no contact has acted.
  std::optional<LastContact> last_contact() const;

  /// Text that compares the step with the method's linear limit, with all contacts closed and all cables taut; empty if
  /// no limit is known.
  const std::string& step_ratio() const { return step_ratio_; }
  bool step_is_beyond() const { return step_is_beyond_; }

  /// Pairs of bodies without a contact that have overlapped, see MissingContacts. At most
  /// maximum_reported_pairs and those of the same step.
  std::vector<std::pair<BodyId, BodyId>> undeclared_overlaps() const;

  /// Why the run must end; empty while it may continue.
  const std::string& violation() const { return violation_; }
  /// Findings that do not end the run, once for each quantity and limit; those of the start come first.
  std::vector<std::string> warnings() const;
  /// Those that were known before the first step.
  const std::vector<std::string>& start_warnings() const { return start_warnings_; }
  const Extreme& extreme(Watched which) const { return extremes_[static_cast<std::size_t>(which)]; }

  /// Serializes what is carried from one step to the next.
  void serialize(Archive& archive);

 private:
  bool touches(const State& seen) const;
  void follow_contacts(const State& seen);
  void check_frequency(const Snapshot& snapshot);
  void check_pairs(const Snapshot& snapshot);
  void check_unseen_overlaps(const Snapshot& snapshot);
  /// Records an overlap as a fraction of the size, and checks both its limits.
  template <class Message>
  void take_overlap(Watched which, double ratio, const State& seen, ContactId contact, const Message& message);
  void check_contact_steps(const State& seen);
  /// `geometry` has the poses of a state at `time`.
  void check_missing_contacts(double time, const Workspace& geometry);
  void check_balance(const Snapshot& snapshot, const std::optional<Balance>& balance);
  std::string drift_text() const;
  /// Updates the extreme of a quantity; if a limit is exceeded for the first time, reports a violation with the text of
  /// `message`. A quantity may have two limits, of which the larger is the more severe.
  template <class Message>
  void take(Watched which, double value, double limit, CheckAction violation, const State& seen, ContactId contact,
            const Message& message);

  const Scene* scene_;
  const Dynamics* dynamics_;
  EnergyLedger ledger_;
  bool fixed_step_{};
  long every_{};                       ///< steps between two regular checks
  long apart_{};                       ///< minimum number of steps between two checks of the frequency
  std::vector<ContactId> by_nodes_;    ///< contacts by nodes, whose forces miss overlaps without a node inside
  std::vector<double> contact_times_;  ///< per contact instance [T]
  std::optional<MissingContacts> missing_contacts_;  ///< unless the scene switches their check off
  long reported_pairs_{};                            ///< pairs without a contact that overlapped so far
  std::vector<Mode> modes_;                          ///< at the last check
  long checked_step_{};                              ///< step of the last check of the frequency
  std::array<Extreme, watched_count> extremes_{};
  std::array<double, watched_count> reported_{};  ///< largest limit that each was reported to exceed; 0: none yet
  Balance balance_;                               ///< the largest error so far, and the scale
  double drift_time_{};
  LastContact last_;
  bool touched_{};  ///< some contact has acted
  std::string step_ratio_;
  bool step_is_beyond_{};
  std::string violation_;
  std::vector<std::string> warnings_, start_warnings_;
};

/// Summary of the monitored quantities, one line each.
[[nodiscard]] std::vector<std::string> watch_lines(const RunMonitor& watch, const Scene& scene);

}  // namespace talus
