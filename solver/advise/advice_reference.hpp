#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/advise/method_ladder.hpp"

namespace talus {

/// Rules for the choice of a method.
struct AdviceRules {
  double accuracy{1e-3};             ///< required relative error, in [1e-10, 0.5]
  long evaluations{2'000'000};       ///< maximum number of force evaluations of the whole search
  std::vector<std::string> among{};  ///< integrators to choose from; empty: all
  double kept{0.5};                  ///< errors of pilot runs must be below this fraction of the accuracy
  int in_a_row{9};                   ///< consecutive rungs (six per octave or decade) that must satisfy this bound
  int beside{8};                     ///< runs next to the coarsest of these rungs that must satisfy it, too
  bool follows_differences{true};    ///< whether the growth of small initial differences is measured
  bool allows_warnings{false};       ///< whether runs with warnings of RunMonitor are accepted
  bool judges_as_printed{true};      ///< whether errors are those of the value that `talus run` prints
  std::function<void(long evaluations)> progress{};  ///< called after each pilot run with the evaluations so far
};

/// Reason why no method is advised.
struct Refusal {
  enum class Kind {
    chaotic,    ///< small initial differences grow to more than the accuracy
    unsettled,  ///< no two methods converge to the same value
    stiff,      ///< resolving the fastest spring takes more steps than allowed
    vanishing,  ///< the quantity is zero, so a relative accuracy is undefined
    unreached,  ///< the value is known, but none of the available methods reaches the accuracy
  };
  Kind kind{};
  std::string message;
};

/// A value on which two methods of different orders agree.
struct Reference {
  double value{};
  double size{};               ///< largest magnitude of its column in the run
  double spread{};             ///< largest deviation of the other method's last values from `value`, relative
  RunMethod method;            ///< method that gave the value
  std::string other;           ///< integrator of the method that agreed
  std::vector<double> values;  ///< of the column at each step of `method`
};

/// Growth of small initial differences until the end of the run.
struct Growth {
  double fraction{};  ///< initial velocity differences, relative to the largest speed
  double result{};    ///< resulting relative difference of the quantity
};

/// Search for the reference value of a quantity.
class ReferenceSearch {
 public:
  /// `runs` and `rules` must outlive this object.
  ReferenceSearch(PilotRuns& runs, const AdviceRules& rules, long resolving);

  /// Refines the methods, the cheapest next run first, until two methods of different orders agree: the last three
  /// values of one lie within 0.1 times the accuracy, and those of the other within 0.25 times the accuracy of the same
  /// value. Also measures the growth of small initial differences.
  [[nodiscard]] std::optional<Refusal> find();
  const Reference& reference() const { return reference_; }
  /// The largest growth measured; zero if none was measured.
  const Growth& growth() const { return growth_; }

 private:
  struct Climb {
    MethodLadder ladder;
    int rungs{};
    int failures{};
    long next_cost{};
    std::vector<double> values{};  ///< of the rungs since the last failure that resolve the scene
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
