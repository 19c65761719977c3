#pragma once

#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "solver/integrate/concepts.hpp"
#include "solver/integrate/guard_bounds.hpp"
#include "solver/integrate/linear_segment.hpp"
#include "solver/state/state.hpp"

namespace talus {

TALUS_NAMED_MEMBER(NamesGuards, guards);
TALUS_NAMED_MEMBER(NamesGuardsOf, guards_of);
TALUS_NAMED_MEMBER(NamesFollows, follows);
TALUS_NAMED_MEMBER(NamesLengths, lengths);
TALUS_NAMED_MEMBER(NamesAffinePiece, linear_segment);
TALUS_NAMED_MEMBER(NamesLinearization, linearization);
TALUS_NAMED_MEMBER(NamesKeepsAccounts, keeps_accounts);
TALUS_NAMED_MEMBER(NamesMovesMemory, moves_memory);
TALUS_NAMED_MEMBER(NamesWakeAll, wake_all);

/// A system whose modes end where a guard is no longer positive.
template <class S>
concept Guarded = requires(S& system, State& end, const State& state, std::vector<double>& all,
                           std::span<const std::size_t> modes, std::span<double> some) {
  system.update_modes(end, state);
  { system.guards(state, true, 0.0, all) } -> std::same_as<GuardBounds>;
  system.guards_of(state, modes, some);
  { system.follows(state) } -> std::same_as<bool>;
  { system.lengths() } -> std::same_as<std::vector<double>>;
};
template <class S>
concept NamesNoGuards = !NamesGuards<S> && !NamesGuardsOf<S> && !NamesFollows<S> && !NamesLengths<S>;

// Signatures of the other optional members, checked where they are present.
template <class S>
concept AffinePieceFits = !NamesAffinePiece<S> || requires(S & system, const State& state, LinearSegment& out) {
  system.linear_segment(state, out);
};
template <class S>
concept LinearizationFits = !NamesLinearization<S> || requires(S & system, const State& state, LinearSegment& out) {
  system.linearization(state, out);
};
template <class S>
concept KeepsAccountsFits = !NamesKeepsAccounts<S> || requires(const S& system) {
  { system.keeps_accounts() } -> std::same_as<bool>;
};
template <class S>
concept MovesMemoryFits = !NamesMovesMemory<S> || requires(const S& system) {
  { system.moves_memory() } -> std::same_as<bool>;
};
template <class S>
concept WakeAllFits = !NamesWakeAll<S> || requires(S & system, State& state) {
  system.wake_all(state);
};

/// A system that event-locating methods can advance. Members beyond its rates are optional; a member with another
/// signature does not compile, nor do some members of the first group without the others.
///
/// Where events end the modes (without these the motion is smooth):
///   GuardBounds guards(state, same, horizon, out)
///                           one guard per mode, in the state's present modes, and bounds on all of them; `same`: the
///                           state is the one that was last updated, or whose derivative was last evaluated. Guards
///                           that cannot reach zero within the horizon [T] at present speeds may be infinite
///   guards_of(state, modes, out)
///                           guards of the given modes; entries of other modes may change, too
///   update_modes(state, before)
///                           updates modes and memory at the end of a step; `before`: the state at its beginning
///   bool follows(state)     true if some memory must be updated in this way while the motion continues in these modes
///   vector<double> lengths()
///                           per coordinate, the distance [L] by which one unit of it moves its body, constant in time;
///                           default 1
///
/// Independent of each other:
///   linear_segment(state, out)  the linear motion that the state is in; default: there is none
///   linearization(state, out)
///                           approximate change of accelerations and memory rates about a state: the springs and
///                           dashpots that act, without the change of their directions
///   bool keeps_accounts() const
///                           true if work and impulse have rates; default true
///   bool moves_memory() const
///                           true if some memory has a rate; default true
///   wake_all(state)         called before the first step: wakes all bodies of the state
template <class S>
concept Hybrid = Differentiable<S> &&(Guarded<S> || NamesNoGuards<S>)&&AffinePieceFits<S>&& LinearizationFits<
    S>&& KeepsAccountsFits<S>&& MovesMemoryFits<S>&& WakeAllFits<S>;

/// Interface of a Hybrid system to event-locating methods, with defaults for what the system does not offer.
class HybridSystem {
 public:
  virtual void derivative(const State& state, Rates& out) = 0;
  virtual void update_modes(State& state) = 0;
  virtual void update_modes(State& state, const State& before) = 0;
  /// Without guards: none is finite, and steps are not limited.
  virtual GuardBounds guards(const State& state, bool same, double horizon, std::vector<double>& out) = 0;
  virtual void guards_of(const State& state, std::span<const std::size_t> modes, std::span<double> out) = 0;
  virtual bool follows(const State& state) = 0;
  virtual std::vector<double> lengths(const State& state) = 0;
  /// Returns false if the system has no linear motion.
  virtual bool linear_segment(const State& state, LinearSegment& out) = 0;
  /// Returns false if the system has no linearization.
  virtual bool linearization(const State& state, LinearSegment& out) = 0;
  virtual bool has_affine_pieces() const = 0;
  virtual bool keeps_accounts() const = 0;
  virtual bool moves_memory() const = 0;

 protected:
  ~HybridSystem() = default;
};

/// HybridSystem interface of a system, which must outlive it.
template <Hybrid System>
class HybridSystemOf final : public HybridSystem {
 public:
  explicit HybridSystemOf(System& system) : system_{system} {}

  void derivative(const State& state, Rates& out) override { system_.derivative(state, out); }
  void update_modes(State& state) override { system_.update_modes(state); }
  void update_modes(State& state, const State& before) override {
    if constexpr (Guarded<System>)
      system_.update_modes(state, before);
    else
      system_.update_modes(state);
  }
  GuardBounds guards(const State& state, bool same, double horizon, std::vector<double>& out) override {
    if constexpr (Guarded<System>) return system_.guards(state, same, horizon, out);
    return {false, std::numeric_limits<double>::infinity()};
  }
  void guards_of(const State& state, std::span<const std::size_t> modes, std::span<double> out) override {
    if constexpr (Guarded<System>) system_.guards_of(state, modes, out);
  }
  bool follows(const State& state) override {
    if constexpr (Guarded<System>) return system_.follows(state);
    return false;
  }
  std::vector<double> lengths(const State& state) override {
    if constexpr (Guarded<System>) return system_.lengths();
    return std::vector<double>(state.q.size(), 1.0);
  }
  bool linear_segment(const State& state, LinearSegment& out) override {
    if constexpr (NamesAffinePiece<System>) system_.linear_segment(state, out);
    return NamesAffinePiece<System>;
  }
  bool linearization(const State& state, LinearSegment& out) override {
    if constexpr (NamesLinearization<System>) system_.linearization(state, out);
    return NamesLinearization<System>;
  }
  bool has_affine_pieces() const override { return NamesAffinePiece<System>; }
  bool keeps_accounts() const override {
    if constexpr (NamesKeepsAccounts<System>) return system_.keeps_accounts();
    return true;
  }
  bool moves_memory() const override {
    if constexpr (NamesMovesMemory<System>) return system_.moves_memory();
    return true;
  }

 private:
  System& system_;
};

}  // namespace talus
