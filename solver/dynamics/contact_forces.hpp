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

/// The contacts of a model, compiled: gaps, forces, modes and energies of all law instances. Of a contact whose bodies
/// are out of reach nothing is computed.
class ContactForces {
 public:
  ContactForces(const Model& model, const Layout& layout);

  /// Number of law instances: the length of Workspace::gaps and Workspace::rates.
  std::size_t size() const { return pairs_.size(); }
  /// Number of pairs that the search looks at: the length of Workspace::near.
  std::size_t candidates() const { return search_.pairs().size(); }
  /// The pair of a contact, as the search sees it.
  const Candidate& pair(ContactId contact) const { return search_.pairs()[index(contact)]; }

  /// Finds the pairs within reach, and those that still act in this state; whether there are any.
  bool find(const State& state, Workspace& work) const;
  /// Their gaps.
  void update(const State& state, Workspace& work) const;
  /// After update(): largest overlap of each contact [L]; negative while its bodies are apart. Writes no gaps of pairs
  /// out of reach.
  void largest_depths(const Workspace& work, std::span<double> out) const;
  /// Gaps of all pairs.
  void update_all(Workspace& work) const;
  /// After update(): the gaps that it left out, but of bodies that at their present speed, and under this pull [L/T^2],
  /// do not come within reach of each other in the time ahead [T]. The longest step, as passing() says, up to that
  /// time.
  double update_far(const State& state, double ahead, double pull, Workspace& work) const;
  /// Gaps of the pairs that have one of these modes alone; whether there are any.
  bool update_of(const State& state, std::span<const std::size_t> modes, Workspace& work) const;
  /// Whether a mode is of a contact or its friction.
  bool has(std::size_t mode) const { return mode < pair_of_.size() && pair_of_[mode] < candidates(); }
  /// Before the first update_modes() of a run: friction within reach sticks, so that what pushes keeps the stretch it has.
  void begin(State& state, const Workspace& work) const;
  /// Evaluates the normal forces of what acts, unless they are known: once for friction, wrenches and reports.
  void push(const State& state, Workspace& work) const;
  /// `before`: see Dynamics::update_modes().
  void update_modes(State& state, Workspace& work, const State* before) const;
  /// Lists the sleeping bodies that another touches.
  void list_woken(const Workspace& work, std::vector<BodyId>& woken) const;
  /// Adds the forces to the wrenches of both bodies; with out, the dissipated power as well, with `slip_power` also
  /// that of friction that slips.
  void add(const State& state, Workspace& work, Rates* out, bool slip_power) const;
  /// Whether some memory is taken along by update_modes() alone: of latching springs that load, of friction that slips.
  bool follows(const State& state) const;
  /// The longest step [T] in which no body passes half the least width of another, under this pull [L/T^2], and the
  /// contact that sets it; infinite where none does.
  struct TunnellingLimit {
    double longest_step{std::numeric_limits<double>::infinity()};
    ContactId contact{};
  };
  TunnellingLimit tunnelling_limit(const Workspace& work, double pull) const;
  /// The deepest overlap within reach, as a share of half the least width of the smaller of its bodies.
  struct Overlap {
    double share{};
    ContactId contact{};
  };
  Overlap deepest_overlap(const Workspace& work) const;
  /// Of the instances within reach.
  void guards(const State& state, Workspace& work, std::span<double> out) const;
  /// A contact that acts, where its normal does not turn and its law is linear: between the motions of the two bodies
  /// along the normal.
  struct LinearContact {
    BodyId a{};
    BodyId b{};
    Vec2 n_AB;
    Tangent slopes;              ///< of the law's force
    double symmetry_weight_a{};  ///< see ContactGroup
    double symmetry_weight_b{};
  };
  /// Those of the instances within reach; of other laws none.
  std::vector<LinearContact> linear_contacts(const State& state, const Workspace& work) const;
  /// An instance that acts.
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
      std::size_t memory{};  ///< of its stretch in the state
      double stiffness{};    ///< [F/L]
      double dashpot{};      ///< [F T/L]
      double coefficient{};
    };
    std::optional<Friction> friction;
  };
  void for_each_acting(const State& state, const Workspace& work,
                       const std::function<void(const ActingContact&)>& visit) const;
  /// Rates of the memory that follows the motion: the slip rate where two bodies touch and friction acts.
  void memory_rates(const State& state, Workspace& work, Rates& out) const;
  double stored_energy(const State& state, const Workspace& work) const;
  /// Normal force of each instance [F], > 0 pushing apart.
  void forces(const State& state, Workspace& work, std::span<double> out) const;
  /// Of each instance.
  const std::vector<InstancePair>& pairs() const { return pairs_; }

 private:
  void start_contacts(State& state, const Workspace& work) const;

  ContactLaws::Tuple<ContactArrays> laws_;
  bool rough_{};           ///< some contact has friction
  bool starts_by_mass_{};  ///< the memory of some law starts with the effective mass of its contact
  PointMobility mobility_;
  ContactSearch search_;
  std::vector<std::size_t> pair_of_;  ///< of each mode slot, in the search; the number of pairs for other modes
  std::vector<InstancePair> pairs_;
};

}  // namespace talus
