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
    found.push_back({contact.name + ".depth", dimension::length});
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
  for (const std::string_view mechanism : mechanism_names) {
    found.push_back({fmt::format("lost.{}", mechanism), dimension::energy});
  }
  found.push_back({"closure.energy", dimension::energy});
  found.push_back({"closure.momentum_x", dimension::momentum});
  found.push_back({"closure.momentum_y", dimension::momentum});
  found.push_back({"closure.angular_momentum", dimension::angular_momentum});
}

}  // namespace

std::vector<Column> history_columns(const Model& model, bool ledger) {
  std::vector<Column> found = motion_columns(model);
  if (ledger) add_account_columns(found);
  return found;
}

void History::go_on() {
  if (row_of_stop) rows.pop_back();
  row_of_stop = false;
}

void History::add(std::vector<double> row, bool due) {
  rows.push_back(std::move(row));
  row_of_stop = !due;
}

void History::remember(Memory& memory) {
  memory.flag("row_of_stop", row_of_stop);
  std::vector<double> numbers;
  for (const std::vector<double>& row : rows)
    numbers.insert(numbers.end(), row.begin(), row.end());
  memory.list("rows", numbers);
  if (!memory.puts_back()) return;
  if (numbers.size() % columns.size() != 0) {
    throw InputError{
        fmt::format("rows: found {} numbers; it must be whole rows of {}", numbers.size(), columns.size())};
  }
  rows.clear();
  for (auto from = numbers.begin(); from != numbers.end(); from += static_cast<std::ptrdiff_t>(columns.size()))
    rows.emplace_back(from, from + static_cast<std::ptrdiff_t>(columns.size()));
}

Recorder::Recorder(const Dynamics& dynamics, const State& start, bool ledger)
    : dynamics_{&dynamics}, work_{dynamics.workspace()} {
  history_.columns = history_columns(dynamics.model(), ledger);
  if (ledger) ledger_.emplace(dynamics, start);
}

void Recorder::operator()(const State& state, const StepInfo& info) {
  fill_row(state);
  if (ledger_) {
    accounts_ = ledger_->accounts(state);
    fill_accounts();
  }
  if (extremes_.empty()) {
    for (const double value : row_)
      extremes_.push_back({value, state.t, value, state.t});
  }
  for (std::size_t i = 0; i < row_.size(); ++i) {
    Extreme& extreme = extremes_[i];
    if (row_[i] < extreme.least) extreme.least = row_[i], extreme.least_time = state.t;
    if (row_[i] > extreme.largest) extreme.largest = row_[i], extreme.largest_time = state.t;
  }
  history_.go_on();
  if (info.due || info.stop) history_.add(row_, info.due);
}

void Recorder::remember(Memory& memory) {
  memory.part("history", [&] { history_.remember(memory); });
  std::vector<double> numbers;
  for (const Extreme& e : extremes_)
    numbers.insert(numbers.end(), {e.least, e.least_time, e.largest, e.largest_time});
  numbers.resize(4 * history_.columns.size());
  memory.numbers("extremes", numbers);
  extremes_.clear();
  for (std::size_t i = 0; i < numbers.size(); i += 4)
    extremes_.push_back({numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3]});
  if (!ledger_) return;
  memory.part("ledger", [&] { ledger_->remember(memory); });
  memory.part("accounts", [&] { accounts_.remember(memory); });
}

void Recorder::fill_row(const State& state) {
  const Model& model = dynamics_->model();
  dynamics_->update_all(state, work_);
  dynamics_->forces(state, work_, forces_);
  row_.assign({state.t});
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (model.bodies[i].mobility == Mobility::fixed) continue;
    const Pose pose = work_.poses[i];
    row_.insert(row_.end(), {pose.p_WB.x, pose.p_WB.y, pose.v_WB.x, pose.v_WB.y});
    if (turns(model.bodies[i])) row_.insert(row_.end(), {state.q[dynamics_->layout().first[i + 1] - 1], pose.w_WB});
  }
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const auto contact = static_cast<ContactId>(i);
    row_.push_back(dynamics_->contact_depth(work_, contact));
    row_.push_back(forces_.contacts[i]);
  }
  for (std::size_t i = 0; i < model.cables.size(); ++i) {
    const auto cable = static_cast<CableId>(i);
    row_.push_back(dynamics_->elongation(work_, cable));
    row_.push_back(forces_.tensions[i]);
  }
}

void Recorder::fill_accounts() {
  const Energies& energies = accounts_.energies;
  row_.insert(row_.end(), {energies.kinetic, energies.gravity, energies.applied, energies.contacts, energies.cables});
  row_.insert(row_.end(), accounts_.lost.begin(), accounts_.lost.end());
  row_.insert(row_.end(), {accounts_.energy_closure, accounts_.momentum_closure.x, accounts_.momentum_closure.y,
                           accounts_.angular_momentum_closure});
}

}  // namespace talus
