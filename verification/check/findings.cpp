#include "verification/check/findings.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace talus::verification {

namespace {

template <class Named>
void demand_new(const std::vector<Named>& present, const std::string& name, const std::string& what) {
  if (name.empty()) throw std::invalid_argument("a " + what + " needs a name");
  const bool known = std::any_of(present.begin(), present.end(), [&](const Named& x) { return x.name == name; });
  if (known) throw std::logic_error("a " + what + " named '" + name + "' exists already in this case");
}

/// Errors: std::invalid_argument if `thing` has no columns or a row of another length.
template <class Thing>
void demand_rows(const Thing& thing, const std::string& what) {
  const std::string whose = what + " '" + thing.name + "': ";
  if (thing.columns.empty()) throw std::invalid_argument(whose + "it has no columns");
  for (const auto& row : thing.rows) {
    if (row.size() == thing.columns.size()) continue;
    throw std::invalid_argument(whose + "a row of " + std::to_string(row.size()) + " cells under " +
                                std::to_string(thing.columns.size()) + " columns");
  }
}

}  // namespace

bool Findings::add(Check check, std::string id) {
  demand_new(checks_, check.name, "check");
  checks_.push_back(std::move(check));
  groups_.push_back(open_groups_);
  for (std::size_t slash = id.find('/'); slash != std::string::npos; slash = id.find('/', slash + 1))
    groups_.back().push_back(id.substr(0, slash));
  if (!id.empty()) groups_.back().push_back(std::move(id));
  if (std::erase(needed_, checks_.back().name) > 0 && needed_.empty()) throw Decided{};
  if (until_one_fails_ && !checks_.back().pass) throw Decided{};
  return checks_.back().pass;
}

Findings::Group Findings::in(std::string id) {
  if (id.empty()) throw std::invalid_argument("a group of checks needs an id");
  return Group{*this, std::move(id)};
}

bool Findings::expect(CheckName name, double measured, double reference, const Tolerance& tolerance, std::string unit) {
  return add(compare(std::move(name.name), measured, reference, tolerance, std::move(unit)), std::move(name.id));
}

bool Findings::expect_exact(CheckName name, double measured, double reference, std::string why, std::string unit) {
  return expect(std::move(name), measured, reference, Tolerance::exact(std::move(why)), std::move(unit));
}

bool Findings::expect_round_off(CheckName name, double measured, double reference, double bound, std::string why,
                                std::string unit) {
  return expect(std::move(name), measured, reference, Tolerance::round_off(bound, std::move(why)), std::move(unit));
}

bool Findings::expect_truncation(CheckName name, double measured, double reference, double predicted_error,
                                 double factor, std::string why, std::string unit) {
  return expect(std::move(name), measured, reference, Tolerance::truncation(predicted_error, factor, std::move(why)),
                std::move(unit));
}

bool Findings::expect_model(CheckName name, double measured, double reference, double bound, std::string why,
                            std::string unit) {
  return expect(std::move(name), measured, reference, Tolerance::model(bound, std::move(why)), std::move(unit));
}

bool Findings::expect_between(CheckName name, double measured, double low, double high, std::string why,
                              std::string unit) {
  return add(compare_between(std::move(name.name), measured, low, high, std::move(why), std::move(unit)),
             std::move(name.id));
}

bool Findings::expect_true(CheckName name, bool holds, std::string why) {
  Check check = compare(std::move(name.name), holds ? 1.0 : 0.0, 1.0, Tolerance::exact(std::move(why)), "1");
  check.text_measured = holds ? "true" : "false";
  return add(std::move(check), std::move(name.id));
}

bool Findings::expect_order(CheckName name, const Convergence& convergence, double low, double high, std::string why) {
  Check check = compare_between(std::move(name.name), convergence.fit().order, low, high, std::move(why), "1");
  check.order = true;
  return add(std::move(check), std::move(name.id));
}

void Findings::figure(Figure figure) {
  demand_well_formed(figure);
  demand_new(figures_, figure.name, "figure");
  if (const std::size_t lost = not_finite(figure); lost > 0) {
    expect(
        "figure " + figure.name + ": points that are not finite", static_cast<double>(lost), 0.0,
        Tolerance::exact("a curve with a hole shows nothing: what cannot be measured is left out by the case itself"));
  }
  figure = drawable(std::move(figure));
  if (figure.series.empty()) return note("Figure `" + figure.name + "` is not drawn: no point of it is finite.");
  records::name_columns(figure);
  figures_.push_back(std::move(figure));
}

void Findings::table(Table table) {
  demand_rows(table, "table");
  if (table.caption.empty()) throw std::invalid_argument("table '" + table.name + "': it has no caption");
  demand_new(tables_, table.name, "table");
  tables_.push_back(std::move(table));
}

void Findings::data(DataFile file) {
  demand_rows(file, "data file");
  demand_new(data_, file.name, "data file");
  data_.push_back(std::move(file));
}

void Findings::note(std::string markdown) { notes_.push_back(std::move(markdown)); }

const Check* Findings::find(const std::string& name) const {
  const auto found = std::find_if(checks_.begin(), checks_.end(), [&](const Check& c) { return c.name == name; });
  return found == checks_.end() ? nullptr : &*found;
}

}  // namespace talus::verification
