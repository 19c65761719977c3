#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/dynamics/springs.hpp"
#include "solver/scenes/scene.hpp"

namespace talus {

/// Properties of one spring that determine step limits.
struct SpringAdvice {
  std::string name;  ///< of the contact (with the number of the instance if it has several) or cable
  bool contact{};    ///< true for a contact, false for a cable or friction
  Spring spring;
  double frequency{};      ///< sqrt(k/m_eff) [rad/T]
  double damping_ratio{};  ///< c/(2 sqrt(k m_eff))
  double contact_time{};   ///< of an impact on this spring alone [T]; for a cable, and for a contact that is not a
                           ///< linear spring and dashpot, half its period
};

/// One natural mode of a scene.
struct NaturalMode {
  double frequency{};      ///< [rad/T]
  double damping_ratio{};  ///< of this mode alone
};

/// Natural modes of these springs that have a frequency > 0, slowest first.
[[nodiscard]] std::vector<NaturalMode> natural_modes(const Dynamics& dynamics, const std::vector<Spring>& springs);

/// Step limits from the stiffness of a scene in a state, with every contact closed and every cable taut.
struct StepAdvice {
  std::vector<SpringAdvice> springs;
  std::vector<NaturalMode> modes;  ///< with frequency > 0, slowest first
  double shortest_contact{};       ///< shortest contact time [T]; infinite without contacts

  double highest_frequency() const { return modes.empty() ? 0.0 : modes.back().frequency; }
};
[[nodiscard]] StepAdvice advise_step(const Dynamics& dynamics, const State& state);

/// Mode that limits the step of a method, and the longest stable step [T]. It is not always the fastest mode, because
/// damping shortens the step too. Empty if the method's limit is not known, or nothing vibrates.
struct StepLimit {
  NaturalMode mode;
  double product{};  ///< h omega of that mode at the limit
  double step{};     ///< [T]
};
[[nodiscard]] std::optional<StepLimit> step_limit(const std::vector<NaturalMode>& modes, std::string_view integrator);

/// Comparison of a scene's step with the linear limit of its method.
struct StepVerdict {
  bool is_beyond{};  ///< the step is longer than the limit
  std::string text;  ///< "h omega = 2.1 > 2, the linear limit of velocity_verlet for the mode of ..."
};
/// Compares the scene's step with its limit, from the advice on all its springs; empty for methods that choose their
/// steps or whose limit is not known, and if nothing vibrates.
[[nodiscard]] std::optional<StepVerdict> step_verdict(const Scene& scene, const StepAdvice& advice);

/// Warning of a scene whose method chooses its steps, and whose outputs may miss the largest forces of a contact by
/// more than 29 %: fewer than two of them fall into the shortest contact. Empty otherwise: contacts that stay closed
/// have no such peaks, and it is not known at the start which ones will; and for scenes of more than
/// maximum_watched_coordinates.
[[nodiscard]] std::string output_warning(const Scene& scene, const Dynamics& dynamics);

/// Largest number of coordinates for which a run computes natural frequencies, at the start and in its monitor: the
/// cost grows with the cube of that number.
inline constexpr std::size_t maximum_watched_coordinates = 150;

/// Name by which a scene selects automatic_step() for its fixed step.
inline constexpr std::string_view automatic_step_name = "auto";

/// Fixed step of known error for the scene's method [T]: 1/20 of its linear limit, or 1/200 of the shortest contact
/// time if that is less (the speed error of an impact with a dashpot is then at most 0.3 %).
/// Errors: InputError if neither exists, or if the method grows at any step.
[[nodiscard]] double automatic_step(const Scene& scene);

/// Interval between two outputs [T] for a method that chooses its steps, if the scene gives none: the end time over a
/// multiple of 1000. It is at most 1/20 of the shortest contact time and of the shortest half period of a cable, so
/// that the largest forces are resolved to 0.3 %; but at least end/1e6, and end/1000 for scenes of more than 150
/// coordinates.
[[nodiscard]] double output_step(const Scene& scene);

}  // namespace talus
