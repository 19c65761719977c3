#include "solver/cell/cell_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// Fraction of a LOOP by which a sum of steps may fall short of it and still count as the whole LOOP.
constexpr double whole = CellPlan::round_off;

/// Steps between two samples of the contacts: half a contact time, but at most a LOOP.
long steps_of_sample(const ShearCell& cell, const CellPlan& plan) {
  const double in_loop = std::floor(plan.every / plan.step * (1.0 + whole));
  return std::max(1L, std::lround(std::min(0.5 * cell.contact_time() / plan.step, in_loop)));
}

constexpr long samples_of_look = 8;

/// Number of steps in a time, at least 1; rounding makes errors in the last digits of either harmless.
long steps_in(double time, double step) { return std::max(1L, std::lround(time / step)); }

std::size_t at(CellQuantity quantity) { return static_cast<std::size_t>(quantity); }

/// Excess of a free fall of n steps over n^2/2 g h^2, in units of n/2 g h^2. The coordinates of a staggered method are
/// half a step ahead, and move with the velocity at each step's end.
double free_fall_offset(const IntegratorTraits& method) {
  return method.free_fall_error + (method.is_staggered ? 1.0 : 0.0);
}

CellRun::System system_of(const ShearCell& cell, const CellPlan& plan, const FilledCell& start) {
  const double skin = cell_skin(cell);
  const auto with = [&]<class L, class F>(const L& law, const F& friction) -> CellRun::System {
    if (plan.images == Images::virtual_discs)
      return CellRun::ByVirtualDiscs<L, F>{start.shapes, start.box, law, skin, friction};
    return FastDiscSystem{start.shapes, start.box, law, skin, friction};
  };
  if (!cell.friction) return std::visit([&](const auto& law) { return with(law, Frictionless{}); }, cell.law);
  const auto with_friction = [&]<class L, class F>(const L& law, const F& friction) -> CellRun::System {
    if constexpr (CanHaveFriction<L, F>) return with(law, friction);
    TALUS_DEMAND(false);  // refused by validation_errors()
  };
  return std::visit(with_friction, cell.law, *cell.friction);
}

FilledCell checked(const ShearCell& cell, const CellPlan& plan, FilledCell start) {
  if (const auto found = validation_errors(cell, plan); !found.empty())
    throw InputError{fmt::format("{}: {}", found.front().field, found.front().message)};
  return start;
}

}  // namespace

CellRun::CellRun(const ShearCell& cell, const CellPlan& plan) : CellRun{cell, plan, fill(cell)} {}

CellRun::CellRun(const ShearCell& cell, const CellPlan& plan, FilledCell start)
    : cell_{cell},
      plan_{plan},
      start_{checked(cell, plan, std::move(start))},
      system_{system_of(cell, plan, start_)},
      method_{make_disc_method(plan.integrator)},
      discs_{start_.discs},
      last_step_{steps_in(plan.end, plan.step)},
      sample_every_{steps_of_sample(cell, plan)},
      means_{quantities, plan.end, blocks},
      intervals_{quantities, plan.every * plan.outputs(), static_cast<std::size_t>(plan.outputs())},
      profile_{0.5 * cell.diameter, cell.width(), plan.end * start_up / blocks, plan.end} {
  std::visit(
      [&](auto& method, auto& system) {
        if constexpr (requires { system.keep_work(); }) system.keep_work();
        system.begin(discs_);
        system.update_modes(discs_);  // discs in contact at the start store energy
        method.start(system, discs_, plan_.step);
      },
      method_, system_);
  const Ledger at_start = energies();
  energy_at_start_ = at_start.held() + at_start.dissipated;
  began_ = start_.discs.t;
}

void CellRun::advance() {
  const long free = plan_.jump ? free_steps() : 0, before = steps_;
  if (free > 0)
    jump(free);
  else
    take_steps(steps_ahead());
  due_ = loops_ended(steps_) > loops_ended(before) || finished();
}

Outcome CellRun::outcome() const {
  if (!failure_.empty()) return {Outcome::Kind::diverged, discs_.t, failure_};
  return {finished() ? Outcome::Kind::finished : Outcome::Kind::stopped, discs_.t, {}};
}

