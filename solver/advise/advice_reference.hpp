#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/advise/method_ladder.hpp"

namespace talus {

/// By what rules a method is advised.
struct AdviceRules {
  double accuracy{1e-3};             ///< relative error that is asked for, in [1e-10, .5]
  long evaluations{2'000'000};       ///< force evaluations that the search may take in all
  std::vector<std::string> among{};  ///< integrators to choose from; empty: all
  double kept{0.5};                  ///< share of the accuracy that the errors of pilots may take
  int in_a_row{9};                   ///< rungs of a ladder, six to an octave or decade, that must all be as good
  int beside{8};                     ///< runs beside the coarsest of them that must be as good, too
  bool follows_differences{true};    ///< whether small differences of the start are followed
  bool allows_warnings{false};       ///< whether runs that the watch warns of are good enough
  bool judges_as_printed{true};      ///< whether errors are those of what `talus run` prints
  std::function<void(long evaluations)> progress{};  ///< told after each pilot what all have taken
};

/// Why no method is advised.
struct Refusal {
  enum class Kind {
    chaotic,    ///< small differences of the start grow to more than the accuracy
    unsettled,  ///< no two methods come to the same value
    stiff,      ///< the fastest spring takes more steps than may be spent
    vanishing,  ///< the quantity is zero: there is no relative accuracy of it
    unreached,  ///< the value is known, but none of the methods to choose from comes as near
  };
  Kind kind{};
  std::string words;
};

/// A value that two methods of different orders agree upon.
struct Reference {
  double value{};
  double size{};               ///< largest magnitude of its column in the run
  double spread{};             ///< largest difference of the other method's last values, as a share of the value
  RunMethod method;            ///< that gave it
  std::string other;           ///< the integrator that agreed
  std::vector<double> values;  ///< of the column at each step of the method
};

/// What differences of the start grow to by the end.
struct Growth {
  double share{};   ///< of the largest speed, that velocities at the start differ by
  double result{};  ///< share of the quantity that they make in the end
};

/// Looks for the value of a quantity.
class ReferenceSearch {
 public:
  /// All must outlive it.
  ReferenceSearch(PilotRuns& runs, const AdviceRules& rules, long resolving);

  /// Climbs the ladders, the cheapest next rung first, until of two methods of different orders the last three values
  /// each, and the last of both, lie within a tenth of the accuracy; and follows small differences of the start.
  [[nodiscard]] std::optional<Refusal> find();
  const Reference& reference() const { return reference_; }
  /// The largest growth measured; zero where none was followed.
  const Growth& growth() const { return growth_; }

 private:
  struct Climb {
    MethodLadder ladder;
    int rungs{};
    int failures{};
    long next_cost{};
    std::vector<double> values{};  ///< one for each rung since the last failure that resolves the scene
    RunMethod method{};            ///< of the last rung
    Pilot last{};
  };

  void climb(Climb& climb);
  std::optional<double> distance(const Climb& climb, double value) const;
  double hoped_cost(const Climb& climb) const;
  bool agreed();
  std::optional<Refusal> follow_differences(const Climb& climb);
  std::optional<Refusal> vanishing(double value, double size) const;
  Refusal too_dear() const;
  Refusal unsettled() const;
  Climb* cheapest();
  const Climb* finest() const;

  PilotRuns* runs_;
  const AdviceRules* rules_;
  long resolving_;
  std::vector<Climb> climbs_;
  Reference reference_;
  Growth growth_;
  bool followed_{};
};

template <>
struct Names<Refusal::Kind> {
  static constexpr std::array<std::string_view, 5> list{"chaotic", "unsettled", "stiff", "vanishing", "unreached"};
};

}  // namespace talus
