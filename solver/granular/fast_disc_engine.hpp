#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solver/base/huge_pages.hpp"
#include "solver/base/thread_pool.hpp"
#include "solver/base/vec.hpp"
#include "solver/granular/discs.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/granular/sweep_input.hpp"
#include "solver/granular/swept_pairs.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// The engine of FastDiscSystem: everything except the law.
///
/// Bit-identity with DiscSystem. A velocity is a sum of impulses, and its rounding depends on their order. In both
/// systems that is the order of the pairs: by the index of the first disc, then of the second. Everything else is
/// computed for each pair, or each disc, separately and by the same expressions. Rounding then does not depend on
/// whether this is done one by one or in SIMD lanes, by which thread, and how many pairs that do not touch are checked.
///
/// Performance.
/// 1. One sweep per step. The first disc of a pair has the smaller index. Once the pairs of all first discs < i are
///    done, no later pair uses the position of a disc < i or applies a force to it: it can be moved while it is still
///    in the cache. There are no arrays of forces: impulses are added to the velocities of the pairs that touch, a
///    tenth of all. (Friction springs are stretched with the velocities after the kick at the positions before the
///    drift, so discs that turn are moved in a separate pass.)
/// 2. Three lists. The neighbour list reaches far and is rarely rebuilt. The near list contains those of its pairs
///    whose surface gap is below s. It is valid until sum w = s, where w = 2 v_max h bounds the approach of a pair in a
///    step, with velocities relative to the mean flow that neighbours share (NeighbourList::approach). Checking a near
///    pair costs 1 in each step; checking a listed pair costs c each time the near list is built, every s/w steps. With
///    T pairs that touch, rho s near ones beside them and P listed ones, the cost per step is smallest for
///        d/ds (T + rho s + c P w/s) = 0,   s = sqrt(c P w/rho).
///    Where this would save little, as in jammed states, all listed pairs count as near, and no near list is built.
///    The third list contains the near pairs that touch, found in each step; the law is evaluated for these only.
/// 3. SIMD lanes. Gaps, contacts and forces are computed for four pairs at a time. The two coordinates of a disc are
///    adjacent and are loaded together. A pair across a border has a ghost as second disc: an additional position, that
///    of the disc's image.
/// 4. Contact memory only for pairs that touch, as a list in the order of the pairs. A sweep finds the touching pairs
///    in this order and traverses the list alongside. A pair that is not in it is a new contact.
/// 5. Neighbouring discs with neighbouring indices, as order_by_rows() and reordered() of disc_order.hpp provide them.
///
/// Threads. Each has a stripe of discs with consecutive indices, and the pairs whose first disc is one of them. The few
/// of these whose second disc belongs to a later stripe, the outgoing pairs, come first: their forces are evaluated
/// while no disc moves. Then each thread applies to its discs the forces from earlier stripes, whose first discs have
/// smaller indices than all of its discs. Then it sweeps the pairs inside its stripe, and applies the impulses of the
/// outgoing pairs to their first discs at their position in the order of pairs. Each velocity is thus the same sum as
/// with one thread. All threads also build the lists.
///
/// Errors: InputError for zero threads; functions that list pairs have the errors of NeighbourList::build.
class FastDiscEngine {
 public:
  virtual ~FastDiscEngine() = default;

  const DiscShapes& shapes() const { return shapes_; }
  const NeighbourList& list() const { return list_; }
  long builds() const { return builds_; }
  /// Number of times that the near list was built.
  long prunings() const { return prunings_; }
  long evaluations() const { return evaluations_; }
  /// Sum of the contact forces on a wall at the last evaluation [F].
  Vec2 wall_force(std::size_t wall) const { return wall_forces_[wall]; }

  /// To be called before begin(): Discs::work then receives the energy dissipated by dashpots and friction, as in
  /// DiscSystem. Runs take up to 1.5 times as long where most pairs touch.
  void keep_work() {
    kinds_.power = !traits_.has_history && traits_.needs_rate;
    kinds_.normal = traits_.turns || kinds_.power;
    kinds_.friction_work = traits_.turns;
    kinds_.area_power = traits_.changes_stiffness;
  }

  /// Initializes before the first step; contacts that exist already start without history.
  void begin(Discs& discs);
  /// Applies the impulses of all forces over h, which must not be 0.
  void kick(Discs& discs, double h);
  /// Moves all discs with their velocities, and adds the slip to the stretch of the friction springs.
  void drift(Discs& discs, double h);
  /// A copy of the discs, moved with their velocities over h; contacts are not updated.
  Discs drifted(const Discs& discs, double h) const { return talus::drifted(discs, list_.box().sliding(), h); }
  /// Updates the contact memories, and sums the accelerations and the dissipated powers.
  void evaluate(Discs& discs, DiscRates& out);
  void update_modes(Discs& discs);
  /// Performs kick() and drift() `steps` times, the steps of EulerCromer and CentralDifference, and advances the time.
  /// Calls after() after each step: position() then returns the position of a disc, wall_force() the contact force on a
  /// wall.
  template <class After>
  void advance(Discs& discs, double h, long steps, After&& after);
  void advance(Discs& discs, double h, long steps) {
    advance(discs, h, steps, [] {});
  }
  /// Position of a disc during advance() [L].
  Vec2 position(std::size_t disc) const { return {positions_[2 * disc], positions_[2 * disc + 1]}; }

