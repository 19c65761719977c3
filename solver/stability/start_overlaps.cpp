#include "solver/stability/start_overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/geometry/penetration.hpp"

namespace talus {

std::vector<StartOverlap> start_overlaps(const Dynamics& dynamics, const State& state) {
  constexpr double round_off = 1e-12;
  const Model& model = dynamics.model();
  Workspace work = dynamics.workspace();
  dynamics.update_all(state, work);
  std::vector<StartOverlap> found;
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const auto contact = static_cast<ContactId>(c);
    const Candidate& pair = dynamics.contacts().pair(contact);
    const Pose A = work.poses[index(pair.a)], B = work.poses[index(pair.b)];
    if (out_of_reach(pair, A, B)) continue;
    const std::vector<Body>& bodies = model.bodies;
    const double overlap = model.contacts[c].method == ContactMethod::nodes
                               ? penetration(bodies[index(pair.a)].shape, A, bodies[index(pair.b)].shape, B)
                               : dynamics.contact_depth(work, contact);
    const double ratio = overlap / smaller_size(pair);
    if (ratio > round_off) found.push_back({contact, overlap, ratio});
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, &StartOverlap::ratio);
  return found;
}

std::string overlap_text(const StartOverlap& overlap, const Model& model) {
  return fmt::format("contact '{}' overlaps by {:.4g} {} at the start, {:.3g} % of half the width of its smaller body",
                     model.contacts[index(overlap.contact)].name, overlap.overlap,
                     symbol(model.units, dimension::length), 100.0 * overlap.ratio);
}

std::string overlap_warning(const std::vector<StartOverlap>& overlaps, const Model& model) {
  const auto count = std::ranges::count_if(overlaps, [](const StartOverlap& o) { return o.ratio > plausible_overlap; });
  if (count == 0) return "";
  const std::string others =
      count == 1 ? "" : fmt::format("; {} more overlap by more than {:g} %", count - 1, 100.0 * plausible_overlap);
  return overlap_text(overlaps.front(), model) + others;
}

}  // namespace talus
