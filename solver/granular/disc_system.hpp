#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "solver/base/vec.hpp"
#include "solver/granular/discs.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/laws/settling.hpp"

namespace talus {

/// Accelerations of discs [L/T^2], and the power that their contacts keep [F L/T].
struct DiscRates {
  std::vector<double> ax, ay;
  double dissipated{};

  explicit DiscRates(std::size_t count = 0) : ax(count), ay(count) {}
};

/// Many discs that push each other by one law, along the line of their centres.
///
/// A kick goes through the pairs in their order and gives each disc its share of each force's impulse at once; what a
/// law reads of velocities are those from before the kick. Between kicks the discs fly straight. That is the leapfrog.
/// Methods that need accelerations ask for rates.
template <Law L>
class DiscSystem {
 public:
  /// skin [L] > 0: how far beyond contact the neighbour list reaches.
  DiscSystem(DiscShapes shapes, PeriodicBox box, const L& law, double skin)
      : shapes_{std::move(shapes)}, law_{law}, list_{box, skin} {
    wall_forces_.resize(shapes_.walls.size() + 1);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const std::size_t wall = shapes_.wall[i];
      if (wall != DiscShapes::free && shapes_.walls[wall - 1].mass > 0.0) moved_.push_back(i);
    }
  }

  const DiscShapes& shapes() const { return shapes_; }
  const L& law() const { return law_; }
  const NeighbourList& list() const { return list_; }
  /// Times that the list was built.
  long builds() const { return builds_; }
  long evaluations() const { return evaluations_; }
  /// Sum of the contact forces on a wall at the last evaluation [F].
  Vec2 wall_force(std::size_t wall) const { return wall_forces_[wall]; }

  /// Before the first step: contacts that are there have no past.
  void begin(Discs& discs) {
    modes_.clear(), memory_.clear();
    rebuild(discs);
  }

