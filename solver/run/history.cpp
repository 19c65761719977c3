#include "solver/run/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

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

Recorder::Recorder(const Dynamics& dynamics, const State& start, bool ledger, WatchedColumns watched)
    : dynamics_{&dynamics} {
  history_.columns = history_columns(dynamics.model(), ledger);
  row_.resize(history_.columns.size());
  const Model& model = dynamics.model();
  first_of_accounts_ = history_columns(model, false).size();
  first_of_cables_ = first_of_accounts_ - 2 * model.cables.size();
  first_of_contacts_ = first_of_cables_ - 2 * model.contacts.size();
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (model.bodies[i].mobility == Mobility::fixed) continue;
    moving_.push_back({i, turns(model.bodies[i]), dynamics.layout().first[i + 1] - 1});
  }
  if (ledger) ledger_.emplace(dynamics, start);
  if (watched) watch(std::move(*watched));
}

void Recorder::watch(std::vector<std::size_t> columns) {
  const auto any = [&](std::size_t first, std::size_t end) {
    return std::ranges::any_of(columns, [=](std::size_t column) { return column >= first && column < end; });
  };
  watched_parts_ = {any(1, first_of_contacts_), any(first_of_contacts_, first_of_cables_),
                    any(first_of_cables_, first_of_accounts_), any(first_of_accounts_, row_.size())};
  watched_row_.resize(columns.size());
  watched_ = std::move(columns);
}

void Recorder::operator()(const Snapshot& snapshot, const StepInfo& info) {
  if (ledger_) accounts_ = ledger_->accounts(snapshot);
  const bool whole = info.due || info.stop;
  fill_row(snapshot, whole ? Parts{} : watched_parts_);
  if (!watched_) {
    extremes_.add(snapshot.state().t, row_);
  } else {
    for (std::size_t i = 0; i < watched_row_.size(); ++i)
      watched_row_[i] = row_[(*watched_)[i]];
    extremes_.add(snapshot.state().t, watched_row_);
  }
  history_.proceed();
  if (whole) history_.add(row_, info.due);
}

Extreme Recorder::extreme(std::size_t column) const {
  if (!watched_) return extremes_[column];
  const auto found = std::ranges::lower_bound(*watched_, column);
  if (found == watched_->end() || *found != column)
    throw std::logic_error{fmt::format("column {} is not watched", column)};
  return extremes_[static_cast<std::size_t>(found - watched_->begin())];
}

void Recorder::serialize(Archive& archive) {
  archive.scope("history", [&] { history_.serialize(archive); });
  extremes_.serialize(archive, watched_ ? watched_->size() : history_.columns.size());
  if (!ledger_) return;
  archive.scope("ledger", [&] { ledger_->serialize(archive); });
  archive.scope("balance", [&] { accounts_.serialize(archive); });
}

void Recorder::fill_row(const Snapshot& snapshot, const Parts& parts) {
  const auto at = [this](std::size_t column) { return row_.data() + column; };
  row_.front() = snapshot.state().t;
  if (parts.motion) {
    const Poses& poses = snapshot.geometry().poses;
    double* next = at(1);
    for (const Moving& body : moving_) {
      const std::size_t i = body.body;
      *next++ = poses.x[i], *next++ = poses.y[i];
      *next++ = poses.vx[i], *next++ = poses.vy[i];
      if (body.turns) *next++ = snapshot.state().q[body.angle], *next++ = poses.w[i];
    }
    TALUS_ASSERT(next == at(first_of_contacts_));
  }
  if (parts.contacts) {
    const std::vector<double>&depths = snapshot.depths(), &forces = snapshot.forces().contacts;
    double* next = at(first_of_contacts_);
    for (std::size_t i = 0; i < depths.size(); ++i)
      *next++ = depths[i], *next++ = forces[i];
    TALUS_ASSERT(next == at(first_of_cables_));
  }
  if (parts.cables) {
    const CableForces& cables = dynamics_->cables();
    const Workspace& geometry = snapshot.geometry();
    const std::vector<double>& tensions = snapshot.forces().tensions;
    double* next = at(first_of_cables_);
    for (std::size_t i = 0; i < tensions.size(); ++i)
      *next++ = cables.elongation(geometry, i), *next++ = tensions[i];
    TALUS_ASSERT(next == at(first_of_accounts_));
  }
  if (parts.accounts && ledger_) {
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
