#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "solver/dynamics/candidates.hpp"
#include "solver/dynamics/contact_arrays.hpp"
#include "solver/dynamics/effective_mass.hpp"
#include "solver/dynamics/workspace.hpp"
#include "solver/geometry/gap.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/model/layout.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// The contacts of a model, compiled: gaps, forces, modes and energies of all law instances. Contacts whose bodies are
/// out of reach are not computed.
class ContactForces {
 public:
  ContactForces(const Model& model, const Layout& layout);

  /// Number of law instances: the length of Workspace::gaps and Workspace::rates.
  std::size_t size() const { return pairs_.size(); }
  /// Number of pairs in the search: the length of Workspace::near.
  std::size_t candidates() const { return search_.pairs().size(); }
  /// Pair of a contact in the search.
  const Candidate& pair(ContactId contact) const { return search_.pairs()[index(contact)]; }

  /// Finds the pairs within reach, and those that still act in this state. True if there are any.
  bool find(const State& state, Workspace& work) const;
  /// Computes the gaps of these pairs.
  void update(const State& state, Workspace& work) const;
  /// After update(): largest overlap of each contact [L]; negative while its bodies are apart. Does not write the gaps
  /// of pairs out of reach.
  void largest_depths(const Workspace& work, std::span<double> out) const;
  /// Computes the gaps of all pairs.
  void update_all(Workspace& work) const;
  /// After update(): computes also the gaps that it omitted, except for bodies that at their present speed, and under
  /// the acceleration `pull` [L/T^2], do not come within reach of each other in the time `horizon` [T]. Returns the
  /// longest step of tunnelling_limit(), at most `horizon`.
  double update_far(const State& state, double horizon, double pull, Workspace& work) const;
  /// Computes only the gaps of the pairs that have one of these modes. True if there are any.
  bool update_of(const State& state, std::span<const std::size_t> modes, Workspace& work) const;
  /// True if a mode is of a contact or its friction.
  bool has(std::size_t mode) const { return mode < pair_of_.size() && pair_of_[mode] < candidates(); }
  /// Before the first update_modes() of a run: sets open friction within reach to sticking, so that contacts that push
  /// keep the stretch they have.
  void begin(State& state, const Workspace& work) const;
  /// Evaluates the normal forces of the instances that act, unless they are known: once for friction, wrenches and
  /// reports.
  void push(const State& state, Workspace& work) const;
  /// `before`: see Dynamics::update_modes().
  void update_modes(State& state, Workspace& work, const State* before) const;
  /// Lists the sleeping bodies that another body touches.
  void list_woken(const Workspace& work, std::vector<BodyId>& woken) const;
  /// Adds the forces to the wrenches of both bodies; with `out`, computes also the dissipated power, with `slip_power`
  /// including that of slipping friction.
  void add(const State& state, Workspace& work, Rates* out, bool slip_power) const;
  /// True if some memory is changed by update_modes() alone: of latching springs that load, of friction that slips.
  bool follows(const State& state) const;
  /// Longest step [T] in which no body moves past another by more than tunnelling_distance(), the mean of the smallest
  /// half widths of the two, under the acceleration `pull` [L/T^2], and the contact that sets it; infinite if there is
  /// none.
  struct TunnellingLimit {
    double longest_step{std::numeric_limits<double>::infinity()};
    ContactId contact{};
  };
  TunnellingLimit tunnelling_limit(const Workspace& work, double pull) const;
  /// Longest step [T], at most `horizon`, after which no pair can have missed its contact: each may close the distance
  /// between the circles around its bodies, or move by tunnelling_distance() where that is more.
  double safe_step(const Workspace& work, double horizon, double pull) const;
  /// Largest overlap within reach, relative to half the smallest width of the smaller of its bodies.
  struct Overlap {
    double ratio{};
    ContactId contact{};
  };
  Overlap deepest_overlap(const Workspace& work) const;
  /// Computes the guards of the instances within reach.
  void guards(const State& state, Workspace& work, std::span<double> out) const;
  /// An acting contact whose normal does not turn and whose law is linear, between the motions of the two bodies along
  /// the normal.
  struct LinearContact {
    BodyId a{};
    BodyId b{};
    Vec2 n_AB;
    Tangent slopes;              ///< of the law's force
    double symmetry_weight_a{};  ///< see ContactGroup
    double symmetry_weight_b{};
  };
  /// Linear contacts among the instances within reach; other laws have none.
  std::vector<LinearContact> linear_contacts(const State& state, const Workspace& work) const;
  /// A law instance that acts.
  struct ActingContact {
    BodyId a{};
    BodyId b{};
    Vec2 n_AB;
    Vec2 p_WC;
    Tangent slopes;              ///< of the normal force
    double symmetry_weight_a{};  ///< see ContactGroup
    double symmetry_weight_b{};
    struct Friction {
      Mode mode{};
      std::size_t memory{};  ///< index of its stretch in State::z
      double stiffness{};    ///< [F/L]
      double dashpot{};      ///< [F T/L]
      double coefficient{};
    };
    std::optional<Friction> friction;
  };
  void for_each_acting(const State& state, const Workspace& work,
                       const std::function<void(const ActingContact&)>& visit) const;
  /// Computes the rates of the memory that follows the motion: the slip rate where two bodies touch and friction acts.
  void memory_rates(const State& state, Workspace& work, Rates& out) const;
  void drift_memory(State& state, const Workspace& work, double h) const;
  double stored_energy(const State& state, const Workspace& work) const;
  /// Normal force of each instance [F], > 0 pushing apart.
  void forces(const State& state, Workspace& work, std::span<double> out) const;
  /// After forces(): friction force of each instance [F], which acts on B against the tangent: > 0 resists slip of B
  /// past A along the tangent, counter-clockwise from the normal. 0 for contacts without friction.
  void friction_forces(const State& state, const Workspace& work, std::span<double> out) const;
  /// Bodies of each instance.
  const std::vector<InstancePair>& pairs() const { return pairs_; }

 private:
  void start_contacts(State& state, const Workspace& work) const;

  ContactLaws::Tuple<ContactArrays> laws_;
  bool rough_{};           ///< some contact has friction
  bool starts_by_mass_{};  ///< some law initialises its memory with the effective mass of its contact
  PointMobility mobility_;
  ContactSearch search_;
  std::vector<std::size_t> pair_of_;  ///< pair of each mode slot in the search; the number of pairs for other modes
  std::vector<InstancePair> pairs_;
};

}  // namespace talus
