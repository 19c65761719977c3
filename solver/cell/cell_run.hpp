#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "solver/cell/block_means.hpp"
#include "solver/cell/cell_plan.hpp"
#include "solver/cell/cell_profile.hpp"
#include "solver/cell/shear_cell.hpp"
#include "solver/granular/disc_method.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/virtual_discs.hpp"

namespace talus {

/// What is averaged of a cell. Stresses as ShearCell::overburden() [F/L^2]; shear is positive where the block is
/// dragged against its speed; virials are those stresses times the depth between the centre lines [F/L].
enum class CellQuantity : std::size_t {
  top_shear,     ///< S on the block
  top_normal,    ///< N
  bottom_shear,  ///< on the base
  bottom_normal,
  top_moment,    ///< S of the block times the height of its centre line over the base's [F/L]
  depth,         ///< [L]
  depth_square,  ///< [L^2]
  solid_fraction,
  touching,      ///< 1 while any contact acts, else 0
  coordination,  ///< contacts that act of a free disc
  contacts,      ///< contacts that act
  multiple,      ///< those of which a free disc has another
  shear_virial,  ///< of all contacts
  multiple_shear_virial,
  normal_virial,
  multiple_normal_virial,
  kinetic_shear,  ///< the same of momentum carried by the discs [F/L]
  sliding,        ///< contacts whose friction is at its limit
  spin,           ///< mean of the free discs, counter-clockwise > 0 [1/T]
  count,
};

/// A shear cell on its way, with what is measured of it. Contacts act while their force is not zero.
class CellRun {
 public:
  template <class L, class F>
  using ByVirtualDiscs = DiscSystem<L, F, VirtualDiscs>;
  template <class List>
  struct SystemsOf;
  template <class... L>
  struct SystemsOf<LawList<L...>> {
    using Variant = std::variant<FastDiscSystem<L>..., FastDiscSystem<L, CoulombFriction>...,
                                 ByVirtualDiscs<L, Frictionless>..., ByVirtualDiscs<L, CoulombFriction>...>;
  };
  /// With the cell's law and friction.
  using System = SystemsOf<DiscLaws>::Variant;

  /// Blocks of time in a run by which errors are told, and those at its start that no mean counts.
  static constexpr std::size_t blocks = 100, start_up = 25;
  /// Limits that a flow of hard discs keeps: all space that equal discs can fill, and a tenth of a diameter of overlap.
  /// Beyond them a run goes on, until discs pass through each other.
  static constexpr double fullest = 0.9069, deepest = 0.1;
  /// Share of the work that a step of a leapfrog that is short enough leaves unaccounted for at most.
  static constexpr double most_unaccounted = 0.01;

  /// Errors: InputError for the first of the validation_errors.
  CellRun(const ShearCell& cell, const CellPlan& plan);
  /// The same from discs that are there already.
  CellRun(const ShearCell& cell, const CellPlan& plan, FilledCell start);

  /// Goes on to the next sample or output: half a contact time, or a LOOP if that is shorter, if that is not less than
  /// a step; or to the last sample for as long as nothing can touch.
  void advance();
  bool finished() const { return steps_ >= last_step_; }
  /// Whether something is to be written after this step: each LOOP, and at the end.
  bool due() const { return due_; }
  /// Why the run cannot go on; empty while it can.
  const std::string& failure() const { return failure_; }

  const ShearCell& cell() const { return cell_; }
  const CellPlan& plan() const { return plan_; }
  const FilledCell& start() const { return start_; }
  /// Force evaluations so far.
  long evaluations() const;
  /// Sum of the contact forces on a wall at the last evaluation [F].
  Vec2 wall_force(std::size_t wall) const;
  long steps() const { return steps_; }
  long last_step() const { return last_step_; }
  /// Steps that were passed at once.
  long jumped() const { return jumped_; }
  /// Discs, velocities of their time.
  Discs discs();

