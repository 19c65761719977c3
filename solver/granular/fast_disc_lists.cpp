#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/base/pack.hpp"
#include "solver/granular/fast_disc_engine.hpp"
#include "solver/granular/step_block.hpp"

/// The lists of FastDiscEngine: stripes, positions, near pairs, and the contacts carried from one list to the next.
namespace talus {
namespace {

constexpr double making_cost = 1.5;   ///< c: of a listed pair, when the near list is built; of a near pair in a step: 1
constexpr double first_reach = 0.05;  ///< initial reach of the near list, over the skin
constexpr double long_time = 10.0;    ///< until all_near_ is reconsidered: accumulated approach of pairs, over the skin
constexpr double worth = 0.9;  ///< largest cost of a near list, over that of checking all listed pairs in each step

constexpr std::size_t whole(std::size_t count, std::size_t of) { return (count + of - 1) / of * of; }

}  // namespace

/// Rebuilds the list of pairs and carries the contact memories over to it.
void FastDiscEngine::rebuild(Discs& discs) {
  std::vector<Kept> kept = kept_contacts();
  wrap(list_.box(), discs);
  list_.build(shapes_, discs, pool_);
  ++builds_;
  list_stripes();
  list_positions();
  // A step may be so long that a contact is beyond the reach of the new list: it has ended.
  std::erase_if(kept, [&](const Kept& contact) {
    if (list_.find(contact.first, contact.second) < list_.size()) return false;
    lost_ += hysteresis_loss(contact.memory.largest);
    return true;
  });
  take_contacts(kept);
  load(discs);
  prune();
}

auto FastDiscEngine::kept_contacts() const -> std::vector<Kept> {
  std::vector<Kept> kept;
  for_each_touching([&](const SweptContacts& contacts, std::size_t t, std::size_t pair) {
    kept.push_back({disc(pairs_.first[pair]), disc(pairs_.second[pair]), contacts.memory(contacts.now, t)});
  });
  return kept;
}

/// Sets the contacts to those of the last evaluation, in the order of the list's pairs.
void FastDiscEngine::take_contacts(const std::vector<Kept>& kept) {
  for (Stripe& stripe : stripes_)
    stripe.own.contacts.clear(kinds_), stripe.outgoing.contacts.clear(kinds_);
  for (const Kept& contact : kept) {
    const std::size_t pair = list_.find(contact.first, contact.second);
    if (pair == list_.size()) {
      throw InputError{"contact: found one of the discs " + std::to_string(contact.first) + " and " +
                       std::to_string(contact.second) + "; they must be near each other"};
    }
    const auto stripe =
        std::find_if(stripes_.begin(), stripes_.end(), [&](const Stripe& of) { return contact.first < of.end; });
    Swept& swept = contact.second < stripe->end ? stripe->own : stripe->outgoing;
    swept.contacts.add(static_cast<std::uint32_t>(pair), contact.memory);
  }
}

/// Converts the pair indices of contacts to those of the whole list, before a near list is replaced.
void FastDiscEngine::number_as_listed() {
  each([this](Stripe& stripe) {
    for (Swept* const swept : {&stripe.own, &stripe.outgoing})
      swept->contacts.number_as_listed(pairs(*swept));
  });
}

/// Divides the discs into stripes with about equal numbers of listed pairs.
void FastDiscEngine::list_stripes() {
  std::size_t disc = 0;
  for (std::size_t s = 0; s < stripes_.size(); ++s) {
    stripes_[s].begin = disc;
    const std::size_t pairs = list_.size() * (s + 1) / stripes_.size();
    while (disc < shapes_.size() && (s + 1 == stripes_.size() || list_.end(disc) <= pairs))
      ++disc;
    stripes_[s].end = disc;
  }
}

/// Lays out positions, of the discs, of the ghosts that the list needs and of one padding entry, and the pairs of them.
void FastDiscEngine::list_positions() {
  const std::size_t discs = shapes_.size();
  constexpr std::uint8_t here = NeighbourList::images / 2;
  using Ghost = std::pair<std::uint32_t, std::uint8_t>;
  std::vector<std::vector<Ghost>> ghosts(stripes_.size());
  const auto ghosts_of = [&](const Stripe& stripe) -> auto& {
    return ghosts[static_cast<std::size_t>(&stripe - stripes_.data())];
  };
  each([&](const Stripe& stripe) {
    std::vector<Ghost>& own = ghosts_of(stripe);
    for (std::size_t i = stripe.begin; i < stripe.end; ++i) {
      for (std::size_t pair = list_.begin(i); pair < list_.end(i); ++pair) {
        if (list_.image(pair) != here)
          own.emplace_back(static_cast<std::uint32_t>(list_.second(pair)), list_.image(pair));
      }
    }
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
  });
  ghost_disc_.clear(), ghost_image_.clear();
  for (Stripe& stripe : stripes_) {
    stripe.first_ghost = ghost_disc_.size();
    for (const auto& [disc, image] : ghosts_of(stripe))
      ghost_disc_.push_back(disc), ghost_image_.push_back(image);
    stripe.end_of_ghosts = ghost_disc_.size();
  }
  pairs_.list(list_.size(), equal_radii_ == 0.0);
  each([&](const Stripe& stripe) {
    const std::vector<Ghost>& own = ghosts_of(stripe);
    for (std::size_t i = stripe.begin; i < stripe.end; ++i) {
      for (std::size_t pair = list_.begin(i); pair < list_.end(i); ++pair) {
        const auto j = static_cast<std::uint32_t>(list_.second(pair));
        std::size_t position = j;
        if (list_.image(pair) != here) {
          const auto ghost = std::lower_bound(own.begin(), own.end(), Ghost{j, list_.image(pair)});
          position = discs + stripe.first_ghost + static_cast<std::size_t>(ghost - own.begin());
        }
        pairs_.first[pair] = static_cast<std::uint32_t>(2 * i);
        pairs_.second[pair] = static_cast<std::uint32_t>(2 * position);
        if (equal_radii_ == 0.0) pairs_.radii[pair] = shapes_.radius[i] + shapes_.radius[j];
      }
    }
  });
  const std::size_t nowhere = discs + ghost_disc_.size();
  positions_.resize(2 * (nowhere + 1));
  velocities_.resize(2 * discs);
  if (traits_.turns) spins_.resize(discs), spins_before_.resize(discs);
  if (sees_rates()) before_.resize(2 * (nowhere + 1));
  std::fill(positions_.end() - 2, positions_.end(), std::numeric_limits<double>::quiet_NaN());
  pairs_.fill_up(static_cast<std::uint32_t>(2 * nowhere));
}

/// Builds the near list, if there is to be one.
void FastDiscEngine::prune() {
  if (all_near_ && used_ <= long_time * skin_) return;
  used_ = 0.0;
  number_as_listed();
  if (choose_reach()) return;
  ++prunings_;
  each([this](Stripe& stripe) { set_ghosts(stripe, positions_.data(), &NeighbourList::Shift::x); });
  each([this](Stripe& stripe) { prune(stripe); });
}

void FastDiscEngine::prune(Stripe& stripe) {
  StepBlock of = work(stripe, false, 0.0);
  of.pairs = &pairs_;
  SweptPairs &own_near = stripe.own.near, &outgoing_near = stripe.outgoing.near;
  own_near.count = outgoing_near.count = 0;
  const std::size_t from = stripe.begin < stripe.end ? list_.begin(stripe.begin) : 0;
  const std::size_t last = stripe.begin < stripe.end ? list_.end(stripe.end - 1) : 0;
  std::array<std::uint32_t, sweep_block + pack_size> found, outgoing;
  for (std::size_t block = from; block < last; block += sweep_block) {
    // Blocks consist of whole packs, so the last one may reach a little beyond the stripe.
    const std::size_t to = std::min(block + sweep_block, block + whole(last - block, pack_size));
    std::size_t near = find_near(of, traits_.reach + reach_, block, to, found.data()), own = near, out = 0;
    if (stripes_.size() > 1) {
      own = 0;
      for (std::size_t f = 0; f < near && found[f] < last; ++f)
        (disc(pairs_.second[found[f]]) < stripe.end ? found[own++] : outgoing[out++]) = found[f];
    }
    own_near.take(pairs_, {found.data(), own});
    outgoing_near.take(pairs_, {outgoing.data(), out});
  }
  const auto nowhere = static_cast<std::uint32_t>(positions_.size() - 2);
  own_near.fill_up(nowhere), outgoing_near.fill_up(nowhere);
}

/// Chooses the reach of the next near list from the properties of the last one; returns whether all listed pairs count
/// as near instead.
bool FastDiscEngine::choose_reach() {
  // After a period without a near list one is built, so that the next choice is based on present conditions.
  const bool is_checked_again = std::exchange(all_near_, false);
  if (reach_ == 0.0) reach_ = first_reach * skin_;
  double near = 0.0, touching = 0.0;
  for (const Stripe& stripe : stripes_) {
    near += static_cast<double>(stripe.own.near.count + stripe.outgoing.near.count);
    touching += static_cast<double>(stripe.own.contacts.now.count + stripe.outgoing.contacts.now.count);
  }
  if (approach_ == 0.0 || near == 0.0 || is_checked_again) return false;
  const double listed = static_cast<double>(pairs_.count);
  const double making = making_cost * listed * approach_;
  const double minimum = std::min(2.0 * approach_, skin_), last = reach_;
  reach_ = std::clamp(std::sqrt(making * last / std::max(near - touching, 1.0)), minimum, skin_);
  const bool settled = std::abs(reach_ / last - 1.0) < 0.2;
  // With several stripes a near list is always built, because it also separates the outgoing pairs.
  return all_near_ = stripes_.size() == 1 && settled && near + making / last > worth * listed;
}

}  // namespace talus
