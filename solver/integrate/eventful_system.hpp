#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "solver/integrate/affine_piece.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// What is said along with the guards of a state.
struct Prospect {
  bool finite{};          ///< some of them may be; else they are not written
  double longest_step{};  ///< from there in which no body can pass another unseen; none beyond the time ahead [T]
};

/// What a method that locates events asks of its system.
struct EventfulSystem {
  /// Rates in the state's present modes: one force evaluation.
  std::function<void(const State&, Rates&)> derivative;
  /// Guards in the state's present modes, one for each mode; `same`: of the state that was settled, or whose derivative
  /// was asked for, last. One that at the present speeds cannot end in the time `ahead` [T] may be infinite. No
  /// function: the motion is smooth.
  std::function<Prospect(const State&, bool same, double ahead, std::vector<double>&)> guards;
  /// Those of a few modes; the numbers of others may change, too.
  std::function<void(const State&, std::span<const std::size_t> modes, std::span<double>)> guards_of;
  /// Brings modes and memory up to date.
  std::function<void(State&)> settle;
  /// The same at the end of a step, from the state at its beginning.
  std::function<void(State&, const State& before)> settle_step;
  /// Whether some memory must be settled as the motion goes on, in the state's modes.
  std::function<bool(const State&)> follows;
  /// Of each coordinate of a state, the length [L] that one unit of it moves its body by: the same at all times.
  std::function<std::vector<double>(const State&)> lengths;
  /// The linear piece that the state is in: none if the system has no such pieces.
  std::function<void(const State&, AffinePiece&)> affine_piece;
  /// How accelerations and memory rates change about a state, nearly: the springs and dashpots that act, without the
  /// change of their directions. None if the system does not say.
  std::function<void(const State&, AffinePiece&)> linearization;
  /// Whether work and impulse are kept; if not they have no rates.
  bool keeps_accounts{true};
  /// Whether some memory has a rate.
  bool moves_memory{true};
};

/// The system behind functions. It must outlive them.
template <class System>
EventfulSystem eventful(System& system) {
  EventfulSystem asked;
  asked.derivative = [&system](const State& at, Rates& out) { system.derivative(at, out); };
  asked.settle = [&system](State& at) { system.settle(at); };
  if constexpr (requires(State & at) { system.settle(at, State{}); }) {
    asked.settle_step = [&system](State& at, const State& before) { system.settle(at, before); };
  } else {
    asked.settle_step = [&system](State& at, const State&) { system.settle(at); };
  }
  if constexpr (requires(std::vector<double> & out) { system.guards(State{}, true, 0.0, out); }) {
    asked.guards = [&system](const State& at, bool same, double ahead, std::vector<double>& out) {
      return system.guards(at, same, ahead, out);
    };
    asked.guards_of = [&system](const State& at, std::span<const std::size_t> modes, std::span<double> out) {
      system.guards_of(at, modes, out);
    };
    asked.follows = [&system](const State& at) { return system.follows(at); };
    asked.lengths = [&system](const State&) { return system.lengths(); };
  } else {
    asked.lengths = [](const State& at) { return std::vector<double>(at.q.size(), 1.0); };
  }
  if constexpr (requires(AffinePiece & out) { system.affine_piece(State{}, out); })
    asked.affine_piece = [&system](const State& at, AffinePiece& out) { system.affine_piece(at, out); };
  if constexpr (requires(AffinePiece & out) { system.linearization(State{}, out); })
    asked.linearization = [&system](const State& at, AffinePiece& out) { system.linearization(at, out); };
  if constexpr (requires { system.keeps_accounts(); }) asked.keeps_accounts = system.keeps_accounts();
  if constexpr (requires { system.moves_memory(); }) asked.moves_memory = system.moves_memory();
  return asked;
}

}  // namespace talus