  /// Energy that contacts of a history-dependent law have lost so far [F L]; 0 for other laws. (Its sum rounds
  /// differently from DiscSystem's work.)
  double lost() const;

  /// Serializes what a run of these discs carries from step to step besides their state. When loading, `discs` must
  /// already be restored.
  void serialize(Archive& archive, const Discs& discs);

 protected:
  /// Properties of the contact law and its friction.
  struct Traits {
    bool has_history{};        ///< the law has memory: the largest overlap
    bool turns{};              ///< friction turns the discs
    bool changes_stiffness{};  ///< the stiffness of friction depends on the overlap
    bool needs_rate{};         ///< the law's force depends on the rate of overlap
    double reach{};            ///< largest gap of the surfaces at which it acts [L]
    Mechanism dissipation{}, release{};
  };

  /// skin [L] > 0: how far the neighbour list reaches beyond the law's reach. threads >= 1: used by advance();
  /// worthwhile from a few thousand discs on, if these are numbered by rows.
  FastDiscEngine(const Traits& traits, DiscShapes shapes, PeriodicBox box, double skin, std::size_t threads);
  FastDiscEngine(const FastDiscEngine&) = default;
  FastDiscEngine(FastDiscEngine&&) = default;
  FastDiscEngine& operator=(const FastDiscEngine&) = default;
  FastDiscEngine& operator=(FastDiscEngine&&) = default;

  /// The stages of a sweep in which the law and its friction act (step_block.hpp).
  virtual void evaluate_pair_forces(const StepBlock& sweep, PairForces& pushes) const = 0;
  virtual double kick_and_drift(const StepBlock& sweep) const = 0;
  virtual void stretch_contacts(const StepBlock& sweep) const = 0;
  /// Loss of a contact of a history-dependent law, by its largest overlap; 0 for other laws [F L].
  virtual double hysteresis_loss(double largest) const = 0;
  /// Energy of the friction spring of surfaces that have separated, at a stretch [F L].
  virtual double friction_energy(double stretch) const = 0;

  /// Calls visit(first, second, shift of the second's image, memory), in order, for each pair that touched at the last
  /// evaluation; shifts are those of the present `discs`.
  template <class Visit>
  void for_each_touching_pair(const Discs& discs, Visit&& visit) const;

 private:
  /// Near pairs and their contacts.
  struct Swept {
    SweptPairs near;
    SweptContacts contacts;
  };
  /// Discs of one thread and the pairs of which they are the first disc.
  struct Stripe {
    std::size_t begin{}, end{};
    std::size_t first_ghost{}, end_of_ghosts{};
    Swept own, outgoing;                         ///< pairs with both discs in the stripe; with only the first
    PairForces pushes;                           ///< forces of the outgoing pairs
    std::vector<EndedContact> ended;             ///< contacts ended since accumulate_ledger()
    std::vector<std::vector<Vec2>> wall_forces;  ///< by wall number, [0] is no wall: forces of its contacts [F]
    double fastest{};                            ///< largest squared speed relative to the mean flow [L^2/T^2]
  };
  /// A contact carried over from one list to the next.
  struct Kept {
    std::uint32_t first{}, second{};
    ContactMemory memory;
  };

  /// Calls work(stripe) for each stripe, in parallel if there are several.
  template <class Work>
  void each(Work&& work);
  void sweep(double kick, double drift);
  void begin_kick();
  double sweep_pairs(double kick, double drift);
  void copy_before(Stripe& stripe);
  void find_outgoing(Stripe& stripe);
  void kick_walls(double kick);
  double drift_walls(double drift);
  void accumulate_ledger();
  StepBlock work(Stripe& stripe, bool kicks, double drift);
  void end_drift(Discs& discs, double h);
  void load(const Discs& discs);
  void store(Discs& discs);
  void set_ghosts(Stripe& stripe, double* numbers, double NeighbourList::Shift::*along);
  void rebuild(Discs& discs);
  std::vector<Kept> kept_contacts() const;
  void take_contacts(const std::vector<Kept>& kept);
  void list_stripes();
  void list_positions();
  void number_as_listed();
  void prune();
  void prune(Stripe& stripe);
  bool choose_reach();
  const SweptPairs& pairs(const Swept& swept) const { return all_near_ ? pairs_ : swept.near; }
  /// The pairs to which the indices of the last sweep's contacts refer.
  const SweptPairs& numbered(const Swept& swept) const { return swept.contacts.now.as_listed ? pairs_ : pairs(swept); }
  /// Calls visit(contacts, index among them, index of the pair in the whole list) in the order of pairs.
  template <class Visit>
  void for_each_touching(Visit&& visit) const;
  /// The disc whose position, or whose image's position, begins at this index.
  std::uint32_t disc(std::uint32_t at) const {
    return at < velocities_.size() ? at / 2 : ghost_disc_[(at - velocities_.size()) / 2];
  }
  bool sees_rates() const { return traits_.turns || traits_.needs_rate; }

