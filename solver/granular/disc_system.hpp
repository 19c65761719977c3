#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/base/vec.hpp"
#include "solver/granular/disc_contact.hpp"
#include "solver/granular/discs.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/laws/mode_update.hpp"

namespace talus {

/// Many discs with one contact law along the line of their centres. With a friction law F of DiscFrictions they also
/// have friction across that line and turn, each with the inertia of a solid disc.
///
/// A kick visits the pairs in order and applies the impulse of each force to both discs at once; laws see the
/// velocities from before the kick. Between kicks the discs move along straight lines. This is the leapfrog. Methods
/// that need accelerations call evaluate().
///
/// Contact memories and modes are stored with the pairs of the list and are carried over to the next list. A system
/// therefore belongs to one state, and works with methods of one evaluation per step.
///
/// List: provides the pairs of discs that may touch, and the image of the second disc.
template <Law L, class F = Frictionless, class List = NeighbourList>
requires CanHaveFriction<L, F>
class DiscSystem {
 public:
  static constexpr bool turns = turns_discs<F>;
  /// Whether the loss of a contact follows from its memory, to which steps add no error.
  static constexpr bool loses_by_memory = HasHysteresisLoss<L>;

  /// skin [L] > 0: how far the neighbour list reaches beyond the law's reach.
  DiscSystem(DiscShapes shapes, PeriodicBox box, const L& law, double skin, const F& friction = {})
      : shapes_{std::move(shapes)}, law_{law}, friction_{friction}, list_{box, skin, reach(law)} {
    wall_forces_.resize(shapes_.walls.size() + 1);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const std::size_t wall = shapes_.wall[i];
      if (wall != DiscShapes::free && shapes_.walls[wall - 1].mass > 0.0) moved_.push_back(i);
    }
  }

  const DiscShapes& shapes() const { return shapes_; }
  const L& law() const { return law_; }
  const F& friction() const { return friction_; }
  const List& list() const { return list_; }
  /// The mode of the law of each pair of the list.
  const std::vector<Mode>& modes() const { return contacts_.mode; }
  /// Number of times that the list was built.
  long builds() const { return builds_; }
  long evaluations() const { return evaluations_; }
  /// Sum of the contact forces on a wall at the last evaluation [F].
  Vec2 wall_force(std::size_t wall) const { return wall_forces_[wall]; }

  /// Initializes before the first step; contacts that exist already start without history.
  void begin(Discs& discs) {
    contacts_ = Contacts{};
    if constexpr (turns) discs.spin.resize(discs.size());
    rebuild(discs);
    if constexpr (turns) {
      list_.for_each_pair(discs, [&](std::size_t a, std::size_t b, std::size_t pair, Vec2 d, const auto&) {
        if (norm(d) < shapes_.radius[a] + shapes_.radius[b]) contacts_.friction_mode[pair] = CoulombFriction::sticking;
      });
    }
  }

