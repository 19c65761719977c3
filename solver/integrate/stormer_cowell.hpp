#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/integrate/differences.hpp"
#include "solver/integrate/implicit_step.hpp"
#include "solver/integrate/located_steps.hpp"

namespace talus {

/// Motion by the polynomial through the rates at the latest times, with variable order and step: accelerations are
/// integrated once to velocities and twice to coordinates (Stoermer 1907, Cowell & Crommelin 1910; by differences for
/// steps of any length Krogh 1974, Shampine & Gordon 1975). A step predicts, evaluates once and corrects. Within a step
/// the same polynomial gives the state.
///
/// If stiff springs limit the steps although hardly anything changes (a body that rests, rolls or slides on a contact),
/// the steps are those of ImplicitStep, as long as these save evaluations.
///
/// tolerance: allowed difference between prediction and correction, relative to the largest displacement and speed of
/// the run so far; in a run that starts at rest, relative to the response of its springs to the forces at the start.
class PolynomialMotion {
 public:
  static constexpr std::string_view name = "stormer_cowell";
  static constexpr int order = 12;
  static constexpr StepControl step_control = StepControl::tolerance;

  PolynomialMotion() = default;
  PolynomialMotion(const State& state, double tolerance);

  void begin(HybridSystem& system, const State& start, double interval);
  void shorten_to_probe() { step_ *= 1e-4, probes_ = true; }
  std::string advance(HybridSystem& system, const State& begin, State& end, double longest);
  NearEnd near_end(const State& end) const { return implicit_last_ ? NearEnd{&end, true} : NearEnd{&predicted_, true}; }
  void state_at(const State& begin, const State& end, double t, State& out) const;
  void complete(HybridSystem&, const State&, State&) {}
  bool ends_at_outputs(const HybridSystem&) const { return false; }
  double next_step() const { return step_; }
  double usual_step() const { return usual_; }
  void serialize(Archive& archive, const State& like);

 private:
  using Basis = Differences::Basis;

  void start_scales(HybridSystem& system, const State& start);
  ErrorScales scales() const { return {speed_now_, displacement_now_, tolerance_, lengths_}; }
  bool is_held_by_stiffness(HybridSystem& system, const State& begin);
  bool advance_implicitly(HybridSystem& system, const State& begin, State& end, double longest);
  void leave_implicit(const State& begin);
  void try_step(HybridSystem& system, const State& begin, double h, State& end);
  /// Errors of the last step, and as they would be with one term fewer and with one term more; infinite if there is
  /// none.
  struct Errors {
    double now{};
    double fewer{};
    double more{};
  };
  Errors errors(const State& like) const;
  void shorten(double h, const Errors& errors);
  void choose_next(double h, const Errors& errors);
  void measure(double h, const State& begin, const State& end);
  void move(const State& begin, double t, std::span<const Basis> basis, State& to) const;
  void correct(const Basis& last, const State& from, State& to) const;
  void flatten(const Rates& rates);
  std::size_t width(const State& like) const;

  Differences rates_;  ///< rates up to the beginning of the last step: accelerations, and memory rates, powers and
                       ///< forces from outside if there are any
  std::vector<double> new_;    ///< rates at its end
  std::vector<double> miss_;   ///< difference of these from the prediction
  double last_value_{};        ///< value of the first omitted term at the end of the last step
  std::size_t order_{1};       ///< number of terms that predict the next step
  std::size_t used_{1};        ///< number of terms that predicted the last step
  double step_{};              ///< length of the next step [T]
  double usual_{};             ///< last step that was not cut short by an event [T]
  bool probes_{};              ///< the next step is a probe, too short to build on: after it the segment restarts
  bool moves_memory_{true};    ///< see Hybrid
  bool keeps_accounts_{true};  ///< likewise
  double tolerance_{};
  double displacement_{};        ///< largest displacement of a coordinate so far [L]
  double speed_{};               ///< largest speed so far [L/T]
  std::vector<double> start_;    ///< coordinates at the start of the run
  std::vector<double> lengths_;  ///< of the coordinates, see Hybrid; empty before they are first needed

  ImplicitStep implicit_step_;
  bool implicit_{};                ///< the next step is implicit
  bool implicit_last_{};           ///< the last step was implicit
  Rates implicit_rates_;           ///< at the beginning of the next implicit step
  double explicit_step_{};         ///< explicit step before the implicit ones began [T]
  double implicit_start_{};        ///< time at which they began [T]
  long implicit_count_{};          ///< number of successive implicit steps
  long held_{};                    ///< number of successive low-order steps that did not grow beyond three times ...
  double held_step_{};             ///< ... this step [T]
  long patience_{first_patience};  ///< number of them after which an implicit step is tried
  static constexpr long first_patience = 12;

  // Scratch of a step.
  std::vector<Basis> basis_;
  double displacement_now_{}, speed_now_{};
  State predicted_;
  Rates found_;
};

/// Stoermer-Cowell with located events.
using StormerCowell = LocatedSteps<PolynomialMotion>;

}  // namespace talus
