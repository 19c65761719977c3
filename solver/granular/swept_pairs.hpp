#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/pack.hpp"

namespace talus {

/// Pairs in the order of the neighbour list, followed by a pack of padding pairs.
struct SweptPairs {
  std::vector<std::uint32_t> first, second;  ///< index of x in StepBlock::positions; across a border, that of the ghost
  std::vector<std::uint32_t> listed;         ///< indices in the whole list; empty if these are all its pairs
  std::vector<double> radii;                 ///< sum of the two radii, if discs are of different size [L]
  std::size_t count{};

  std::size_t number_in_list(std::size_t pair) const { return listed.empty() ? pair : listed[pair]; }
  /// Makes room for a whole list of `size` pairs; unlike: of discs of different size.
  void list(std::size_t size, bool unlike);
  /// Appends the pairs with these indices in a whole list.
  void take(const SweptPairs& list, std::span<const std::uint32_t> numbers);
  /// Appends a pack of padding pairs, so that a pack may begin at any pair. nowhere: index of the padding position.
  void fill_up(std::uint32_t nowhere);

 private:
  void resize(std::size_t size, bool near, bool unlike);
};

/// Memory of one contact.
struct ContactMemory {
  double largest{};     ///< largest overlap since contact began, of history-dependent laws [L]
  double stretch{};     ///< of the friction spring [L]
  double normal{-1.0};  ///< force of the law if repulsive, else 0 [F]; < 0: the contact is new
};

/// A contact that has ended, of a history-dependent law or with friction.
struct EndedContact {
  std::uint32_t pair{};         ///< index in the whole list
  double largest{}, stretch{};  ///< [L]
};

/// Maximum number of pairs that are processed together.
inline constexpr std::size_t sweep_block = 512;

/// The contacts among some swept pairs, in the order of the pairs, and their memories.
struct SweptContacts {
  /// Kinds of memory that are stored, and of energy that is reported by each evaluation.
  struct Kinds {
    bool largest{}, stretch{}, normal{};
    bool power{}, friction_work{}, area_power{};

    bool remembered() const { return largest || stretch || normal; }
    bool reported() const { return power || friction_work; }
    friend bool operator==(const Kinds&, const Kinds&) = default;
  };
  /// Contacts found by a sweep; arrays are filled only for kinds that are stored, and have room for one more pack.
  struct Found {
    std::size_t count{};
    bool as_listed{};                              ///< `pair` refers to the whole list
    std::vector<std::uint32_t> pair;               ///< index among the swept pairs
    std::vector<double> largest, stretch, normal;  ///< as in ContactMemory
  };

  Kinds kinds;
  Found now, before;  ///< of the present or last sweep; of the one before it
  std::vector<double> power,
      released;                       ///< of laws without memory (contact_kernel.hpp) [F L/T, F L]
  std::vector<double> friction_work;  ///< dissipated by friction [F L]
  std::vector<double> area_power;     ///< dissipated by its changing stiffness [F L/T]

  std::size_t passed{};  ///< number of contacts in `before` that a sweep has passed
  /// For each contact of the present block its index in `before`; before.count, where the initial memory is stored, if
  /// it is new.
  std::array<std::uint32_t, sweep_block + pack_size> from{};

  /// Removes all contacts and sets the kinds.
  void clear(Kinds of);
  /// Makes room for `size` contacts.
  void make_room(std::size_t size) {
    if (size > now.pair.size()) grow(size + size / 4);
  }
  /// Prepares a sweep: the contacts found last become those before.
  void begin();
  ContactMemory memory(const Found& found, std::size_t t) const;

  /// Converts pair indices to those of the whole list, before the swept pairs are replaced.
  void number_as_listed(const SweptPairs& pairs);
  /// Appends a contact; all contacts must have pair indices of the whole list.
  void add(std::uint32_t listed, const ContactMemory& memory);

 private:
  void grow(std::size_t size);
  void put(Found& found, std::size_t t, const ContactMemory& memory) const;
};

}  // namespace talus
