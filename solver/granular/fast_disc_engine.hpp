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

/// The engine of FastDiscSystem: all of it but the law.
///
/// How it comes to the same bits. A velocity is a sum of impulses, and rounds as their order says; in both the order is
/// that of the pairs, by the number of the first disc, then of the second. All else is computed for each pair, or
/// each disc, alone, by the same expressions; whether that is done one by one or side by side, by which thread,
/// and how many of the pairs that do not touch are looked at, rounds nothing.
///
/// What makes it fast.
/// 1. One sweep a step. The first of a pair has the smaller number. So once the pairs of first discs < i are done,
///    nobody asks for the place of a disc < i any more, and nobody pushes it: it can move on while it is still in the
///    cache. There are no arrays of forces: impulses go to the velocities of the pairs that touch, a tenth of all.
///    (Friction stretches its springs with the velocities after the kick at the places before the drift, so that discs
///    that turn move in a pass of their own.)
/// 2. Three lists. The neighbour list reaches far and lasts long. Of it the near list takes the pairs whose surfaces
///    are less than s apart; it holds until sum w = s, where no pair comes nearer by more than w = 2 v_max h in a step,
///    with velocities from the mean flow that neighbours share (NeighbourList::approach). Looking at a near pair costs
///    1 each step, at a listed pair c each time that the near list is made, every s/w steps. With T pairs that touch,
///    rho s near ones beside them and P listed ones that is least for
///        d/ds (T + rho s + c P w/s) = 0,   s = sqrt(c P w/rho).
///    Where that would save little, as in jammed states, all listed pairs are near, and no near list is made. Of the
///    near pairs each step takes those that touch, of which alone the law is asked.
/// 3. Lanes. Whether pairs are near, touch, and how they push is computed for four pairs at a time; the two coordinates
///    of a disc lie side by side and are fetched at once. Pairs across a border have a ghost as second disc: one more
///    place, that of the disc's image.
/// 4. Archive of contacts that touch only, as a list in the order of their pairs: a sweep that finds the touching pairs
///    in that order goes along it. A pair that is not in it touches again.
/// 5. Discs whose neighbours have neighbouring numbers: order_by_rows() and reordered() of disc_order.hpp give them.
///
/// Threads. Each has a stripe of discs with numbers that follow each other, and the pairs whose first disc is one of
/// them. Of those the few whose second disc belongs to a later stripe come first: what they do is found while no disc
/// moves. Then each thread gives its discs what comes in from earlier stripes, whose first discs have smaller numbers
/// than all of its own; then it sweeps its own pairs, and gives the first discs of the pairs that go out their
/// impulses where these stand in the order. So each velocity is the same sum as with one thread. Lists are made by all
/// threads, too.
///
/// Errors: InputError without a thread; of all that lists pairs that of NeighbourList::build.
class FastDiscEngine {
 public:
  virtual ~FastDiscEngine() = default;

  const DiscShapes& shapes() const { return shapes_; }
  const NeighbourList& list() const { return list_; }
  long builds() const { return builds_; }
  /// Times that the near list was made.
  long prunings() const { return prunings_; }
  long evaluations() const { return evaluations_; }
  /// Sum of the contact forces on a wall at the last evaluation [F].
  Vec2 wall_force(std::size_t wall) const { return wall_forces_[wall]; }

  /// Before begin(): Discs::work gets what dashpots and friction keep, as the twin's does. It takes up to half as long
  /// again where most pairs touch.
  void keep_work() {
    kinds_.power = !traits_.has_history && traits_.needs_rate;
    kinds_.normal = traits_.turns || kinds_.power;
    kinds_.slid = traits_.turns;
  }

  /// Before the first step: contacts that are there have no past.
  void begin(Discs& discs);
  /// Gives all discs the impulses of their forces over h, which is not 0.
  void kick(Discs& discs, double h);
  /// Moves all discs with their velocities, and stretches the springs of friction with the slip.
  void drift(Discs& discs, double h);
  /// The discs alone, moved so.
  Discs drifted(const Discs& discs, double h) const { return talus::drifted(discs, list_.box().sliding(), h); }
  /// Brings up to date what contacts remember, and sums the accelerations and the powers.
  void evaluate(Discs& discs, DiscRates& out);
  void update_modes(Discs& discs);
  /// So many times kick() and drift(): the steps of EulerCromer and CentralDifference. Takes the time with it. Calls
  /// after() behind each; place() tells it where a disc is, wall_force() what pushed walls.
  template <class After>
  void advance(Discs& discs, double h, long steps, After&& after);
  void advance(Discs& discs, double h, long steps) {
    advance(discs, h, steps, [] {});
  }
  /// During advance() [L].
  Vec2 place(std::size_t disc) const { return {places_[2 * disc], places_[2 * disc + 1]}; }

  /// What contacts of a law that remembers have lost so far [F L]; of others nothing. (Its sum rounds other than the
  /// twin's work.)
  double lost() const;

  /// Names all that a run of these discs carries from step to step besides their state. `discs` are there already.
  void serialize(Archive& archive, const Discs& discs);

 protected:
  /// The law of contacts and their friction.
  struct Traits {
    bool has_history{};  ///< the law has memory: the largest overlap
    bool turns{};        ///< friction turns the discs
    bool needs_rate{};   ///< the rate of overlap has a part in the law's force
    double reach{};      ///< how far apart the surfaces may be where it acts [L]
    Mechanism dissipation{}, release{};
  };

