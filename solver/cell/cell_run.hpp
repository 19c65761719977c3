#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
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
#include "solver/run/outcome.hpp"

namespace talus {

/// Averaged quantities of a cell. Stresses are defined like ShearCell::overburden() [F/L^2]; shear is positive where it
/// drags the block against its speed; virials are these stresses times the distance of the centre lines of base and
/// block [F/L].
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
  coordination,  ///< acting contacts per free disc
  contacts,      ///< acting contacts
  multiple,      ///< acting contacts of which a free disc has another
  shear_virial,  ///< of all contacts
  multiple_shear_virial,
  normal_virial,
  multiple_normal_virial,
  kinetic_shear,  ///< the same for the momentum carried by moving discs [F/L]
  sliding,        ///< contacts whose friction is at its limit, by the normal force at the end of the step
  spin,           ///< mean of the free discs, counter-clockwise > 0 [1/T]
  count,
};

/// Run of a shear cell, with its measurements. A contact acts while its force is not zero.
class CellRun {
 public:
  template <class L, class F>
  using ByVirtualDiscs = DiscSystem<L, F, VirtualDiscs>;
  /// The systems of discs with a law and friction, if it can have this friction.
  template <class L, class F>
  struct SystemsOf {
    using List = LawList<>;
  };
  template <class L, class F>
  requires CanHaveFriction<L, F>
  struct SystemsOf<L, F> {
    using List = LawList<FastDiscSystem<L, F>, ByVirtualDiscs<L, F>>;
  };
  template <class L, class... F>
  static auto systems_with(LawList<F...>) -> decltype((LawList<>{} + ... + typename SystemsOf<L, F>::List{}));
  template <class... L, class... F>
  static auto systems(LawList<L...>, LawList<F...>)
      -> decltype((LawList<>{} + ... + systems_with<L>(LawList<Frictionless, F...>{})));
  /// System with the cell's law and friction.
  using System = decltype(systems(DiscLaws{}, DiscFrictions{}))::Variant;

  /// Number of blocks of time in a run, for standard errors, and of those at its start that means exclude.
  static constexpr std::size_t blocks = 100, start_up = 25;
  /// Limits of a flow of hard discs: the largest solid fraction of equal discs, and an overlap of 0.1 diameters. A run
  /// beyond them continues until discs pass through each other.
  static constexpr double fullest = 0.9069, deepest = 0.1;
  /// Largest balance error of a leapfrog with a sufficiently small step, as a fraction of the work.
  static constexpr double maximum_balance_error = 0.01;

  /// Errors: InputError for the first of the validation_errors.
  CellRun(const ShearCell& cell, const CellPlan& plan);
  /// The same, starting from existing discs.
  CellRun(const ShearCell& cell, const CellPlan& plan, FilledCell start);

  /// Advances to the next sample or output: by half a contact time, or a LOOP if that is shorter, but at least one
  /// step; or, while nothing can touch, to the last sample before something may.
  void advance();
  bool finished() const { return steps_ >= last_step_; }
  /// Whether output is due after this step: at each LOOP, and at the end.
  bool due() const { return due_; }
  /// Why the run cannot continue; empty while it can.
  const std::string& failure() const { return failure_; }
  /// The outcome of a run that ends here: it is stopped unless it is finished or cannot continue.
  Outcome outcome() const;

  const ShearCell& cell() const { return cell_; }
  const CellPlan& plan() const { return plan_; }
  const FilledCell& start() const { return start_; }
  /// Force evaluations so far.
  long evaluations() const;
  /// Sum of the contact forces on a wall at the last evaluation [F].
  Vec2 wall_force(std::size_t wall) const;
  long steps() const { return steps_; }
  long last_step() const { return last_step_; }
  /// Number of steps that were passed by jumps.
  long jumped() const { return jumped_; }
  /// Discs, with velocities at the time of their positions.
  Discs discs();