  /// Mean of a quantity after the start-up.
  Estimate mean(CellQuantity quantity) const;
  /// Mean of one over mean of the other.
  Estimate ratio(CellQuantity over, CellQuantity under) const;
  /// What is made of means: of(mean), with mean(quantity).
  template <class Of>
  Estimate estimate(Of&& of) const {
    return means_.estimate(start_up, [&](const BlockMeans::Means& means) {
      return of([&](CellQuantity quantity) { return means(static_cast<std::size_t>(quantity)); });
    });
  }
  /// Time at which it began [T]: other than 0 of one that goes on from discs that were there.
  double began() const { return began_; }
  /// LOOPs that have ended, or in which the run failed, and the mean of a quantity in one of them, start-up or not.
  std::size_t intervals() const;
  /// Whether there is one: a last LOOP may be too short for a step.
  bool interval_seen(std::size_t interval) const { return intervals_.seen(interval); }
  double interval_mean(std::size_t interval, CellQuantity quantity) const;
  /// How much the mean of the later half of what has been run after the start-up differs from that of the earlier, in
  /// standard errors of the difference; 0 while that is less than 16 blocks.
  double drift(CellQuantity quantity) const;
  const CellProfile& profile() const { return profile_; }
  double largest_overlap() const { return largest_overlap_; }  ///< [L]
  double largest_fraction() const { return largest_fraction_; }

  /// Where the energy is and has gone [F L], from the start on.
  struct Ledger {
    double kinetic{}, potential{}, stored{};  ///< now; kinetic also of spin, potential of the block
    double driven{};                          ///< work of what drives the block
    double dissipated{};                      ///< by contacts
    double rubbed{};                          ///< of it by friction
    /// What is there now.
    double held() const { return kinetic + potential + stored; }
    double gained{};  ///< what is there and what was kept, less what was put in: zero but for the method's error
    /// The larger of what was put in and what was kept; the share of it that was gained.
    double work() const { return std::max(std::abs(driven), dissipated); }
    double unaccounted() const { return work() > 0.0 ? gained / work() : 0.0; }
  };
  Ledger ledger();
  /// A contact whose force is not zero.
  struct ActingContact : DiscContact {
    bool multiple{};  ///< one of its free discs has another
    bool sliding{};   ///< its friction is at its limit
  };
  std::vector<ActingContact> acting_contacts() const;
  /// Impulses of the discs on the block and the base so far [F T].
  Vec2 impulse_on_block() const { return on_block_; }
  Vec2 impulse_on_base() const { return on_base_; }

  /// Names all that goes from one step to the next.
  void serialize(Archive& archive);

 private:
  static constexpr std::size_t quantities = static_cast<std::size_t>(CellQuantity::count);
  using Values = std::array<double, quantities>;

  long free_steps() const;
  void jump(long steps);
  void fly(long steps);
  double block_way(long steps) const;
  long next_loop() const;
  long steps_ahead() const;
  void take_steps(long steps);
  /// Forces on the block and the base; height of one over the other [L].
  void add_walls(double time, Vec2 block, Vec2 base, double height);
  void sample(bool flown);
  void look_across(double time);
  long loops_ended(long steps) const;
  Ledger energies();
  void check(double fraction);
  void check_numbers();

  ShearCell cell_;
  CellPlan plan_;
  FilledCell start_;
  System system_;
  DiscMethod method_;
  Discs discs_;
  long steps_{}, last_step_{}, jumped_{};
  bool due_{};
  long sample_every_;
  bool acted_{};      ///< whether contacts did at the last sample: no need to look whether discs can fly
  double waiting_{};  ///< time that the next sample stands for [T]
  Values walls_{};    ///< sums over that time of what is known at each step
  BlockMeans means_;
  BlockMeans intervals_;  ///< one block for each LOOP
  CellProfile profile_;
  double profile_waiting_{};  ///< time that the next look across the field stands for [T]
  long profile_samples_{};    ///< since the last
  double largest_overlap_{}, largest_fraction_{};
  Vec2 on_block_, on_base_;
  double held_at_start_{}, began_{};
  std::string failure_;
};

}  // namespace talus
