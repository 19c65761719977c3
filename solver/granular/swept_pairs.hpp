#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/pack.hpp"

namespace talus {

/// Pairs in the order of the neighbour list, and behind them as many of places that are nowhere as fill the lanes.
struct SweptPairs {
  std::vector<std::uint32_t> first, second;  ///< where the places begin; of a second disc across a border, its ghost's
  std::vector<std::uint32_t> listed;         ///< numbers in the list; none if they are all of it
  std::vector<double> radii;                 ///< their sum, if discs are unlike [L]
  std::size_t count{};

  std::size_t number_in_list(std::size_t pair) const { return listed.empty() ? pair : listed[pair]; }
  /// Makes room for a whole list of so many, of unlike discs or like ones.
  void list(std::size_t size, bool unlike);
  /// Takes those with these numbers from a whole list behind its own.
  void take(const SweptPairs& list, std::span<const std::uint32_t> numbers);
  /// Fills the lanes behind the last pair, wherever packs begin. nowhere: where that place begins.
  void fill_up(std::uint32_t nowhere);

 private:
  void resize(std::size_t size, bool near, bool unlike);
};

/// What one contact remembers.
struct ContactMemory {
  double largest{};     ///< overlap since the touch, of laws that remember it [L]
  double stretch{};     ///< of the spring of friction [L]
  double normal{-1.0};  ///< force of the law, where it pushes [F]; < 0: the contact is new
};

/// A contact that has ended, of a law that remembers or with friction.
struct PartedPair {
  std::uint32_t pair{};         ///< number in the whole list
  double largest{}, stretch{};  ///< [L]
};

/// How many pairs are worked on together at most.
inline constexpr std::size_t sweep_block = 512;

/// The contacts among some swept pairs, in the order of the pairs, and what they remember.
struct SweptContacts {
  /// What is remembered, and what is reported of each evaluation.
  struct Kinds {
    bool largest{}, stretch{}, normal{};
    bool power{}, slid{};

    bool remembered() const { return largest || stretch || normal; }
    bool reported() const { return power || slid; }
    friend bool operator==(const Kinds&, const Kinds&) = default;
  };
  /// Those that a sweep found; numbers of a kind only if it is remembered. Room is for a pack more.
  struct Found {
    std::size_t count{};
    bool as_listed{};                              ///< pairs have their numbers in the whole list
    std::vector<std::uint32_t> pair;               ///< number among those swept
    std::vector<double> largest, stretch, normal;  ///< as in ContactMemory
  };

  Kinds kinds;
  Found now, before;  ///< by the last sweep, or this one; by the one before
  std::vector<double> power,
      released;              ///< what the law keeps, of laws without memory (contact_kernel.hpp) [F L/T, F L]
  std::vector<double> slid;  ///< what friction dissipates [F L]

  std::size_t passed{};  ///< of those before, during a sweep
  /// Of the block that is swept: which each was before; before.count, where stands what a contact begins with, if none.
  std::array<std::uint32_t, sweep_block + pack_size> from{};

  /// None.
  void clear(Kinds of);
  /// For so many contacts.
  void make_room(std::size_t size) {
    if (size > now.pair.size()) grow(size + size / 4);
  }
  /// Before a sweep.
  void begin();
  ContactMemory memory(const Found& found, std::size_t t) const;

  /// Before the pairs that are swept give way to others: numbers contacts as in the whole list.
  void number_as_listed(const SweptPairs& pairs);
  /// To none, or to contacts that are numbered so, one more.
  void add(std::uint32_t listed, const ContactMemory& memory);

 private:
  void grow(std::size_t size);
  void put(Found& found, std::size_t t, const ContactMemory& memory) const;
};

}  // namespace talus