  static constexpr double round_off = 1e-9;  ///< rounding allowance of summed displacements, over a reach

  Traits traits_;
  DiscShapes shapes_;
  NeighbourList list_;
  double skin_;
  double equal_radii_{};  ///< sum of two radii if all are equal, else 0 [L]
  bool equal_masses_{};
  std::size_t first_wall_{};               ///< no disc before this one belongs to a wall
  std::vector<double> per_mass_;           ///< of discs that turn: 1/(inertia of a solid disc) over 1/mass [1/L^2]
  double kicked_{};                        ///< duration of the last kick [T]
  std::vector<double> impulse_per_force_;  ///< kicked_/mass: two values per disc, or two in all for equal masses [T/M]
  std::vector<WallDiscs> moved_;           ///< discs of walls with a mass

  /// Values of discs, which each step traverses.
  using Numbers = std::vector<double, HugePages<double>>;
  Numbers positions_;              ///< x, y of the discs, of their ghosts and of one padding entry (NaN) [L]
  Numbers velocities_, spins_;     ///< of the discs [L/T, 1/T]
  Numbers rates_, spin_rates_;     ///< of evaluate() [L/T^2, 1/T^2]
  Numbers before_, spins_before_;  ///< if sees_rates(): before the kick, of discs and ghosts; spins
  std::vector<std::uint32_t> ghost_disc_;
  std::vector<std::uint8_t> ghost_image_;
  std::array<NeighbourList::Shift, NeighbourList::images> shifts_{};
  double shear_displacement_{};  ///< Discs::shear_displacement
  SweptContacts::Kinds kinds_;
  std::array<double, mechanism_count> work_{};  ///< Discs::work
  double power_{}, friction_power_{};           ///< of dashpots, and area_power, at the last evaluation [F L/T]

  SweptPairs pairs_;             ///< all listed pairs
  std::vector<Stripe> stripes_;  ///< one for each thread
  ThreadPool* pool_{};           ///< during advance() with several threads, else null
  bool all_near_{};              ///< all listed pairs count as near
  double reach_{};               ///< s, reach of the near list beyond contact [L]
  double used_{};                ///< used part of s [L]
  double approach_{};            ///< bound of the approach of any pair in the last step [L]

  double lost_{};  ///< loss of contacts that have ended [F L]
  std::vector<EndedContact> ended_;
  std::vector<Vec2> wall_forces_;  ///< by wall number; [0] is no wall
  long builds_{}, prunings_{}, evaluations_{};
};

template <class Work>
void FastDiscEngine::each(Work&& work) {
  if (pool_ != nullptr) {
    pool_->each([&](std::size_t k) { work(stripes_[k]); });
  } else {
    for (Stripe& stripe : stripes_)
      work(stripe);
  }
}

template <class After>
void FastDiscEngine::advance(Discs& discs, double h, long steps, After&& after) {
  load(discs);
  std::optional<ThreadPool> pool;
  if (stripes_.size() > 1) pool_ = &pool.emplace(stripes_.size());
  const struct Leave {
    ThreadPool*& pool;
    ~Leave() { pool = nullptr; }
  } leave{pool_};
  for (long n = 0; n < steps; ++n) {
    sweep(h, h);
    end_drift(discs, h);
    discs.t += h;
    after();
  }
  store(discs);
}

template <class Visit>
void FastDiscEngine::for_each_touching_pair(const Discs& discs, Visit&& visit) const {
  std::array<NeighbourList::Shift, NeighbourList::images> shifts;
  list_.shifts(discs.shear_displacement, shifts);
  for_each_touching([&](const SweptContacts& contacts, std::size_t t, std::size_t pair) {
    visit(std::size_t{disc(pairs_.first[pair])}, std::size_t{disc(pairs_.second[pair])}, shifts[list_.image(pair)],
          contacts.memory(contacts.now, t));
  });
}

template <class Visit>
void FastDiscEngine::for_each_touching(Visit&& visit) const {
  for (const Stripe& stripe : stripes_) {
    const SweptContacts &own = stripe.own.contacts, &outgoing = stripe.outgoing.contacts;
    const SweptPairs &of_own = numbered(stripe.own), &of_outgoing = numbered(stripe.outgoing);
    std::size_t out = 0;
    const auto visit_outgoing = [&](std::size_t before) {
      for (; out < outgoing.now.count && of_outgoing.number_in_list(outgoing.now.pair[out]) < before; ++out)
        visit(outgoing, out, of_outgoing.number_in_list(outgoing.now.pair[out]));
    };
    for (std::size_t t = 0; t < own.now.count; ++t) {
      const std::size_t pair = of_own.number_in_list(own.now.pair[t]);
      visit_outgoing(pair);
      visit(own, t, pair);
    }
    visit_outgoing(list_.size());
  }
}

}  // namespace talus
