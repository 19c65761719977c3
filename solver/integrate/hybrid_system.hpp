#pragma once

#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "solver/integrate/affine_piece.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/integrate/guard_bounds.hpp"
#include "solver/state/state.hpp"

namespace talus {

TALUS_NAMED_MEMBER(NamesGuards, guards);
TALUS_NAMED_MEMBER(NamesGuardsOf, guards_of);
TALUS_NAMED_MEMBER(NamesFollows, follows);
TALUS_NAMED_MEMBER(NamesLengths, lengths);
TALUS_NAMED_MEMBER(NamesAffinePiece, affine_piece);
TALUS_NAMED_MEMBER(NamesLinearization, linearization);
TALUS_NAMED_MEMBER(NamesKeepsAccounts, keeps_accounts);
TALUS_NAMED_MEMBER(NamesMovesMemory, moves_memory);
TALUS_NAMED_MEMBER(NamesWakeAll, wake_all);

/// A system with guards.
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

// The form of each other optional member, if it is there at all.
template <class S>
concept AffinePieceFits = !NamesAffinePiece<S> || requires(S & system, const State& state, AffinePiece& out) {
  system.affine_piece(state, out);
};
template <class S>
concept LinearizationFits = !NamesLinearization<S> || requires(S & system, const State& state, AffinePiece& out) {
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

/// A system that a method which locates events can advance. What it offers beyond its rates is optional; a member of
/// another signature is an error of compilation, and so are some of the first group without the others.
///
/// Where events end the modes (without them the motion is smooth):
///   GuardBounds guards(state, same, ahead, out)  one for each mode, in the state's present modes, and what holds for all;
///                           `same`: of the state that was brought up to date, or whose derivative was evaluated, last.
///                           One that at the present speeds cannot end within the time `ahead` [T] may be infinite
///   guards_of(state, modes, out)     those of a few modes; the numbers of others may change, too
///   update_modes(state, before)   brings modes and memory up to date at the end of a step, from the state at its beginning
///   bool follows(state)     whether some memory must be brought up to date so as the motion continues in these modes
///   vector<double> lengths()         for each coordinate, the length [L] by which one unit of it moves its body: the
///                           same at all times; else 1
///
/// Each by itself:
///   affine_piece(state, out)         the linear motion that the state is in; else there is none
///   linearization(state, out)        how accelerations and memory rates change about a state, nearly: the springs and
///                           dashpots that act, without the change of their directions
///   bool keeps_accounts() const      whether work and impulse have rates; else true
///   bool moves_memory() const        whether some memory has a rate; else true
///   wake_all(state)         before the first step: no body of the state sleeps afterwards
template <class S>
concept Hybrid = Differentiable<S> &&(Guarded<S> || NamesNoGuards<S>)&&AffinePieceFits<S>&& LinearizationFits<
    S>&& KeepsAccountsFits<S>&& MovesMemoryFits<S>&& WakeAllFits<S>;

/// A Hybrid as methods that locate events know it: what the system does not offer has its default here.
class HybridSystem {
 public:
  virtual void derivative(const State& state, Rates& out) = 0;
  virtual void update_modes(State& state) = 0;
  virtual void update_modes(State& state, const State& before) = 0;
  /// Without guards none is finite, and no step too long.
  virtual GuardBounds guards(const State& state, bool same, double ahead, std::vector<double>& out) = 0;
  virtual void guards_of(const State& state, std::span<const std::size_t> modes, std::span<double> out) = 0;
  virtual bool follows(const State& state) = 0;
  virtual std::vector<double> lengths(const State& state) = 0;
  /// False if the system has no linear motion.
  virtual bool affine_piece(const State& state, AffinePiece& out) = 0;
  /// False if the system does not say.
  virtual bool linearization(const State& state, AffinePiece& out) = 0;
  virtual bool has_affine_pieces() const = 0;
  virtual bool keeps_accounts() const = 0;
  virtual bool moves_memory() const = 0;

 protected:
  ~HybridSystem() = default;
};

/// That of a system, which must outlive it.
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
  GuardBounds guards(const State& state, bool same, double ahead, std::vector<double>& out) override {
    if constexpr (Guarded<System>) return system_.guards(state, same, ahead, out);
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
  bool affine_piece(const State& state, AffinePiece& out) override {
    if constexpr (NamesAffinePiece<System>) system_.affine_piece(state, out);
    return NamesAffinePiece<System>;
  }
  bool linearization(const State& state, AffinePiece& out) override {
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
