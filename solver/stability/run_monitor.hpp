#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solver/run/energy_ledger.hpp"
#include "solver/scenes/scene.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus {

/// What is watched along a run.
enum class Watched : std::size_t {
  frequency,  ///< h omega of the mode of the acting springs that is nearest to the method's linear limit, over it
  passing,    ///< step over the longest in which no body can pass another unseen
  overlap,    ///< largest overlap over half the least width of the smaller body
  unseen,     ///< the same of outlines in contact by nodes, none of which is in the other; only where beyond its limit
  contact,    ///< time of the shortest contact that was touched, in steps
};
inline constexpr std::size_t watched_count = 5;

/// Largest error of the energy balance over the largest energy that a run is not warned of.
inline constexpr double largest_balance_error = 0.01;

/// Watches over a run: how near each number came to its limit, and when. Nothing that it does changes the run.
/// - frequency is looked at where contacts or cables begin or end to act, at most 512 times a run, and 64 times in any
///   case, of scenes of up to 150 coordinates and methods whose limit is known (linear_limit());
/// - passing and overlap after every step in which something touches, else after every eighth (of methods that locate
///   events passing is their own affair); unseen after every eighth;
/// - contact where one is touched, for methods of fixed step and scenes of as many coordinates;
/// - the energy balance after every step where it is given, else 64 times, with the ledger on. Where it is to warn, the
///   whole run is judged at its end: early errors are small beside the energies to come.
class RunMonitor {
 public:
  /// The extreme of one number so far.
  struct Extreme {
    double value{};
    double time{};        ///< [T]
    ContactId contact{};  ///< where it belongs to one
    bool seen{};          ///< there was something to look at
  };

  /// Scene and Dynamics must outlive it. `start`: the first state of the run.
  RunMonitor(const Scene& scene, const Dynamics& dynamics, const State& start);

  /// The energy balance of a run so far, as its ledger has it.
  struct Balance {
    double error{};  ///< of the present state [F L]
    double scale{};  ///< largest energy so far [F L]
  };
  /// Looks at the state after a step (0: before the first). Without a balance the watch draws its own, 64 times a run.
  void check(const Snapshot& seen, long step, const std::optional<Balance>& balance = {});

  /// Largest error of the energy balance over the largest energy, and when it was.
  double drift() const { return balance_.scale > 0.0 ? balance_.error / balance_.scale : 0.0; }
  double drift_time() const { return drift_time_; }

  /// The contact that ended last, and when; while `touching`, one that acts in the state seen last.
  struct LastContact {
    ContactId contact{};
    double time{};  ///< of the first step after it, or of the last step [T]
    bool touching{};
  };
  /// Empty where nothing has touched.
  std::optional<LastContact> last_contact() const;

  /// The step against the method's linear limit with all contacts closed and all cables taut; empty where no limit is
  /// known.
  const std::string& step_ratio() const { return step_ratio_; }
  bool step_is_beyond() const { return step_is_beyond_; }

  /// Why the run must end; empty while it may go on.
  const std::string& violation() const { return breach_; }
  /// What was found and does not end the run, once for each number.
  std::vector<std::string> warnings() const;
  const Extreme& extreme(Watched which) const { return extremes_[static_cast<std::size_t>(which)]; }

  /// Names what it carries from one step to the next.
  void serialize(Archive& archive);

 private:
  bool touches(const State& seen) const;
  void follow_contacts(const State& seen);
  void check_frequency(const Snapshot& snapshot);
  void look_at_pairs(const Snapshot& snapshot);
  void look_at_unseen(const Snapshot& snapshot);
  /// Takes an overlap as a share of the size, with both its limits.
  template <class Words>
  void take_overlap(Watched which, double share, const State& seen, ContactId contact, const Words& words);
  void look_at_contacts(const State& seen);
  void look_at_drift(const Snapshot& snapshot, const std::optional<Balance>& balance);
  std::string drift_words() const;
  /// Takes a number into its extreme; a limit that it is beyond for the first time is a breach, with the words. A
  /// number may have two, the larger of which is the graver.
  template <class Words>
  void take(Watched which, double value, double limit, CheckAction violation, const State& seen, ContactId contact,
            const Words& words);

  const Scene* scene_;
  const Dynamics* dynamics_;
  EnergyLedger ledger_;
  bool fixed_step_{};
  long every_{};                       ///< steps between two looks at all
  long apart_{};                       ///< least number of steps between two looks at the frequency
  std::vector<ContactId> by_nodes_;    ///< contacts whose outlines no force looks at
  std::vector<double> contact_times_;  ///< of each contact instance [T]
  std::vector<Mode> modes_;            ///< at the last look
  long looked_{};                      ///< step of the last look at the frequency
  std::array<Extreme, watched_count> extremes_{};
  std::array<double, watched_count> reported_{};  ///< the limits beyond which each was said to be; 0: none yet
  Balance balance_;                               ///< the largest error so far, and the scale
  double drift_time_{};
  LastContact last_;
  bool touched_{};  ///< something has touched
  std::string step_ratio_;
  bool step_is_beyond_{};
  std::string breach_;
  std::vector<std::string> warnings_;
};

/// The watch's numbers in words, a line each.
[[nodiscard]] std::vector<std::string> watch_lines(const RunMonitor& watch, const Scene& scene);

}  // namespace talus
