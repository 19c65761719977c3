#include "solver/stability/missing_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/geometry/penetration.hpp"
#include "solver/stability/start_overlaps.hpp"

namespace talus {
namespace {

bool has_outline(const Body& body) { return !std::holds_alternative<NoShape>(body.shape); }

/// Pairs of bodies with a contact, each with the smaller index first, sorted.
std::vector<std::pair<std::size_t, std::size_t>> declared_pairs(const Model& model) {
  std::vector<std::pair<std::size_t, std::size_t>> declared;
  for (const Contact& contact : model.contacts)
    declared.push_back(std::minmax(index(contact.a), index(contact.b)));
  std::ranges::sort(declared);
  return declared;
}

/// Calls visit(a, b) for each pair without a contact until it returns false.
template <class Visit>
void for_each_pair(const Model& model, Visit&& visit) {
  const auto declared = declared_pairs(model);
  for (std::size_t a = 0; a < model.bodies.size(); ++a) {
    if (!has_outline(model.bodies[a])) continue;
    for (std::size_t b = a + 1; b < model.bodies.size(); ++b) {
      const Body &one = model.bodies[a], &other = model.bodies[b];
      const bool moves = one.mobility != Mobility::fixed || other.mobility != Mobility::fixed;
      if (!moves || !has_outline(other) || std::ranges::binary_search(declared, std::pair{a, b})) continue;
      if (!visit(a, b)) return;
    }
  }
}

}  // namespace

MissingContacts::MissingContacts(const Dynamics& dynamics) : dynamics_{&dynamics} {
  const Model& model = dynamics.model();
  for_each_pair(model, [&](std::size_t, std::size_t) { return ++size_ <= maximum_pairs; });
  if (!is_checked()) return;
  for_each_pair(model, [&](std::size_t a, std::size_t b) {
    search_.add({.a = static_cast<BodyId>(a),
                 .b = static_cast<BodyId>(b),
                 .bounds_a = bounds(model.bodies[a].shape),
                 .bounds_b = bounds(model.bodies[b].shape)});
    return true;
  });
  search_.prepare(model.bodies.size());
  near_.resize(size_), returned_.resize(size_);
}

std::vector<UndeclaredOverlap> MissingContacts::new_overlaps(const Workspace& geometry) {
  std::vector<UndeclaredOverlap> found;
  if (!is_checked() || search_.is_current(geometry.poses, sweep_)) return found;
  const std::vector<Body>& bodies = dynamics_->model().bodies;
  static_cast<void>(search_.find(geometry.poses, near_, sweep_));
  for (const std::size_t p : sweep_.close) {
    if (!std::exchange(near_[p], 0) || returned_[p]) continue;
    const Candidate& pair = search_.pairs()[p];
    const std::size_t a = index(pair.a), b = index(pair.b);
    const double overlap = penetration(bodies[a].shape, geometry.poses[a], bodies[b].shape, geometry.poses[b]);
    const double ratio = overlap / smaller_size(pair);
    if (!(ratio > plausible_overlap)) continue;
    returned_[p] = 1;
    found.push_back({pair.a, pair.b, ratio});
  }
  // The order of the list depends on the list before it.
  std::ranges::sort(found, {}, [](const UndeclaredOverlap& o) { return std::pair{-o.ratio, std::pair{o.a, o.b}}; });
  return found;
}

std::vector<std::pair<BodyId, BodyId>> MissingContacts::returned() const {
  std::vector<std::pair<BodyId, BodyId>> found;
  for (std::size_t p = 0; p < returned_.size(); ++p) {
    if (returned_[p]) found.emplace_back(search_.pairs()[p].a, search_.pairs()[p].b);
  }
  return found;
}

void MissingContacts::serialize(Archive& archive) {
  std::vector<double> positions, returned;
  const std::size_t bodies = dynamics_->model().bodies.size();
  std::array<Row*, 4> rows{&sweep_.positions.x, &sweep_.positions.y, &sweep_.positions.cosine, &sweep_.positions.sine};
  if (!archive.is_loading()) {
    for (const Row* row : rows) {
      for (std::size_t i = 0; i < row->size(); ++i)
        positions.push_back((*row)[i]);
    }
    for (std::size_t p = 0; p < returned_.size(); ++p) {
      if (returned_[p]) returned.push_back(static_cast<double>(p));
    }
  }
  archive.list("positions", positions);
  archive.list("returned", returned);
  if (!archive.is_loading()) return;
  if (!positions.empty() && (!is_checked() || positions.size() != rows.size() * bodies))
    throw InputError{fmt::format("positions: found {} numbers; there are {} bodies", positions.size(), bodies)};
  for (const double p : returned) {
    if (!(p >= 0.0 && p < static_cast<double>(returned_.size()) && p == std::floor(p)))
      throw InputError{fmt::format("returned: found {}; there are {} pairs", p, returned_.size())};
    returned_[static_cast<std::size_t>(p)] = 1;
  }
  sweep_ = Sweep();
  if (positions.empty()) return;
  Poses poses{bodies};
  for (std::size_t i = 0; i < bodies; ++i)
    poses.set(i,
              {{positions[i], positions[bodies + i]}, {positions[2 * bodies + i], positions[3 * bodies + i]}, {}, 0.0});
  static_cast<void>(search_.find(poses, near_, sweep_));
  std::ranges::fill(near_, 0);
}

std::string overlap_text(const UndeclaredOverlap& overlap, const Model& model) {
  return fmt::format(
      "bodies '{}' and '{}' overlap by {:.3g} % of half the width of the smaller one, and no [[contact]] is "
      "declared between them: they pass through each other without a force",
      model.bodies[index(overlap.a)].name, model.bodies[index(overlap.b)].name, 100.0 * overlap.ratio);
}

std::string unchecked_pairs_warning() {
  return fmt::format(
      "more than {} pairs of bodies have no contact between them: their overlaps are not checked, at the start and "
      "during the run",
      MissingContacts::maximum_pairs);
}

std::string missing_contact_warning(const Dynamics& dynamics, const State& state) {
  MissingContacts missing{dynamics};
  if (missing.is_too_large()) return unchecked_pairs_warning();
  Workspace work = dynamics.workspace();
  dynamics.update_all(state, work);
  const std::vector<UndeclaredOverlap> found = missing.new_overlaps(work);
  if (found.empty()) return "";
  const std::string others = found.size() == 1   ? ""
                             : found.size() == 2 ? "; so does 1 more pair"
                                                 : fmt::format("; so do {} more pairs", found.size() - 1);
  return fmt::format("at the start {}{}", overlap_text(found.front(), dynamics.model()), others);
}

}  // namespace talus
