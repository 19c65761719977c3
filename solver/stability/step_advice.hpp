#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/dynamics/springs.hpp"
#include "solver/scenes/scene.hpp"

namespace talus {

/// One spring of a scene in the terms of step limits.
struct SpringAdvice {
  std::string name;  ///< of the contact (with the instance's number where it has several) or cable
  bool contact{};    ///< contact or cable
  Spring spring;
  double frequency{};      ///< sqrt(k/m_eff) [rad/T]
  double damping_ratio{};  ///< c/(2 sqrt(k m_eff))
  double contact_time{};   ///< of an impact by this spring alone [T]; for a cable, and a contact that is no linear
                           ///< spring and dashpot, half its period
};

/// One natural mode of a scene.
struct NaturalMode {
  double frequency{};      ///< [rad/T]
  double damping_ratio{};  ///< of this mode alone
};

/// Natural modes of these springs that have a frequency > 0, slowest first.
[[nodiscard]] std::vector<NaturalMode> natural_modes(const Dynamics& dynamics, const std::vector<Spring>& springs);

/// What the stiffness of a scene implies for its step in a state, with every contact closed and every cable taut.
struct StepAdvice {
  std::vector<SpringAdvice> springs;
  std::vector<NaturalMode> modes;  ///< those with a frequency > 0, slowest first
  double shortest_contact{};       ///< shortest contact time [T]; infinite without contacts

  double highest_frequency() const { return modes.empty() ? 0.0 : modes.back().frequency; }
};
[[nodiscard]] StepAdvice advise_step(const Dynamics& dynamics, const State& state);

/// The mode whose limit comes first for a method, and the longest stable step [T]: not always the fastest mode, for
/// damping shortens the step too. Empty where the method's limit is not known, or nothing vibrates.
struct StepLimit {
  NaturalMode mode;
  double product{};  ///< h omega of that mode at the limit
  double step{};     ///< [T]
};
[[nodiscard]] std::optional<StepLimit> step_limit(const std::vector<NaturalMode>& modes, std::string_view integrator);

/// The step of a scene against the linear limit of its method.
struct StepVerdict {
  bool is_beyond{};  ///< the step is longer than the limit
  std::string text;  ///< "h omega = 2.1 > 2, the linear limit of velocity_verlet for the mode of ..."
};
/// The verdict on the scene's step by the advice for all its springs; none for methods that choose their steps, whose
/// limit is not known, or where nothing vibrates.
[[nodiscard]] std::optional<StepVerdict> step_verdict(const Scene& scene, const StepAdvice& advice);

/// Coordinates of a scene up to which a run computes its frequencies, at the start and while it is watched: the cost
/// grows with their cube.
inline constexpr std::size_t most_watched_coordinates = 150;

/// The name by which a scene leaves its fixed step to automatic_step().
inline constexpr std::string_view automatic_step_name = "auto";

/// A fixed step of known error for the scene's method [T]: a twentieth of its linear limit, or a 200th of the shortest
/// contact if that is less (a dashpot's impact then errs by at most 0.3 % of its speed).
/// Errors: InputError where neither says anything, and where the method grows at any step.
[[nodiscard]] double automatic_step(const Scene& scene);

/// Time between two outputs of a method that chooses its own steps [T], where the scene gives none: the run's end over
/// a multiple of 1000. A 20th of the shortest contact time and of the shortest half period of a cable, so that the
/// largest forces are seen to 0.3 %; but at least end/1e6, and end/1000 for scenes of more than 150 coordinates.
[[nodiscard]] double output_step(const Scene& scene);

}  // namespace talus