/// Steps to the next sample, the next LOOP or the end, whichever is first.
long CellRun::steps_ahead() const {
  return std::min({sample_every_ - steps_ % sample_every_, next_loop() - steps_, last_step_ - steps_});
}

void CellRun::take_steps(long steps) {
  const double h = plan_.step;
  const std::size_t block = first_block_disc(cell_), base = cell_.free_discs();
  const auto go = [&](auto& method, auto& system) {
    const auto accumulate = [&](double height) {
      add_walls(h, system.wall_force(block_wall), system.wall_force(base_wall), height);
    };
    using Method = std::decay_t<decltype(method)>;
    if constexpr (traits_of<Method>.kick_and_drift && requires { system.position(block); }) {
      system.advance(discs_, h, steps, [&] { accumulate(system.position(block).y - system.position(base).y); });
    } else {
      for (long n = 0; n < steps; ++n) {
        method.step(system, discs_, h);
        accumulate(discs_.y[block] - discs_.y[base]);
      }
    }
  };
  std::visit(go, method_, system_);
  steps_ += steps;
  if (steps_ % sample_every_ == 0 || finished()) sample(false);
}

/// Number of LOOPs that end within `steps` steps.
long CellRun::loops_ended(long steps) const {
  return static_cast<long>(static_cast<double>(steps) * plan_.step / plan_.every * (1.0 + whole));
}

/// Number of steps at which the next LOOP has ended.
long CellRun::next_loop() const {
  const double next = static_cast<double>(loops_ended(steps_) + 1) * plan_.every / plan_.step * (1.0 - whole);
  return std::max(steps_ + 1, static_cast<long>(std::ceil(next)));
}

/// Number of steps in which nothing can touch: discs move along straight lines, the block falls freely. The approach of
/// a disc and the block along the line of centres is at most |v| t + G t^2/2 (the exact time is the root of a quartic).
/// Steps are counted from one sample to another: jumps that began where contacts end would give samples a fixed phase
/// relative to the contacts that follow, and too few of these would be sampled.
long CellRun::free_steps() const {
  if (acted_ || steps_ % sample_every_ != 0) return 0;
  const NeighbourList& list =
      std::visit([](const auto& system) -> const NeighbourList& { return system.list(); }, system_);
  const double within = cell_.diameter + std::visit([](const auto& law) { return reach(law); }, cell_.law);
  double time = std::numeric_limits<double>::infinity(), fastest = 0.0;
  for (std::size_t i = 0; i < discs_.size(); ++i)
    fastest = std::max(fastest, norm(Vec2{discs_.vx[i], discs_.vy[i]}));
  list.for_each_pair(discs_, [&](std::size_t i, std::size_t j, std::size_t, Vec2 d, const auto& shift) {
    const Vec2 v{discs_.vx[j] - discs_.vx[i] + shift.vx, discs_.vy[j] - discs_.vy[i]};
    const double gap = norm(d) - within, nearing = -dot(d, v);
    if (!(gap > 0.0)) {
      time = 0.0;
    } else if (j >= first_block_disc(cell_)) {
      const double speed = norm(v);
      time = std::min(time, 2.0 * gap / (speed + std::sqrt(speed * speed + 2.0 * cell_.gravity * gap)));
    } else if (nearing > 0.0) {
      const double room = dot(d, d) - within * within, root = nearing * nearing - dot(v, v) * room;
      if (root >= 0.0) time = std::min(time, room / (nearing + std::sqrt(root)));
    }
  });
  const double left = list.left();
  time = std::min(time, left / (fastest + std::sqrt(fastest * fastest + cell_.gravity * left)));
  const auto free = static_cast<long>(std::clamp(time / plan_.step - 1.0, 0.0, 1e15));
  // The time of a jump is recorded in a single block.
  constexpr long parts = blocks;
  const long next_block = ((steps_ * parts / last_step_ + 1) * last_step_ + parts - 1) / parts;
  return std::min({free, next_loop() - steps_, next_block - steps_, last_step_ - steps_}) / sample_every_ *
         sample_every_;
}

/// Displacement of the freely falling block along y in `steps` steps [L].
double CellRun::block_displacement(long steps) const {
  const auto n = static_cast<double>(steps);
  const double h = plan_.step, fall = 0.5 * cell_.gravity * h * (n + free_fall_offset(traits(method_)));
  return n * h * (discs_.vy.back() - fall);
}

