#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/run/failure_log.hpp"
#include "solver/run/history.hpp"
#include "solver/run/outcome.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "solver/scenes/scene.hpp"

namespace talus {

/// Where a body is and how it moves.
struct BodyState {
  std::string name;
  Vec2 p;          ///< centre of mass, world [L]
  double angle{};  ///< [rad]
  Vec2 v;          ///< [L/T]
  double spin{};   ///< [rad/T]
};

/// How a cable or a hanger is left.
struct PartState {
  std::string name;
  std::string_view mode;  ///< of its law: "slack", "taut", "broken", ...; of a hanger "holds" or "broken"
  double stretch{};       ///< plastic stretch [L]; 0 where there is none
};

/// Smallest and largest value of one quantity over all steps of a run.
struct ExtremeRecord {
  Column column;
  talus::Extreme extreme;
};

/// How far the results of a run can be trusted.
struct RunQuality {
  std::string flaw;  ///< why the results are unusable; empty: they are usable
  /// Largest error of the energy balance over the largest energy; empty where no balance was kept.
  std::optional<double> balance;
  double balance_time{};                ///< [T]
  std::string step;                     ///< the step against its limit, or what chooses it
  std::optional<double> contact_steps;  ///< steps in the shortest contact; empty for methods that locate events

  /// A contact of the run.
  struct LastContact {
    std::string name;
    double time{};  ///< of the first step after it; of the last step if it still acts [T]
    bool touching{};
  };
  std::optional<LastContact> last_contact;  ///< empty where nothing touched

  /// A run of the same fence with the rocks' velocities changed.
  struct Repeat {
    double change{};  ///< relative, of the velocities at the start
    scenes::Verdict verdict{};
    double cable_change{};  ///< relative, of the largest tension
    std::string failure;    ///< why it did not finish; empty if it did
  };
  std::optional<Repeat> repeat;

  /// A run of the same scene by located events, after a run whose results are unusable.
  struct Repair {
    std::string option;  ///< of `talus run`
    std::string flaw;    ///< why its results are unusable, too; empty: it repairs the run
    std::optional<double> balance;
    scenes::Verdict verdict{};
  };
  std::optional<Repair> repair;
};

/// A run as it is reported: everything that the summary, the files and the plots say.
struct RunRecord {
  std::string title;
  UnitSystem units{si};
  std::string integrator;
  std::string integrator_why;  ///< where it was chosen automatically
  RunPlan plan;
  Outcome outcome;
  long steps{};                ///< steps done
  long evaluations{};          ///< force evaluations done
  std::optional<long> events;  ///< located, by an integrator that does
  std::size_t coordinates{};
  std::size_t laws{};  ///< law instances: point contacts and cables
  std::size_t contacts{};
  std::size_t cables{};
  std::vector<BodyState> bodies;        ///< at the last step that was finite
  Energies start_energies;              ///< of the first state
  std::vector<PartState> cables_left;   ///< at that step
  std::vector<PartState> hangers_left;  ///< at that step
  Accounts accounts;                    ///< at that step
  double largest_energy_closure{};
  double energy_scale{};
  std::vector<ExtremeRecord> extremes;
  std::vector<Failure> failures;  ///< in the order in which cables yielded, and cables and hangers broke
  History history;                ///< rows up to the first that holds a number that is not finite
  std::size_t rows_cut{};         ///< rows left out after that
  RunQuality quality;
  std::optional<scenes::FenceSummary> fence;  ///< of a fence
  std::vector<std::string> watched;           ///< what the watch over the run saw, in words
  std::vector<std::string> warnings;          ///< and what it warns of
  std::vector<std::string> notes;             ///< what was asked for and is not in the files, in words
};

/// The final positions and velocities of a scene's bodies.
[[nodiscard]] std::vector<BodyState> body_states(const Model& model, const State& state);

/// The final state of a scene's cables, and of its hangers.
[[nodiscard]] std::vector<PartState> cable_states(const Dynamics& dynamics, const State& state);
[[nodiscard]] std::vector<PartState> hanger_states(const Dynamics& dynamics, const State& state);

/// What `recorder` kept: fills history, rows_cut, extremes and accounts of the record, the latter as far as it kept
/// any.
void record_history(RunRecord& record, const Recorder& recorder);

}  // namespace talus