  /// Mean of a quantity after the start-up.
  Estimate mean(CellQuantity quantity) const;
  /// Ratio of the means of two quantities.
  Estimate ratio(CellQuantity over, CellQuantity under) const;
  /// Function of means, with its standard error: of(mean), with mean(quantity).
  template <class Of>
  Estimate estimate(Of&& of) const {
    return means_.estimate(start_up, [&](const BlockMeans::Means& means) {
      return of([&](CellQuantity quantity) { return means(static_cast<std::size_t>(quantity)); });
    });
  }
  /// Time at which the run began [T]: 0 unless it started from existing discs.
  double began() const { return began_; }
  /// Number of LOOPs that have ended, or in which the run failed.
  std::size_t intervals() const;
  /// Whether a LOOP has samples: the last one may be shorter than a step.
  bool interval_seen(std::size_t interval) const { return intervals_.seen(interval); }
  /// Mean of a quantity in one LOOP, start-up included.
  double interval_mean(std::size_t interval, CellQuantity quantity) const;
  /// Difference between the means of the later and the earlier half of the run so far, after the start-up, in standard
  /// errors of that difference; 0 if that is less than 16 blocks.
  double drift(CellQuantity quantity) const;
  const CellProfile& profile() const { return profile_; }
  double largest_overlap() const { return largest_overlap_; }  ///< [L]
  double largest_fraction() const { return largest_fraction_; }

  /// Energy balance since the start [F L].
  struct Ledger {
    double kinetic{}, potential{}, stored{};  ///< present values; kinetic includes spin, potential is the block's
    double input{};                           ///< work of the drive on the block
    double dissipated{};                      ///< by contacts
    double friction_work{};                   ///< part of it, by friction
    /// Present energy.
    double held() const { return kinetic + potential + stored; }
    double spurious_gain{};  ///< present + dissipated - input - initial; zero except for the method's error
    /// The larger of input and dissipated energy; the spurious gain over it.
    double work() const { return std::max(std::abs(input), dissipated); }
    double relative_balance_error() const { return work() > 0.0 ? spurious_gain / work() : 0.0; }
  };
  Ledger ledger();
  /// A contact whose force is not zero.
  struct ActingContact : DiscContact {
    bool multiple{};  ///< one of its free discs has another acting contact
    bool sliding{};   ///< its friction is at its limit
  };
  std::vector<ActingContact> acting_contacts() const;
  /// Impulses of the discs on the block and the base so far [F T].
  Vec2 impulse_on_block() const { return on_block_; }
  Vec2 impulse_on_base() const { return on_base_; }

  /// Serializes what a run carries from step to step; not its failure, after which it takes none.
  void serialize(Archive& archive);
  /// Ends the run, as one that has failed.
  void fail(std::string why) { failure_ = std::move(why); }

 private:
  static constexpr std::size_t quantities = static_cast<std::size_t>(CellQuantity::count);
  using Values = std::array<double, quantities>;

  long free_steps() const;
  void jump(long steps);
  void fly(long steps);
  double block_displacement(long steps) const;
  long next_loop() const;
  long steps_ahead() const;
  void take_steps(long steps);
  /// Accumulates forces on the block and the base over a time; height: of the block over the base [L].
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
  bool acted_{};      ///< whether contacts acted at the last sample: jumps are then not considered
  double waiting_{};  ///< time that the next sample represents [T]
  Values walls_{};    ///< sums over that time of the quantities known at each step
  BlockMeans means_;
  BlockMeans intervals_;  ///< one block for each LOOP
  CellProfile profile_;
  double profile_waiting_{};  ///< time that the next sample of the profile represents [T]
  long profile_samples_{};    ///< samples since the last one of the profile
  double largest_overlap_{}, largest_fraction_{};
  Vec2 on_block_, on_base_;
  double energy_at_start_{}, began_{};
  std::string failure_;
};

}  // namespace talus
