#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/run/failure_log.hpp"
#include "solver/run/history.hpp"
#include "solver/run/impact_log.hpp"
#include "solver/run/outcome.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "solver/scenes/scene.hpp"

namespace talus {

/// Position and velocity of a body.
struct BodyState {
  std::string name;
  Vec2 p;          ///< centre of mass, world [L]
  double angle{};  ///< [rad]
  Vec2 v;          ///< [L/T]
  double spin{};   ///< [rad/T]
};

/// State of a cable or a hanger at the end of a run.
struct PartState {
  std::string name;
  std::string_view mode;  ///< of its law: "slack", "taut", "broken", ...; of a hanger "holds" or "broken"
  double stretch{};       ///< plastic stretch [L]; 0 if there is none
};

/// Extremes of one quantity over all steps of a run.
struct ExtremeRecord {
  Column column;
  talus::Extreme extreme;
};

/// An impact with the names of its contact and bodies.
struct ImpactRecord {
  std::string contact;
  std::string body_a;
  std::string body_b;
  int multiplicity{};  ///< number of identical contacts that this one represents
  RecordedImpact impact;
};

/// Quality of the results of a run.
struct RunQuality {
  std::string flaw;     ///< why the results are unusable; empty: they are usable
  bool enforced{true};  ///< unusable results are an error of the run: MonitorRules::quality
  /// Largest error of the energy balance, relative to the largest energy; empty if no balance was computed.
  std::optional<double> balance;
  double balance_time{};                ///< [T]
  std::string step;                     ///< text: the step relative to its limit, or the method that chooses it
  std::optional<double> contact_steps;  ///< steps in the shortest contact; empty for methods that locate events

  /// The last contact of the run.
  struct LastContact {
    std::string name;
    double time{};  ///< of the first step after it ended; of the last step if it still acts [T]
    bool touching{};
  };
  std::optional<LastContact> last_contact;  ///< empty if nothing touched
  /// Names of the bodies that overlapped without a contact between them. The results may be usable: it can be intended.
  std::vector<std::pair<std::string, std::string>> undeclared_overlaps;

  /// A repeated run of the same fence with changed velocities of the rocks.
  struct Repeat {
    double change{};  ///< relative, of the velocities at the start
    scenes::Verdict verdict{};
    double cable_change{};  ///< relative, of the largest tension
    std::string failure;    ///< why it did not finish; empty if it did
  };
  std::optional<Repeat> repeat;

  /// A run of the same scene with located events, after a run whose results are unusable.
  struct Repair {
    std::string option;  ///< of `talus run`
    std::string flaw;    ///< why its results are unusable, too; empty: they are usable
    std::optional<double> balance;
    scenes::Verdict verdict{};
  };
  std::optional<Repair> repair;
};

/// The results of a run that the summary, the files and the plots report.
struct RunRecord {
  std::string title;
  UnitSystem units{si};
  std::string integrator;
  std::string integrator_reason;  ///< reason, if it was chosen automatically
  RunPlan plan;
  Outcome outcome;
  long steps{};                ///< steps done
  long evaluations{};          ///< force evaluations done
  std::optional<long> events;  ///< number of located events; empty for an integrator that locates none
  std::size_t coordinates{};
  std::size_t laws{};  ///< law instances: point contacts and cables
  std::size_t contacts{};
  std::size_t cables{};
  std::vector<BodyState> bodies;        ///< at the last step with a finite state
  Energies start_energies;              ///< of the first state
  std::vector<PartState> cables_left;   ///< at that step
  std::vector<PartState> hangers_left;  ///< at that step
  Accounts accounts;                    ///< at that step
  double largest_energy_balance_error{};
  double energy_scale{};
  std::vector<ExtremeRecord> extremes;
  std::vector<Failure> failures;  ///< yielding of cables, breaking of cables and hangers, in order of time
  History history;                ///< rows before the first with a number that is not finite
  std::size_t rows_cut{};         ///< rows omitted from that one on
  std::optional<std::vector<ImpactRecord>> impacts;  ///< in the order in which they began; empty unless requested
  RunQuality quality;
  std::optional<scenes::FenceSummary> fence;  ///< only of a fence
  std::vector<std::string> watched;           ///< findings of the run monitor, as text
  std::vector<std::string> warnings;          ///< all warnings of the run
  std::vector<std::string> notes;             ///< requested output that the files do not contain, as text
};

/// The final positions and velocities of a scene's bodies.
[[nodiscard]] std::vector<BodyState> body_states(const Model& model, const State& state);

/// The final state of a scene's cables, and of its hangers.
[[nodiscard]] std::vector<PartState> cable_states(const Dynamics& dynamics, const State& state);
[[nodiscard]] std::vector<PartState> hanger_states(const Dynamics& dynamics, const State& state);

/// Indices of the `count` impacts with the largest peak forces, the largest first; equal ones in the order of the list.
[[nodiscard]] std::vector<std::size_t> largest_impacts(const std::vector<ImpactRecord>& impacts, std::size_t count);
/// Number of impacts in the summary of a run.
inline constexpr std::size_t impacts_of_summary = 5;

/// Fills history, rows_cut, extremes and accounts of the record from `recorder`, the accounts as far as it computed
/// them.
void record_history(RunRecord& record, const Recorder& recorder);

}  // namespace talus
