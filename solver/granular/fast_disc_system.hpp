#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/base/huge_pages.hpp"
#include "solver/base/vec.hpp"
#include "solver/granular/disc_sweep.hpp"
#include "solver/granular/discs.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/laws/settled.hpp"

namespace talus {

/// Many discs without friction, several times as fast as DiscSystem, its plain twin, and with the same bits: places,
/// velocities, forces on walls and what contacts remember. It keeps no account of work (Discs::work); the twin does.
///
/// How it comes to the same bits. A velocity is a sum of impulses, and rounds as their order says; in both the order is
/// that of the pairs, by the number of the first disc, then of the second. All else is worked out for each pair, or
/// each disc, alone, by the same expressions; whether that is done one by one or eight side by side, and how many of
/// the pairs that do not touch are looked at, rounds nothing.
///
/// What makes it fast.
/// 1. One sweep a step. The first of a pair has the smaller number. So once the pairs of first discs < i are done,
///    nobody asks for the place of a disc < i any more, and nobody pushes it: it can move on while it is still in the
///    cache. There are no arrays of forces: impulses go to the velocities of the pairs that touch, a tenth of all.
/// 2. Three lists. The neighbour list reaches far and lasts long. Of it the near list takes the pairs whose surfaces
///    are less than s apart; it holds until sum w = s, where no pair comes nearer by more than w = 2 v_max h in a step,
///    with velocities from the mean flow that neighbours share (NeighbourList::approach). Looking at a near pair costs
///    1 each step, at a listed pair c each time that the near list is made, every s/w steps. With rho s near pairs and
///    P listed ones that is least for
///        d/ds (rho s + c P w/s) = 0,   s = sqrt(c P w/rho).
///    Where that would save little, as in jammed states, all listed pairs are near, and no near list is made. Of the
///    near pairs each step takes those that touch, of which alone the law is asked.
/// 3. Lanes. Whether pairs are near, touch, and how they push is worked out eight pairs at a time; the two coordinates
///    of a disc lie side by side and are fetched at once. Pairs across a border have a ghost as second disc: one more
///    place, that of the disc's image.
/// 4. Discs whose neighbours have neighbouring numbers: order_by_rows() and reordered() of disc_order.hpp give them.
///
/// What a contact remembers, its largest overlap, stands beside its listed pair with the number of the last sweep that
/// found it touching: if that is not the sweep before, the contact is a new one. So pairs that part need no visit.
///
/// Errors of all that lists pairs: InputError of NeighbourList::build.
template <SettledLaw L>
class FastDiscSystem {
 public:
  /// skin [L] > 0: how far beyond contact the neighbour list reaches.
  FastDiscSystem(DiscShapes shapes, PeriodicBox box, const L& law, double skin);

  const DiscShapes& shapes() const { return shapes_; }
  const L& law() const { return law_; }
  const NeighbourList& list() const { return list_; }
  long builds() const { return builds_; }
  /// Times that the near list was made.
  long prunings() const { return prunings_; }
  long evaluations() const { return evaluations_; }
  /// Sum of the contact forces on a wall at the last evaluation [F].
  Vec2 wall_force(std::size_t wall) const { return wall_forces_[wall]; }
  /// The same times the step, summed over the steps of the last advance() [F T].
  Vec2 wall_impulse(std::size_t wall) const { return wall_impulses_[wall]; }

  /// Before the first step: contacts that are there have no past.
  void begin(Discs& discs);
  /// Gives all discs the impulses of their forces over h.
  void kick(Discs& discs, double h);
  /// Moves all discs with their velocities.
  void drift(Discs& discs, double h);
  /// So many times kick() and drift(): the steps of EulerCromer and CentralDifference. Takes the time with it.
  void advance(Discs& discs, double h, long steps);

  /// Of a pair by their numbers, whichever first, the largest overlap since the touch that the last evaluation left;
  /// 0 if it does not touch or the law does not remember [L].
  double largest_overlap(std::size_t a, std::size_t b) const;

 private:
  static constexpr bool remembers = L::memory_size == 1;

  template <class T>
  using Array = std::vector<T, HugePages<T>>;

  /// Pairs in order, and behind them as many of places that are nowhere as fill the lanes.
  struct Pairs {
    Array<std::uint32_t> first, second;  ///< where the places begin; of a second disc across a border, its ghost's
    Array<std::uint32_t> listed;         ///< of near pairs of laws that remember: which of the list
    Array<double> radii;                 ///< their sum, if discs are unlike [L]
    std::size_t count{};

    void clear() { first.clear(), second.clear(), listed.clear(), radii.clear(); }
  };

  void sweep(double kick, double drift);
  void begin_kick();
  void end_drift(Discs& discs, double h);
  void load(const Discs& discs);
  void store(Discs& discs) const;
  void place_ghosts();
  void rebuild(Discs& discs);
  void list_places();
  void fill_up(Pairs& pairs);
  void prune();
  bool choose_reach();
  /// The disc that is, or whose image is, at the place that begins there.
  std::uint32_t disc(std::uint32_t at) const {
    return at < velocities_.size() ? at / 2 : ghost_disc_[(at - velocities_.size()) / 2];
  }

  static constexpr double round_off = 1e-9;  ///< share of a reach that sums of ways may be off by

  DiscShapes shapes_;
  L law_;
  NeighbourList list_;
  double skin_;
  double equal_radii_{};  ///< sum of two radii if all are equal, else 0 [L]
  bool equal_masses_{};
  std::vector<std::size_t> moved_;  ///< discs of walls with a mass
  struct Waiting {
    Vec2 place, v;
  };
  std::vector<Waiting> waiting_;  ///< how they are during a sweep

  Array<double> places_;      ///< x, y of the discs, of their ghosts and of nowhere [L]
  Array<double> velocities_;  ///< of the discs [L/T]
  Array<double> before_;      ///< of laws that need rates: velocities of all places before the kick
  std::vector<std::uint32_t> ghost_disc_;
  std::vector<std::uint8_t> ghost_image_;
  std::array<NeighbourList::Shift, NeighbourList::images> shifts_{};
  double slid_{};  ///< Discs::slid

  Pairs pairs_, near_;
  bool all_near_{};  ///< the near list is all pairs
  double reach_{};   ///< s, of the near list beyond contact [L]
  double used_{};    ///< of s [L]
  double way_{};     ///< of the last step: no pair came nearer by more [L]

  Array<DiscContactPast> pasts_;  ///< of each listed pair
  std::uint64_t now_{};           ///< number of the last sweep since the list was made, which counts as the first

  std::vector<Vec2> wall_forces_, wall_impulses_;  ///< the first of no wall
  long builds_{}, prunings_{}, evaluations_{};
};

}  // namespace talus
