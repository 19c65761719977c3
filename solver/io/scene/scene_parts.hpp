#pragma once

#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/io/scene/scene_table.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/scenes/scene.hpp"

namespace talus {

/// A body as written: its entry in the model and its initial velocity.
struct SceneBody {
  SceneTable table;
  Body body;
  Vec2 velocity;  ///< [L/T]
  double spin{};  ///< [rad/T]
};

/// How a required restitution sets the dashpot.
enum class RestitutionRule {
  effective_mass,  ///< at every impact, from the effective mass along the normal when the bodies touch, by the formula
                   ///< of the end rule
  eq_21,           ///< once, from the reduced mass of two particles, by the formula of the attractive rule (FENCE 1993)
};
template <>
struct Names<RestitutionRule> {
  static constexpr std::array<std::string_view, 2> list{"effective_mass", "eq_21"};
};

/// A contact as written; `restitution` is set if its damping follows from it by Eq. 21.
struct SceneContact {
  SceneTable table;
  Contact contact;
  std::optional<double> restitution;
  double restitution_speed{};  ///< at which it holds [L/T]; 0 if it holds at every speed
};

/// A cable as written.
struct SceneCable {
  SceneTable table;
  Cable cable;
  std::optional<double> rest_length;  ///< empty: the distance between its ends at the start [L]
  double slack{};                     ///< added to the rest length [L]
};

/// A hanger as written.
struct SceneHanger {
  SceneTable table;
  Hanger hanger;
};

/// The names of a scene's bodies, in their order.
class BodyNames {
 public:
  /// Errors: two bodies with the same name.
  explicit BodyNames(const std::vector<SceneBody>& bodies);

  /// The body with the name that `key` of a table gives. Errors: an unknown name, with the nearest known one; not
  /// reported if it may be the name of a body whose name is missing or wrong, which has already been reported.
  [[nodiscard]] BodyId find(const SceneTable& table, std::string_view key, const std::string& name) const;

 private:
  std::map<std::string, BodyId, std::less<>> ids_;
  std::vector<std::string> names_;
  bool differ_{true};  ///< all names are different
};

/// Read the parts of a scene. Errors are added to those of the source, with file, line, name and field.
[[nodiscard]] std::vector<SceneBody> read_bodies(SceneTable& file);
[[nodiscard]] std::vector<SceneContact> read_contacts(SceneTable& file, const BodyNames& bodies);
[[nodiscard]] std::vector<SceneCable> read_cables(SceneTable& file, const BodyNames& bodies);
[[nodiscard]] std::vector<SceneHanger> read_hangers(SceneTable& file, const BodyNames& bodies);

/// Reads the checks of the run monitor: `watch = { instability = "error", .. }`, or "off".
[[nodiscard]] MonitorRules read_watch(SceneTable& owner, std::string_view key, const MonitorRules& absent = {});

/// Calls visit with a default-constructed value of the variant's alternative called `name`; false if there is none.
template <class Variant, std::size_t I = 0, class Visit>
bool visit_named(std::string_view name, Visit&& visit) {
  if constexpr (I < std::variant_size_v<Variant>) {
    using T = std::variant_alternative_t<I, Variant>;
    if (T::name != name) return visit_named<Variant, I + 1>(name, visit);
    visit(T{});
    return true;
  } else {
    return false;
  }
}

}  // namespace talus