/// Passes `steps` steps at once. The block's height is a parabola in time: Simpson's rule is exact for its mean, and
/// for the mean of its square up to a fourth-order term (apart from half a step, if the number of steps is odd). Discs
/// are sampled at the midpoint of the jump.
void CellRun::jump(long steps) {
  look_across(static_cast<double>(steps_) * plan_.step);  // for the samples before the jump
  const auto height = [&] { return discs_.y[first_block_disc(cell_)] - discs_.y[cell_.free_discs()]; };
  const double sixth = static_cast<double>(steps) * plan_.step / 6.0, first = height();
  const long rest = steps - steps / 2;
  fly(steps / 2);
  const double middle = height(), last = middle + block_displacement(rest);
  add_walls(sixth, {}, {}, first), add_walls(4.0 * sixth, {}, {}, middle), add_walls(sixth, {}, {}, last);
  steps_ += steps;
  jumped_ += steps;
  sample(true);
  fly(rest);
}

/// Moves the discs along straight lines for `steps` steps, and the block along its parabola.
void CellRun::fly(long steps) {
  const double time = static_cast<double>(steps) * plan_.step, speed = discs_.vy.back();
  const auto block = discs_.vy.begin() + static_cast<std::ptrdiff_t>(first_block_disc(cell_));
  std::fill(block, discs_.vy.end(), block_displacement(steps) / time);
  std::visit([&](auto& system) { system.drift(discs_, time); }, system_);
  std::fill(block, discs_.vy.end(), speed - cell_.gravity * time);
  discs_.t += time;
}

/// Accumulates the quantities that are known at each step, with the forces of its evaluation.
void CellRun::add_walls(double time, Vec2 block, Vec2 base, double height) {
  on_block_ += time * block, on_base_ += time * base;
  const double forwards = std::signbit(cell_.block_speed) ? -1.0 : 1.0, area = cell_.width() * cell_.diameter;
  const auto add = [&](CellQuantity quantity, double value) { walls_[at(quantity)] += time * value; };
  add(CellQuantity::top_shear, -forwards * block.x / area);
  add(CellQuantity::top_normal, block.y / area);
  add(CellQuantity::bottom_shear, forwards * base.x / area);
  add(CellQuantity::bottom_normal, -base.y / area);
  add(CellQuantity::top_moment, -forwards * block.x / area * height);
  add(CellQuantity::depth, height - cell_.diameter);
  add(CellQuantity::depth_square, (height - cell_.diameter) * (height - cell_.diameter));
  waiting_ += time;
}

void CellRun::sample(bool flown) {
  Values values;
  for (std::size_t k = 0; k < quantities; ++k)
    values[k] = walls_[k] / waiting_;
  const auto value = [&](CellQuantity quantity) -> double& { return values[at(quantity)]; };
  const double forwards = std::signbit(cell_.block_speed) ? -1.0 : 1.0, area = cell_.width() * cell_.diameter;
  const std::size_t free = cell_.free_discs();
  // Updates contacts that the last drift has begun or ended. A method that ends its steps with an evaluation has
  // already updated them, with other velocities, on which friction depends.
  const auto settle = [&]<class Method>(const Method&, auto& system) {
    if constexpr (!traits_of<Method>.ends_with_evaluation) system.update_modes(discs_);
  };
  std::visit(settle, method_, system_);
  const std::vector<ActingContact> contacts = acting_contacts();
  for (const ActingContact& contact : contacts) {
    const Vec2 force = contact.force_on_b();
    const double rise = contact.distance * contact.n_ab.y / area;
    const double shear = -forwards * force.x * rise, normal = force.y * rise;
    largest_overlap_ = std::max(largest_overlap_, contact.depth);
    value(CellQuantity::shear_virial) += shear, value(CellQuantity::normal_virial) += normal;
    if (contact.multiple) {
      value(CellQuantity::multiple) += 1.0;
      value(CellQuantity::multiple_shear_virial) += shear, value(CellQuantity::multiple_normal_virial) += normal;
    }
    if (contact.sliding) value(CellQuantity::sliding) += 1.0;
    for (const std::size_t disc : {contact.a, contact.b})
      if (disc < free) value(CellQuantity::coordination) += 1.0 / static_cast<double>(free);
  }
  acted_ = !contacts.empty();
  value(CellQuantity::contacts) = static_cast<double>(contacts.size());
  value(CellQuantity::touching) = contacts.empty() ? 0.0 : 1.0;
  for (std::size_t i = 0; i < free; ++i) {
    value(CellQuantity::kinetic_shear) -= forwards * cell_.mass * discs_.vx[i] * discs_.vy[i] / area;
  }
  for (std::size_t i = 0; i < free && cell_.friction; ++i)
    value(CellQuantity::spin) += discs_.spin[i] / static_cast<double>(free);
  const double fraction = solid_fraction(cell_, discs_);
  value(CellQuantity::solid_fraction) = fraction;
  const double time = static_cast<double>(steps_) * plan_.step - 0.5 * waiting_;
  profile_waiting_ += waiting_;
  if (++profile_samples_ >= samples_of_look || flown || finished()) look_across(time), check_numbers();
  means_.add(time, waiting_, values);
  // The last LOOP may be shorter than the time that the last sample represents.
  intervals_.add(finished() ? static_cast<double>(steps_) * plan_.step * (1.0 - whole) : time, waiting_, values);
  walls_ = {};
  waiting_ = 0.0;
  check(fraction);
}