  /// skin [L] > 0: how far beyond the law's reach the neighbour list goes. threads >= 1: of advance(); worth it from
  /// some thousand discs on, numbered by rows.
  FastDiscEngine(const Traits& traits, DiscShapes shapes, PeriodicBox box, double skin, std::size_t threads);
  FastDiscEngine(const FastDiscEngine&) = default;
  FastDiscEngine(FastDiscEngine&&) = default;
  FastDiscEngine& operator=(const FastDiscEngine&) = default;
  FastDiscEngine& operator=(FastDiscEngine&&) = default;

  /// The stages of a sweep in which the law and its friction act (disc_sweep.hpp).
  virtual void evaluate_pair_forces(const StepBlock& sweep, PairForces& pushes) const = 0;
  virtual double kick_and_drift(const StepBlock& sweep) const = 0;
  /// What a contact of a law with memory has lost by its largest overlap; of others 0 [F L].
  virtual double hysteresis_loss(double largest) const = 0;
  /// Energy of the spring of friction at a stretch [F L].
  virtual double friction_energy(double stretch) const = 0;

  /// Calls visit(first, second, shift of the second's image, memory) for each pair that touched at the last evaluation,
  /// in order, as the discs stand now.
  template <class Visit>
  void for_each_touching_pair(const Discs& discs, Visit&& visit) const;

 private:
  /// Near pairs and their contacts.
  struct Swept {
    SweptPairs near;
    SweptContacts contacts;
  };
  /// Discs of one thread and the pairs whose first they are.
  struct Stripe {
    std::size_t begin{}, end{};
    std::size_t first_ghost{}, end_of_ghosts{};
    Swept own, outgoing;                         ///< with both discs of the stripe, or only the first
    PairForces pushes;                           ///< of the outgoing ones
    std::vector<PartedPair> parted;              ///< since what contacts kept was booked
    std::vector<std::vector<Vec2>> wall_pushes;  ///< of each wall, the first of none: of its contacts [F]
    double fastest{};                            ///< square of own speed [L^2/T^2]
  };
  /// A contact between two lists.
  struct Kept {
    std::uint32_t first{}, second{};
    ContactMemory memory;
  };

  /// Calls work(stripe) for each stripe, by its own thread if there are several.
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
  void place_ghosts(Stripe& stripe, double* numbers, double NeighbourList::Shift::*along);
  void rebuild(Discs& discs);
  std::vector<Kept> kept_contacts() const;
  void take_contacts(const std::vector<Kept>& kept);
  void list_stripes();
  void list_places();
  void number_as_listed();
  void prune();
  void prune(Stripe& stripe);
  bool choose_reach();
  const SweptPairs& pairs(const Swept& swept) const { return all_near_ ? pairs_ : swept.near; }
  /// Those by whose numbers the contacts of the last sweep go.
  const SweptPairs& numbered(const Swept& swept) const { return swept.contacts.now.as_listed ? pairs_ : pairs(swept); }
  /// Calls visit(contacts, which of them, number of the pair in the whole list) in the order of pairs.
  template <class Visit>
  void for_each_touching(Visit&& visit) const;
  /// The disc that is, or whose image is, at the place that begins there.
  std::uint32_t disc(std::uint32_t at) const {
    return at < velocities_.size() ? at / 2 : ghost_disc_[(at - velocities_.size()) / 2];
  }
  bool sees_rates() const { return traits_.turns || traits_.needs_rate; }

  static constexpr double round_off = 1e-9;  ///< share of a reach that sums of ways may be off by

  Traits traits_;
  DiscShapes shapes_;
  NeighbourList list_;
  double skin_;
  double equal_radii_{};  ///< sum of two radii if all are equal, else 0 [L]
  bool equal_masses_{};
  std::size_t first_wall_{};               ///< no disc before this one is a wall's
  std::vector<double> per_mass_;           ///< of discs that turn: 1/(inertia of a solid disc) over 1/mass [1/L^2]
  double kicked_{};                        ///< how long the last kick was [T]
  std::vector<double> impulse_per_force_;  ///< of it, twice for each disc, or for all that are equal [T/M]
  std::vector<WallDiscs> moved_;           ///< of walls with a mass

  /// Of discs; they are gone through in each step.
  using Numbers = std::vector<double, HugePages<double>>;
  Numbers places_;                 ///< x, y of the discs, of their ghosts and of nowhere [L]
  Numbers velocities_, spins_;     ///< of the discs [L/T, 1/T]
  Numbers rates_, spin_rates_;     ///< of evaluate() [L/T^2, 1/T^2]
  Numbers before_, spins_before_;  ///< if rates are seen: velocities of all places before the kick; spins
  std::vector<std::uint32_t> ghost_disc_;
  std::vector<std::uint8_t> ghost_image_;
  std::array<NeighbourList::Shift, NeighbourList::images> shifts_{};
  double slid_{};  ///< Discs::slid
  SweptContacts::Kinds kinds_;
  std::array<double, mechanism_count> work_{};  ///< Discs::work
  double power_{};                              ///< of dashpots at the last evaluation [F L/T]

  SweptPairs pairs_;             ///< all listed
  std::vector<Stripe> stripes_;  ///< one for each thread
  ThreadPool* pool_{};           ///< during advance(), of several threads
  bool all_near_{};              ///< the near list is all pairs
  double reach_{};               ///< s, of the near list beyond contact [L]
  double used_{};                ///< of s [L]
  double way_{};                 ///< of the last step: no pair came nearer by more [L]

  double lost_{};  ///< by contacts that have ended [F L]
  std::vector<PartedPair> parted_;
  std::vector<Vec2> wall_forces_;  ///< the first of no wall
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
  list_.shifts(discs.slid, shifts);
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