  /// Moves all discs with their velocities.
  void drift(Discs& discs, double h) {
    const double shear = list_.box().shear_rate;
    double fastest = 0.0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      // From the mean flow, so that no pair nears by more than twice this, and the flow across its own distance.
      const double u = discs.vx[i] - shear * discs.y[i];
      fastest = std::max(fastest, u * u + discs.vy[i] * discs.vy[i]);
      discs.x[i] += h * discs.vx[i];
      discs.y[i] += h * discs.vy[i];
    }
    discs.t += h;
    list_.use(std::abs(h) * (2.0 * std::sqrt(fastest) + std::abs(shear) * reach_));
    if (!list_.valid()) rebuild(discs);
  }

  /// Brings the modes up to date and gives all discs the impulses of their forces over h.
  void kick(Discs& discs, double h) {
    old_vx_ = discs.vx, old_vy_ = discs.vy;
    const double power = evaluate_pairs(discs, [&](std::size_t i, std::size_t j, Vec2 force) {
      const double a = h * shapes_.inverse_mass[i], b = h * shapes_.inverse_mass[j];
      discs.vx[i] -= a * force.x, discs.vy[i] -= a * force.y;
      discs.vx[j] += b * force.x, discs.vy[j] += b * force.y;
    });
    discs.dissipated += h * power;
    for (const std::size_t i : moved_)
      discs.vy[i] += h * wall_acceleration(shapes_.wall[i]);
  }

  /// Brings the modes up to date and sums the accelerations.
  void evaluate(Discs& discs, DiscRates& out) {
    old_vx_ = discs.vx, old_vy_ = discs.vy;
    out.ax.assign(discs.size(), 0.0), out.ay.assign(discs.size(), 0.0);
    out.dissipated = evaluate_pairs(discs, [&](std::size_t i, std::size_t j, Vec2 force) {
      const double a = shapes_.inverse_mass[i], b = shapes_.inverse_mass[j];
      out.ax[i] -= a * force.x, out.ay[i] -= a * force.y;
      out.ax[j] += b * force.x, out.ay[j] += b * force.y;
    });
    for (const std::size_t i : moved_)
      out.ay[i] = wall_acceleration(shapes_.wall[i]);
  }

  /// A pair that touches, as it stands.
  struct Contact {
    std::size_t a{}, b{};
    double depth{};   ///< [L]
    Vec2 n_ab;        ///< unit normal from a to b
    double force{};   ///< [F], > 0 pushes apart
    double stored{};  ///< energy [F L]
  };
  /// Calls visit(contact) for each pair whose law acts in the modes of the last evaluation.
  template <class Visit>
  void for_each_contact(const Discs& discs, Visit&& visit) const {
    std::array<NeighbourList::Shift, NeighbourList::images> shifts;
    list_.shifts(discs.t, shifts);
    for (std::size_t a = 0; a < list_.discs(); ++a) {
      for (std::size_t pair = list_.begin(a); pair < list_.end(a); ++pair) {
        if (modes_[pair] == 0) continue;
        const std::size_t b = list_.second(pair);
        const NeighbourList::Shift& shift = shifts[list_.image(pair)];
        const Vec2 d{discs.x[b] - discs.x[a] + shift.x, discs.y[b] - discs.y[a] + shift.y};
        const Vec2 v{discs.vx[b] - discs.vx[a] + shift.vx, discs.vy[b] - discs.vy[a]};
        const double distance = norm(d);
        const Vec2 n = (1.0 / distance) * d;
        const Kinematics x{shapes_.radius[a] + shapes_.radius[b] - distance, -dot(v, n)};
        const auto memory = std::span{memory_}.subspan(pair * L::memory_size, L::memory_size);
        visit(Contact{a, b, x.extent, n, law_(x, memory, modes_[pair]).total(),
                      law_.stored_energy(x, memory, modes_[pair])});
      }
    }
  }

 private:
  /// Calls act(first, second, force on the second) for each pair whose law acts; the power that they keep [F L/T].
  /// What changes of mode release is booked at once.
  template <class Act>
  double evaluate_pairs(Discs& discs, Act&& act) {
    ++evaluations_;
    std::fill(wall_forces_.begin(), wall_forces_.end(), Vec2{});
    std::array<NeighbourList::Shift, NeighbourList::images> shifts;
    list_.shifts(discs.t, shifts);
    double power = 0.0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const double x = discs.x[i], y = discs.y[i], radius = shapes_.radius[i];
      for (std::size_t pair = list_.begin(i), last = list_.end(i); pair < last; ++pair) {
        const std::size_t j = list_.second(pair);
        const NeighbourList::Shift& shift = shifts[list_.image(pair)];
        const double dx = discs.x[j] - x + shift.x, dy = discs.y[j] - y + shift.y;
        const double square = dx * dx + dy * dy, touch = radius + shapes_.radius[j];
        Mode& mode = modes_[pair];
        if (square >= touch * touch && mode == 0) continue;
        const double distance = std::sqrt(square);
        const Vec2 n{dx / distance, dy / distance};
        const double closing = -((old_vx_[j] - old_vx_[i] + shift.vx) * n.x + (old_vy_[j] - old_vy_[i]) * n.y);
        const Kinematics kinematics{touch - distance, closing};
        const auto memory = std::span{memory_}.subspan(pair * L::memory_size, L::memory_size);
        settle(law_, memory, kinematics, mode, [&](double released) { discs.dissipated += released; });
        if (mode == 0) continue;
        const LawForce force = law_(kinematics, memory, mode);
        const Vec2 on_second = force.total() * n;
        if (shapes_.wall[i] != DiscShapes::free) wall_forces_[shapes_.wall[i]] -= on_second;
        if (shapes_.wall[j] != DiscShapes::free) wall_forces_[shapes_.wall[j]] += on_second;
        power += force.dissipative * closing;
        act(i, j, on_second);
      }
    }
    return power;
  }

  /// Of a wall with a mass, along y [L/T^2].
  double wall_acceleration(std::size_t wall) const {
    const DiscWall& moved = shapes_.walls[wall - 1];
    return wall_forces_[wall].y / moved.mass - moved.gravity;
  }

  /// Lists the pairs anew; what contacts remember goes with them.
  void rebuild(Discs& discs) {
    wrap(list_.box(), discs);
    const NeighbourList old = list_;
    const std::vector<Mode> old_modes = std::move(modes_);
    const std::vector<double> old_memory = std::move(memory_);
    list_.build(shapes_, discs);
    ++builds_;
    reach_ = 2.0 * *std::max_element(shapes_.radius.begin(), shapes_.radius.end()) + list_.skin();
    modes_.assign(list_.size(), Mode{});
    memory_.assign(list_.size() * L::memory_size, 0.0);
    if (old_modes.empty()) return;
    for (std::size_t i = 0; i < old.discs(); ++i) {
      for (std::size_t was = old.begin(i); was < old.end(i); ++was) {
        if (old_modes[was] == 0) continue;
        // What acted touched a step ago, and has come apart by less than the skin since.
        const std::size_t is = list_.find(i, old.second(was));
        if (is == list_.size()) continue;
        modes_[is] = old_modes[was];
        for (std::size_t k = 0; k < L::memory_size; ++k)
          memory_[is * L::memory_size + k] = old_memory[was * L::memory_size + k];
      }
    }
  }

  DiscShapes shapes_;
  L law_;
  NeighbourList list_;
  double reach_{};                       ///< of the list, between centres [L]
  std::vector<Mode> modes_;              ///< one for each pair
  std::vector<double> memory_;           ///< of each pair, as much as the law keeps
  std::vector<Vec2> wall_forces_;        ///< the first of no wall
  std::vector<std::size_t> moved_;       ///< discs of walls with a mass
  std::vector<double> old_vx_, old_vy_;  ///< from before the kick
  long builds_{};
  long evaluations_{};
};

}  // namespace talus