/// Adds the free discs to the profile, for the time since its last sample; only after the start-up.
void CellRun::look_across(double time) {
  if (time >= plan_.end * start_up / blocks && profile_waiting_ > 0.0) {
    const std::size_t free = cell_.free_discs();
    profile_.look(time, profile_waiting_);
    for (std::size_t i = 0; i < free; ++i) {
      profile_.add({.y = discs_.y[i] - discs_.y[free],
                    .vx = discs_.vx[i],
                    .vy = discs_.vy[i],
                    .radius = 0.5 * cell_.diameter,
                    .mass = cell_.mass,
                    .spin = cell_.friction ? discs_.spin[i] : 0.0});
    }
  }
  profile_waiting_ = 0.0;
  profile_samples_ = 0;
}

std::vector<CellRun::ActingContact> CellRun::acting_contacts() const {
  const std::size_t free = cell_.free_discs();
  std::vector<ActingContact> contacts;
  std::vector<int> acting(discs_.size());
  const double coefficient =
      cell_.friction ? std::visit([](const auto& of) { return of.coefficient; }, *cell_.friction) : 0.0;
  const auto add = [&](const DiscContact& contact) {
    if (contact.force == 0.0) return;
    // The stretch at the limit is rounded: the force may lack the last bit of mu N.
    constexpr double rounding = 1e-9;
    const bool sliding =
        cell_.friction && std::abs(contact.friction) >= (1.0 - rounding) * coefficient * std::max(contact.force, 0.0);
    contacts.push_back({contact, false, sliding});
    ++acting[contact.a], ++acting[contact.b];
  };
  std::visit([&](const auto& system) { system.for_each_contact(discs_, add); }, system_);
  for (ActingContact& contact : contacts) {
    for (const std::size_t disc : {contact.a, contact.b})
      contact.multiple = contact.multiple || (disc < free && acting[disc] > 1);
  }
  return contacts;
}

void CellRun::check(double fraction) {
  largest_fraction_ = std::max(largest_fraction_, fraction);
  if (!failure_.empty()) return;
  if (!(fraction > 0.0) || !(fraction < 2.0) || largest_overlap_ > 0.5 * cell_.diameter) {
    failure_ = fmt::format(
        "a solid fraction of {:.4g} and an overlap of {:.3g} diameters: discs pass through each other; "
        "contacts are too soft for speed and load, or the step is too long",
        fraction, largest_overlap_ / cell_.diameter);
  }
}

void CellRun::check_numbers() {
  double sum = 0.0;
  for (const auto* numbers : {&discs_.x, &discs_.y, &discs_.vx, &discs_.vy, &discs_.spin})
    for (const double number : *numbers)
      sum += number * number;
  if (failure_.empty() && !std::isfinite(sum))
    failure_ = "positions or speeds of discs overflow: their initial values are too large, or the step is too long";
}

Discs CellRun::discs() {
  return std::visit(
      [&](auto& method, auto& system) -> Discs { return synchronized(method, system, discs_, plan_.step); }, method_,
      system_);
}

long CellRun::evaluations() const {
  return std::visit([](const auto& system) { return system.evaluations(); }, system_);
}

