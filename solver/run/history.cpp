#include "solver/run/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "solver/base/error.hpp"

namespace talus {
namespace {

bool turns(const Body& body) { return talus::turns(body.mobility); }

std::vector<Column> body_columns(const Model& model) {
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
  return found;
}

void add_contact_columns(const Model& model, std::vector<Column>& found) {
  for (const Contact& contact : model.contacts) {
    found.push_back({contact.name + ".overlap", dimension::length});
    found.push_back({contact.name + ".force", dimension::force});
  }
}

void add_cable_columns(const Model& model, std::vector<Column>& found) {
  for (const Cable& cable : model.cables) {
    found.push_back({cable.name + ".elongation", dimension::length});
    found.push_back({cable.name + ".tension", dimension::force});
  }
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
  std::vector<Column> found = body_columns(model);
  add_contact_columns(model, found);
  add_cable_columns(model, found);
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

Recorder::Recorder(const Dynamics& dynamics, const State& start, bool ledger, RecordedColumns recorded)
    : dynamics_{&dynamics}, recorded_{std::move(recorded)} {
  const Model& model = dynamics.model();
  std::vector<Column>& columns = history_.columns;
  columns = body_columns(model);
  first_of_contacts_ = columns.size();
  add_contact_columns(model, columns);
  first_of_cables_ = columns.size();
  add_cable_columns(model, columns);
  first_of_accounts_ = columns.size();
  if (ledger) add_account_columns(columns);
  row_.resize(columns.size());
  std::size_t column = 1;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (model.bodies[i].mobility == Mobility::fixed) continue;
    const bool turning = turns(model.bodies[i]);
    const std::size_t first = column;
    column += turning ? 6 : 4;
    const bool has_recorded =
        !recorded_ || std::ranges::any_of(*recorded_, [&](std::size_t each) { return each >= first && each < column; });
    moving_.push_back({i, turning, dynamics.layout().first[i + 1] - 1, first, has_recorded});
  }
  TALUS_DEMAND(column == first_of_contacts_);
  if (ledger) ledger_.emplace(dynamics, start);
  if (!recorded_) return;
  TALUS_DEMAND(std::ranges::is_sorted(*recorded_) && (recorded_->empty() || recorded_->back() < row_.size()));
  recorded_groups_ = groups_of(*recorded_);
  recorded_row_.resize(recorded_->size());
}

Recorder::ColumnGroups Recorder::groups_of(const std::vector<std::size_t>& columns) const {
  const auto any = [&](std::size_t first, std::size_t end) {
    return std::ranges::any_of(columns, [=](std::size_t column) { return column >= first && column < end; });
  };
  return {any(1, first_of_contacts_), any(first_of_contacts_, first_of_cables_),
          any(first_of_cables_, first_of_accounts_), false};
}

void Recorder::operator()(const Snapshot& snapshot, const StepInfo& info) {
  if (ledger_) accounts_ = ledger_->accounts(snapshot);
  const bool has_row = info.due || info.stop;
  fill_row(snapshot, has_row ? ColumnGroups{} : recorded_groups_);
  for (std::size_t i = 0; i < recorded_row_.size(); ++i)
    recorded_row_[i] = row_[(*recorded_)[i]];
  extremes_.add(snapshot.state().t, recorded_ ? recorded_row_ : row_);
  history_.proceed();
  if (has_row) history_.add(row_, info.due);
}

Extreme Recorder::extreme(std::size_t column) const {
  if (!recorded_) return extremes_[column];
  const auto found = std::ranges::lower_bound(*recorded_, column);
  TALUS_DEMAND(found != recorded_->end() && *found == column);
  return extremes_[static_cast<std::size_t>(found - recorded_->begin())];
}

void Recorder::serialize(Archive& archive) {
  archive.scope("history", [&] { history_.serialize(archive); });
  extremes_.serialize(archive, recorded_ ? recorded_->size() : history_.columns.size());
  if (!ledger_) return;
  archive.scope("ledger", [&] { ledger_->serialize(archive); });
  archive.scope("balance", [&] { accounts_.serialize(archive); });
}

void Recorder::fill_row(const Snapshot& snapshot, const ColumnGroups& groups) {
  const auto at = [this](std::size_t column) { return row_.data() + column; };
  row_.front() = snapshot.state().t;
  if (groups.bodies) {
    const Poses& poses = snapshot.geometry().poses;
    for (const Moving& body : moving_) {
      if (!groups.all_bodies && !body.recorded) continue;
      const std::size_t i = body.body;
      double* next = at(body.column);
      *next++ = poses.x[i], *next++ = poses.y[i];
      *next++ = poses.vx[i], *next++ = poses.vy[i];
      if (body.turns) *next++ = snapshot.state().q[body.angle], *next = poses.w[i];
    }
  }
  if (groups.contacts) {
    const std::vector<double>&depths = snapshot.depths(), &forces = snapshot.forces().contacts;
    double* next = at(first_of_contacts_);
    for (std::size_t i = 0; i < depths.size(); ++i)
      *next++ = depths[i], *next++ = forces[i];
    TALUS_ASSERT(next == at(first_of_cables_));
  }
  if (groups.cables) {
    const CableForces& cables = dynamics_->cables();
    const Workspace& geometry = snapshot.geometry();
    const std::vector<double>& tensions = snapshot.forces().tensions;
    double* next = at(first_of_cables_);
    for (std::size_t i = 0; i < tensions.size(); ++i)
      *next++ = cables.elongation(geometry, i), *next++ = tensions[i];
    TALUS_ASSERT(next == at(first_of_accounts_));
  }
  if (ledger_) {
    const Energies& energies = accounts_.energies;
    double* next = at(first_of_accounts_);
    *next++ = energies.kinetic, *next++ = energies.gravity, *next++ = energies.applied;
    *next++ = energies.contacts, *next++ = energies.cables;
    next = std::copy(accounts_.dissipated.begin(), accounts_.dissipated.end(), next);
    *next++ = accounts_.energy_balance_error;
    *next++ = accounts_.momentum_balance_error.x, *next++ = accounts_.momentum_balance_error.y;
    *next++ = accounts_.angular_momentum_balance_error;
    TALUS_ASSERT(next == at(row_.size()));
  }
}

}  // namespace talus