  /// Moves all discs with their velocities, and adds the slip to the stretch of the friction springs, computed at the
  /// midpoint of the drift.
  void drift(Discs& discs, double h) {
    if constexpr (turns) stretch(discs, h);
    double fastest = 0.0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const Vec2 v{discs.vx[i], discs.vy[i]};
      fastest = std::max(fastest, list_.flow().own_speed_squared(v, discs.y[i]));
      discs.x[i] += h * v.x;
      discs.y[i] += h * v.y;
    }
    discs.shear_displacement += h * list_.box().sliding();
    list_.use(list_.approach(h, fastest));
    if (!list_.holds(discs)) rebuild(discs);
  }

  /// A copy of the discs, moved with their velocities over h; contacts are not updated.
  Discs drifted(const Discs& discs, double h) const { return talus::drifted(discs, list_.box().sliding(), h); }

  /// Updates the modes; not counted as an evaluation.
  void update_modes(Discs& discs) {
    const long evaluations = evaluations_;
    DiscRates none{discs};
    evaluate(discs, none);
    evaluations_ = evaluations;
  }

  /// Updates the modes and applies the impulses of all forces over h.
  void kick(Discs& discs, double h) {
    old_vx_ = discs.vx, old_vy_ = discs.vy, old_spin_ = discs.spin;
    std::array<double, mechanism_count> powers{};
    evaluate_pairs(discs, {old_vx_, old_vy_, old_spin_}, powers, giving(discs.vx, discs.vy, discs.spin, h));
    for (std::size_t k = 0; k < powers.size(); ++k)
      discs.work[k] += h * powers[k];
    for (const std::size_t i : moved_)
      discs.vy[i] += h * wall_acceleration(shapes_.wall[i]);
  }

  /// Updates the modes and sums the accelerations.
  void evaluate(Discs& discs, DiscRates& out) {
    for (auto* rates : {&out.vx, &out.vy, &out.spin})
      std::fill(rates->begin(), rates->end(), 0.0);
    out.work.fill(0.0);
    evaluate_pairs(discs, {discs.vx, discs.vy, discs.spin}, out.work, giving(out.vx, out.vy, out.spin, 1.0));
    for (const std::size_t i : moved_)
      out.vy[i] = wall_acceleration(shapes_.wall[i]);
  }

  /// Calls visit(contact) for each pair whose law acted at the last evaluation and that is still within its reach at
  /// the present positions.
  template <class Visit>
  void for_each_contact(const Discs& discs, Visit&& visit) const {
    for_each_acting(discs, acts(), 0.0, [&](std::size_t a, std::size_t b, std::size_t pair, const Touch& touch) {
      if (!(touch.x.deformation > -reach(law_))) return;
      std::array<double, L::memory_size + 1> memory{};
      std::copy_n(contacts_.memory.data() + pair * L::memory_size, L::memory_size, memory.begin());
      const std::span<double> remembered{memory.data(), L::memory_size};
      Mode mode = contacts_.mode[pair];
      talus::update_mode(law_, remembered, touch.x, mode, [](double) {});
      DiscContact contact{.a = a,
                          .b = b,
                          .depth = touch.x.deformation,
                          .n_ab = touch.n,
                          .distance = touch.distance,
                          .force = mode == 0 ? 0.0 : law_(touch.x, remembered, mode).total(),
                          .stored = law_.stored_energy(touch.x, remembered, mode)};
      if constexpr (turns) {
        const CoulombFriction friction = friction_.at(touch.x.deformation);
        contact.friction = friction(contacts_.stretch[pair], contact.force);
        contact.stored += friction.stored_energy(contacts_.stretch[pair]);
      }
      visit(contact);
    });
  }

  /// Serializes what a run of these discs carries from step to step besides their state: the discs, mode and memory of
  /// each contact, and how much of the list's skin is used. When loading, `discs` must already be restored.
  void serialize(Archive& archive, const Discs& discs) {
    archive.scope("list", [&] { list_.serialize(archive, shapes_); });
    std::vector<double> firsts, seconds;
    Contacts acting;
    if (archive.is_loading()) {
      contacts_ = Contacts{list_.size()};
    } else {
      for_each_acting(discs, acts(), 0.0, [&](std::size_t a, std::size_t b, std::size_t pair, const Touch&) {
        firsts.push_back(static_cast<double>(a)), seconds.push_back(static_cast<double>(b));
        acting.append(contacts_, pair);
      });
    }
    archive.scope("contact", [&] {
      archive.list("first", firsts), archive.list("second", seconds);
      acting.serialize(archive, firsts.size());
    });
    if (archive.is_loading()) {
      for (std::size_t k = 0; k < firsts.size(); ++k) {
        const std::size_t pair = list_.find(static_cast<std::size_t>(firsts[k]), static_cast<std::size_t>(seconds[k]));
        if (pair == list_.size()) {
          throw InputError{"contact: found one of the discs " + std::to_string(firsts[k]) + " and " +
                           std::to_string(seconds[k]) + "; they must be near each other"};
        }
        contacts_.take(pair, acting, k);
      }
    }
  }

 private:
  struct Velocities {
    std::span<const double> x, y, spin;
  };

  /// Two discs at the separation d with the relative velocity v; apart: |d|; radii: sum of the radii.
  struct Touch {
    Touch(Vec2 d, Vec2 v, double apart, double radii)
        : distance{apart}, n{d.x / apart, d.y / apart}, v_ab{v}, x{radii - apart, -dot(v, n)} {}
    double distance;
    Vec2 n, v_ab;
    Kinematics x;
  };

  /// Force of the first disc of a pair on the second.
  struct Push {
    Vec2 force;               ///< [F]
    double friction{};        ///< tangential force, which turns both discs [F]
    double arm_a{}, arm_b{};  ///< its lever arms [L]
  };

  /// Contact data of the listed pairs.
  struct Contacts {
    std::vector<Mode> mode;
    std::vector<double> memory;
    std::vector<Mode> friction_mode;
    std::vector<double> stretch;

    explicit Contacts(std::size_t pairs = 0) : mode(pairs), memory(pairs * L::memory_size) {
      if constexpr (turns) friction_mode.resize(pairs), stretch.resize(pairs);
    }
    /// Whether the law acts or friction is not open: discs that touch from the start stick before their law has acted.
    bool act(std::size_t pair) const {
      if constexpr (turns) return mode[pair] != 0 || friction_mode[pair] != CoulombFriction::open;
      return mode[pair] != 0;
    }
    void take(std::size_t pair, const Contacts& from, std::size_t was) {
      mode[pair] = from.mode[was];
      for (std::size_t k = 0; k < L::memory_size; ++k)
        memory[pair * L::memory_size + k] = from.memory[was * L::memory_size + k];
      if constexpr (turns) friction_mode[pair] = from.friction_mode[was], stretch[pair] = from.stretch[was];
    }
    void append(const Contacts& from, std::size_t was) {
      const std::size_t pairs = mode.size() + 1;
      mode.resize(pairs), memory.resize(pairs * L::memory_size);
      if constexpr (turns) friction_mode.resize(pairs), stretch.resize(pairs);
      take(pairs - 1, from, was);
    }
    void serialize(Archive& to, std::size_t pairs) {
      if (to.is_loading()) *this = Contacts{pairs};
      to.numbers("mode", mode), to.numbers("memory", memory);
      to.numbers("friction_mode", friction_mode), to.numbers("stretch", stretch);
    }
  };

  /// An overlap that is just out of the law's reach [L].
  double out_of_reach() const {
    if constexpr (ActsAtDistance<L>) return std::nextafter(-reach(law_), -std::numeric_limits<double>::infinity());
    return -std::numeric_limits<double>::min();
  }

  /// 1/(inertia of a solid disc) over 1/mass [1/L^2].
  double per_mass(std::size_t disc) const { return 2.0 / (shapes_.radius[disc] * shapes_.radius[disc]); }

  /// Lever arm of a contact: from the disc's centre to the middle of the overlap [L].
  double arm(std::size_t disc, const Touch& touch) const { return shapes_.radius[disc] - 0.5 * touch.x.deformation; }

  /// Tangential velocity of the second disc's surface past the first's, along the normal turned counter-clockwise
  /// [L/T].
  double slip_rate(const Touch& touch, double arm_a, double spin_a, double arm_b, double spin_b) const {
    return dot(touch.v_ab, cross(1.0, touch.n)) - spin_a * arm_a - spin_b * arm_b;
  }

  auto acts() const {
    return [this](std::size_t pair) { return contacts_.act(pair); };
  }

  /// Calls visit(first, second, pair, touch) for the listed pairs that act(pair) selects, with positions advanced by
  /// the time `later` [T].
  template <class Act, class Visit>
  void for_each_acting(const Discs& discs, Act&& act, double later, Visit&& visit) const {
    list_.for_each_pair(discs, [&](std::size_t a, std::size_t b, std::size_t pair, Vec2 d, const auto& shift) {
      if (!act(pair)) return;
      const Vec2 v{(discs.vx[b] + shift.vx) - discs.vx[a], discs.vy[b] - discs.vy[a]};
      const Vec2 then = d + later * v;
      visit(a, b, pair, Touch{then, v, norm(then), shapes_.radius[a] + shapes_.radius[b]});
    });
  }

  void stretch(const Discs& discs, double h) {
    const auto rubs = [&](std::size_t pair) { return contacts_.friction_mode[pair] != CoulombFriction::open; };
    for_each_acting(discs, rubs, 0.5 * h, [&](std::size_t a, std::size_t b, std::size_t pair, const Touch& touch) {
      const double slip = slip_rate(touch, arm(a, touch), discs.spin[a], arm(b, touch), discs.spin[b]);
      contacts_.stretch[pair] = friction_.stretch_after(contacts_.stretch[pair], slip, touch.x, h);
    });
  }

  /// Function that applies a pair force over h to both discs: to velocities, or with h = 1 to rates.
  auto giving(std::vector<double>& vx, std::vector<double>& vy, std::vector<double>& spin, double h) const {
    return [&, h](std::size_t i, std::size_t j, const Push& push) {
      const double a = h * shapes_.inverse_mass[i], b = h * shapes_.inverse_mass[j];
      vx[i] -= a * push.force.x, vy[i] -= a * push.force.y;
      vx[j] += b * push.force.x, vy[j] += b * push.force.y;
      if constexpr (turns) {
        spin[i] += a * push.friction * push.arm_a * per_mass(i);
        spin[j] += b * push.friction * push.arm_b * per_mass(j);
      }
    };
  }

  /// Calls act(first, second, push) for each pair whose law acts, and sums the dissipated powers [F L/T]. Energy
  /// released by changes of mode, and the loss that follows from a law's memory, are added to discs.work at once. Laws
  /// see the velocities v, which act() must not change.
  template <class Act>
  void evaluate_pairs(Discs& discs, const Velocities& v, std::array<double, mechanism_count>& powers, Act&& act) {
    ++evaluations_;
    std::fill(wall_forces_.begin(), wall_forces_.end(), Vec2{});
    std::array<NeighbourList::Shift, NeighbourList::images> shifts;
    list_.shifts(discs.shear_displacement, shifts);
    double& released = discs.work[static_cast<std::size_t>(L::release)];
    double& lost = discs.work[static_cast<std::size_t>(L::dissipation)];
    double power = 0.0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const double x = discs.x[i], y = discs.y[i], radius = shapes_.radius[i];
      for (std::size_t pair = list_.begin(i), last = list_.end(i); pair < last; ++pair) {
        const std::size_t j = list_.second(pair);
        const NeighbourList::Shift& shift = shifts[list_.image(pair)];
        const Vec2 d{(discs.x[j] + shift.x) - x, (discs.y[j] + shift.y) - y};
        const double square = dot(d, d), radii = radius + shapes_.radius[j];
        Mode& mode = contacts_.mode[pair];
        const double within = radii + reach(law_);
        if (square >= within * within && !contacts_.act(pair)) continue;
        Touch touch{d, {(v.x[j] + shift.vx) - v.x[i], v.y[j] - v.y[i]}, std::sqrt(square), radii};
        // A pair at exactly the reach is out of it: a contact begins and ends with its overlap.
        if (touch.x.deformation == -reach(law_)) touch.x.deformation = out_of_reach();
        const auto memory = std::span{contacts_.memory}.subspan(pair * L::memory_size, L::memory_size);
        double largest = 0.0;
        if constexpr (loses_by_memory) largest = memory[0];
        talus::update_mode(law_, memory, touch.x, mode, [&](double energy) { released += energy; });
        if constexpr (loses_by_memory) {
          if (memory[0] > largest) lost += law_.hysteresis_loss(memory[0]) - law_.hysteresis_loss(largest);
        }
        const LawForce force = mode == 0 ? LawForce{} : law_(touch.x, memory, mode);
        Push push{.force = force.total() * touch.n};
        if constexpr (turns) apply_friction(discs, v, {i, j, pair}, touch, force.total(), powers, push);
        if (mode == 0) continue;
        if (shapes_.wall[i] != DiscShapes::free) wall_forces_[shapes_.wall[i]] -= push.force;
        if (shapes_.wall[j] != DiscShapes::free) wall_forces_[shapes_.wall[j]] += push.force;
        if constexpr (!loses_by_memory) power += force.dissipative * touch.x.deformation_rate;
        act(i, j, push);
      }
    }
    powers[static_cast<std::size_t>(L::dissipation)] += power;
  }

  struct PairOfDiscs {
    std::size_t a, b, pair;
  };
  /// Limits the stretch of the friction spring (return mapping) and adds its force to the push, and to `powers` the
  /// power [F L/T] that a changing stiffness dissipates.
  void apply_friction(Discs& discs, const Velocities& v, PairOfDiscs of, const Touch& touch, double normal,
                      std::array<double, mechanism_count>& powers, Push& push) {
    Mode& mode = contacts_.friction_mode[of.pair];
    double& stretch = contacts_.stretch[of.pair];
    const CoulombFriction friction = friction_.at(touch.x.deformation);
    push.arm_a = arm(of.a, touch), push.arm_b = arm(of.b, touch);
    if (mode == CoulombFriction::open && normal > 0.0 && touch.x.deformation_rate > 0.0) {
      const double slip = slip_rate(touch, push.arm_a, v.spin[of.a], push.arm_b, v.spin[of.b]);
      const double slipped = F::onset * slip * std::max(touch.x.deformation, 0.0) / touch.x.deformation_rate;
      stretch = friction.initial_stretch(slipped, normal);
    }
    const auto settled = friction.return_mapping(stretch, normal);
    mode = settled.mode, stretch = settled.stretch;
    discs.work[static_cast<std::size_t>(Mechanism::friction)] += settled.dissipated;
    if constexpr (has_varying_stiffness<F>) {
      if (mode != CoulombFriction::open)
        powers[static_cast<std::size_t>(Mechanism::friction)] += friction_.area_power(stretch, touch.x);
    }
    push.friction = friction(stretch, normal);
    push.force -= push.friction * cross(1.0, touch.n);
  }

  /// Acceleration of a wall with a mass, along y [L/T^2].
  double wall_acceleration(std::size_t wall) const {
    const DiscWall& moved = shapes_.walls[wall - 1];
    return wall_forces_[wall].y / moved.mass - moved.gravity;
  }

  /// Rebuilds the list of pairs and carries the contact data over to it.
  void rebuild(Discs& discs) {
    wrap(list_.box(), discs);
    const List old = list_;
    const Contacts were = std::move(contacts_);
    list_.build(shapes_, discs);
    ++builds_;
    contacts_ = Contacts{list_.size()};
    if (were.mode.empty()) return;
    for (std::size_t i = 0; i < old.discs(); ++i) {
      for (std::size_t was = old.begin(i); was < old.end(i); ++was) {
        if (!were.act(was)) continue;
        // A contact that acted was closed one step ago, and has separated by less than the skin since.
        const std::size_t is = list_.find(i, old.second(was));
        if (is < list_.size()) contacts_.take(is, were, was);
      }
    }
  }

  DiscShapes shapes_;
  L law_;
  F friction_;
  List list_;
  Contacts contacts_;
  std::vector<Vec2> wall_forces_;                   ///< by wall number; [0] is no wall
  std::vector<std::size_t> moved_;                  ///< discs of walls with a mass
  std::vector<double> old_vx_, old_vy_, old_spin_;  ///< before the kick
  long builds_{};
  long evaluations_{};
};

}  // namespace talus