Vec2 CellRun::wall_force(std::size_t wall) const {
  return std::visit([&](const auto& system) { return system.wall_force(wall); }, system_);
}

Estimate CellRun::mean(CellQuantity quantity) const { return means_.estimate(at(quantity), start_up); }
Estimate CellRun::ratio(CellQuantity over, CellQuantity under) const {
  return means_.ratio(at(over), at(under), start_up);
}

std::size_t CellRun::intervals() const {
  if (finished()) return intervals_.blocks();
  const long ended = loops_ended(steps_);
  const bool has_started =
      static_cast<double>(steps_) * plan_.step > static_cast<double>(ended) * plan_.every * (1.0 + whole);
  return static_cast<std::size_t>(ended) + (!failure_.empty() && has_started ? 1 : 0);
}

double CellRun::interval_mean(std::size_t interval, CellQuantity quantity) const {
  return intervals_.block_mean(interval, at(quantity));
}

double CellRun::drift(CellQuantity quantity) const {
  constexpr std::size_t fewest = 16;  // blocks; with fewer the error itself is not well known
  const std::size_t last = means_.reached();
  if (last < start_up + fewest) return 0.0;
  const std::size_t middle = (start_up + last) / 2;
  const double change = means_.mean(at(quantity), middle, last) - means_.mean(at(quantity), start_up, middle);
  // The mean over half the time has twice the variance of the whole mean, the difference of two such means four times.
  const double error = 2.0 * mean(quantity).error;
  return error > 0.0 ? change / error : 0.0;
}

CellRun::Ledger CellRun::energies() {
  const Discs now = discs();
  Ledger ledger;
  ledger.kinetic = 0.5 * cell_.block_mass * now.vy.back() * now.vy.back();
  for (std::size_t i = 0; i < cell_.free_discs(); ++i)
    ledger.kinetic += 0.5 * cell_.mass * (now.vx[i] * now.vx[i] + now.vy[i] * now.vy[i]);
  const double inertia = 0.125 * cell_.mass * cell_.diameter * cell_.diameter;
  for (std::size_t i = 0; i < cell_.free_discs() && cell_.friction; ++i)
    ledger.kinetic += 0.5 * inertia * now.spin[i] * now.spin[i];
  ledger.potential = cell_.block_mass * cell_.gravity * now.y[first_block_disc(cell_)];
  ledger.friction_work = now.work[static_cast<std::size_t>(Mechanism::friction)];
  ledger.dissipated = now.dissipated();
  const auto look = [&](const auto& system) {
    system.for_each_contact(now, [&](const DiscContact& contact) { ledger.stored += contact.stored; });
    if constexpr (requires { system.lost(); }) ledger.dissipated += system.lost();
  };
  std::visit(look, system_);
  return ledger;
}

CellRun::Ledger CellRun::ledger() {
  Ledger ledger = energies();
  // The block's speed is constant, so the work of the drive is its impulse times that speed.
  ledger.input = -on_block_.x * cell_.block_speed;
  ledger.spurious_gain = ledger.held() + ledger.dissipated - ledger.input - energy_at_start_;
  return ledger;
}

void CellRun::serialize(Archive& archive) {
  using talus::serialize;
  archive.scope("discs", [&] { serialize(archive, discs_); });
  archive.scope("system", [&] { std::visit([&](auto& system) { system.serialize(archive, discs_); }, system_); });
  archive.scope("method", [&] { std::visit([&](auto& method) { method.serialize(archive, discs_); }, method_); });
  archive.count("steps", steps_), archive.count("jumped", jumped_);
  archive.number("waiting", waiting_);
  archive.number("profile_waiting", profile_waiting_), archive.count("profile_samples", profile_samples_);
  archive.numbers("walls", walls_);
  archive.scope("means", [&] { means_.serialize(archive); });
  archive.scope("intervals", [&] { intervals_.serialize(archive); });
  archive.scope("profile", [&] { profile_.serialize(archive); });
  archive.number("largest_overlap", largest_overlap_), archive.number("largest_fraction", largest_fraction_);
  archive.vector("on_block", on_block_), archive.vector("on_base", on_base_);
  archive.number("energy_at_start", energy_at_start_), archive.number("start_time", began_);
}

}  // namespace talus
