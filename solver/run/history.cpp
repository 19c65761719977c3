#include "solver/run/history.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"

namespace talus {
namespace {

bool turns(const Body& body) { return talus::turns(body.mobility); }

std::vector<Column> motion_columns(const Model& model) {
  std::vector<Column> found{{"time", dimension::time}};
  for (const Body& body : model.bodies) {
    if (body.mobility == Mobility::fixed) continue;
    found.push_back({body.name + ".x", dimension::length});
    found.push_back({body.name + ".y", dimension::length});
    found.push_back({body.name + ".vx", dimension::velocity});
    found.push_back({body.name + ".vy", dimension::velocity});
    if (!turns(body)) continue;
    found.push_back({body.name + ".angle", dimension::angle});
    found.push_back({body.name + ".spin", dimension::angular_velocity});
  }
  for (const Contact& contact : model.contacts) {
    found.push_back({contact.name + ".overlap", dimension::length});
    found.push_back({contact.name + ".force", dimension::force});
  }
  for (const Cable& cable : model.cables) {
    found.push_back({cable.name + ".elongation", dimension::length});
    found.push_back({cable.name + ".tension", dimension::force});
  }
  return found;
}

void add_account_columns(std::vector<Column>& found) {
  for (const std::string_view part : {"kinetic", "gravity", "applied", "contacts", "cables"}) {
    found.push_back({fmt::format("energy.{}", part), dimension::energy});
  }
  for (const std::string_view mechanism : Names<Mechanism>::list) {
    found.push_back({fmt::format("dissipated.{}", mechanism), dimension::energy});
  }
  found.push_back({"balance_error.energy", dimension::energy});
  found.push_back({"balance_error.momentum_x", dimension::momentum});
  found.push_back({"balance_error.momentum_y", dimension::momentum});
  found.push_back({"balance_error.angular_momentum", dimension::angular_momentum});
}

}  // namespace

std::vector<Column> history_columns(const Model& model, bool ledger) {
  std::vector<Column> found = motion_columns(model);
  if (ledger) add_account_columns(found);
  return found;
}

void History::proceed() {
  if (row_of_stop) rows.pop_back();
  row_of_stop = false;
}

void History::add(std::vector<double> row, bool due) {
  rows.push_back(std::move(row));
  row_of_stop = !due;
}

void History::serialize(Archive& archive) {
  archive.flag("row_of_stop", row_of_stop);
  std::vector<double> numbers;
  for (const std::vector<double>& row : rows)
    numbers.insert(numbers.end(), row.begin(), row.end());
  archive.list("rows", numbers);
  if (!archive.is_loading()) return;
  if (numbers.size() % columns.size() != 0) {
    throw InputError{
        fmt::format("rows: found {} numbers; it must be whole rows of {}", numbers.size(), columns.size())};
  }
  rows.clear();
  for (auto from = numbers.begin(); from != numbers.end(); from += static_cast<std::ptrdiff_t>(columns.size()))
    rows.emplace_back(from, from + static_cast<std::ptrdiff_t>(columns.size()));
}

Recorder::Recorder(const Dynamics& dynamics, const State& start, bool ledger) : dynamics_{&dynamics} {
  history_.columns = history_columns(dynamics.model(), ledger);
  row_.resize(history_.columns.size());
  const Model& model = dynamics.model();
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (model.bodies[i].mobility == Mobility::fixed) continue;
    moving_.push_back({i, turns(model.bodies[i]), dynamics.layout().first[i + 1] - 1});
  }
  if (ledger) ledger_.emplace(dynamics, start);
}

void Recorder::operator()(const Snapshot& snapshot, const StepInfo& info) {
  if (ledger_) accounts_ = ledger_->accounts(snapshot);
  fill_row(snapshot);
  extremes_.add(snapshot.state().t, row_);
  history_.proceed();
  if (info.due || info.stop) history_.add(row_, info.due);
}

void Recorder::serialize(Archive& archive) {
  archive.scope("history", [&] { history_.serialize(archive); });
  extremes_.serialize(archive, history_.columns.size());
  if (!ledger_) return;
  archive.scope("ledger", [&] { ledger_->serialize(archive); });
  archive.scope("balance", [&] { accounts_.serialize(archive); });
}

void Recorder::fill_row(const Snapshot& snapshot) {
  const State& state = snapshot.state();
  const Workspace& geometry = snapshot.geometry();
  const Poses& poses = geometry.poses;
  const LawForces& forces = snapshot.forces();
  const std::vector<double>& depths = snapshot.depths();
  double* next = row_.data();
  *next++ = state.t;
  for (const Moving& body : moving_) {
    const std::size_t i = body.body;
    *next++ = poses.x[i], *next++ = poses.y[i];
    *next++ = poses.vx[i], *next++ = poses.vy[i];
    if (body.turns) *next++ = state.q[body.angle], *next++ = poses.w[i];
  }
  for (std::size_t i = 0; i < depths.size(); ++i)
    *next++ = depths[i], *next++ = forces.contacts[i];
  const CableForces& cables = dynamics_->cables();
  for (std::size_t i = 0; i < forces.tensions.size(); ++i)
    *next++ = cables.elongation(geometry, i), *next++ = forces.tensions[i];
  if (ledger_) {
    const Energies& energies = accounts_.energies;
    *next++ = energies.kinetic, *next++ = energies.gravity, *next++ = energies.applied;
    *next++ = energies.contacts, *next++ = energies.cables;
    next = std::copy(accounts_.dissipated.begin(), accounts_.dissipated.end(), next);
    *next++ = accounts_.energy_balance_error;
    *next++ = accounts_.momentum_balance_error.x, *next++ = accounts_.momentum_balance_error.y;
    *next++ = accounts_.angular_momentum_balance_error;
  }
  TALUS_ASSERT(next == row_.data() + row_.size());
}

}  // namespace talus
