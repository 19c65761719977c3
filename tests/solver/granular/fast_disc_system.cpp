#define BOOST_TEST_MODULE fast_disc_system
#include "solver/granular/fast_disc_system.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "solver/granular/disc_method.hpp"
#include "solver/granular/disc_order.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/granular/shear_cell.hpp"

using namespace talus;

namespace {

const LinearSpringDashpot spring{4e3, 0.0}, dashpot{4e3, 3.0}, sticky{4e3, 3.0, EndRule::attractive};
const LatchingSpring latching{4e3, 8e3, 0.0}, growing{4e3, 5e3, 2e-3};

template <class Visit>
void for_each_law(Visit&& visit) {
  visit(spring), visit(dashpot), visit(sticky), visit(latching), visit(growing);
}

struct Packing {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
};

/// A square array in the middle of its box, thrown at itself.
Packing thrown(std::size_t side, double unlike, const PeriodicBox& box) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  Packing p{.shapes = {}, .discs = {}, .box = box};
  for (std::size_t i = 0; i < side * side; ++i) {
    const double radius = 1.0 + unlike * unit(random);
    p.shapes.add(radius, 1.0 / (radius * radius));
    const double middle = 0.5 * static_cast<double>(side - 1);
    const double x = 2.3 * (static_cast<double>(i % side) - middle), y = 2.3 * (static_cast<double>(i / side) - middle);
    p.discs.add(x, y, 2.0 * unit(random) - 0.1 * x, 2.0 * unit(random) - 0.1 * y);
  }
  return p;
}

/// The last bits of what both keep: all but the account of work.
bool same(Discs a, const Discs& b) {
  a.work = b.work;
  return a == b;
}

/// The largest overlaps that the plain system remembers beside those of the fast one.
template <class L>
bool same_memory(DiscSystem<L>& plain, const Discs& discs, const FastDiscSystem<L>& fast) {
  if constexpr (L::memory_size == 0) return true;
  Memory memory;
  plain.remember(memory, discs);
  std::vector<double> first, second, largest;
  Memory read{memory.items()};
  read.part("contact", [&] { read.list("first", first), read.list("second", second); });
  read.part("contact", [&] {
    largest.resize(first.size());
    read.numbers("memory", largest);
  });
  bool same = true;
  for (std::size_t k = 0; k < first.size(); ++k)
    same = same &&
           fast.largest_overlap(static_cast<std::size_t>(first[k]), static_cast<std::size_t>(second[k])) == largest[k];
  return same;
}

const std::array boxes{PeriodicBox{}, PeriodicBox{.width = 24.0}, PeriodicBox{.width = 24.0, .height = 25.0},
                       PeriodicBox{.width = 24.0, .height = 25.0, .shear_rate = 0.4}};

}  // namespace

BOOST_AUTO_TEST_CASE(fast_and_plain_give_the_same_bits) {
  for_each_law([](const auto& law) {
    for (const PeriodicBox& box : boxes) {
      for (const double unlike : {0.0, 0.1}) {
        Packing p = thrown(10, unlike, box);
        Discs plain_discs = p.discs, fast_discs = p.discs;
        DiscSystem plain{p.shapes, p.box, law, 0.5};
        FastDiscSystem fast{p.shapes, p.box, law, 0.5};
        plain.begin(plain_discs), fast.begin(fast_discs);
        const EulerCromerOf<Discs> method;
        bool memory = true, state = true;
        long hits = 0;
        for (long n = 0; n < 100; ++n) {
          for (long k = 0; k < 20; ++k)
            method.step(plain, plain_discs, 1e-3);
          fast.advance(fast_discs, 1e-3, 20);
          state = state && same(plain_discs, fast_discs);
          plain.for_each_contact(plain_discs, [&](const auto&) { ++hits; });
          if (n % 10 == 0) memory = memory && same_memory(plain, plain_discs, fast);
        }
        BOOST_TEST(state);
        BOOST_TEST(memory);
        BOOST_TEST(hits > 100);
        BOOST_TEST(fast.builds() == plain.builds());
        BOOST_TEST(fast.prunings() > 2 * fast.builds());
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(walls_feel_the_same_forces) {
  // The shear cell: discs of walls are held, driven, and moved by forces; with the discs in two orders.
  const ShearCell cell = ice_cell(8e3, 5e3);
  const FilledCell filled = fill(cell);
  std::vector<std::size_t> reverse(filled.discs.size());
  std::iota(reverse.rbegin(), reverse.rend(), std::size_t{});
  const double h = cell.contact_time() / 20.0;
  for (const auto& order : {order_by_rows(filled.shapes, filled.discs), reverse}) {
    const DiscShapes shapes = reordered(filled.shapes, order);
    Discs plain_discs = reordered(filled.discs, order), fast_discs = plain_discs;
    DiscSystem plain{shapes, filled.box, cell.law, 0.4 * cell.diameter};
    FastDiscSystem fast{shapes, filled.box, cell.law, 0.4 * cell.diameter};
    plain.begin(plain_discs), fast.begin(fast_discs);
    bool state = true, forces = true, impulses = true;
    double pressed = 0.0;
    for (long n = 0; n < 600; ++n) {
      Vec2 impulse;
      for (long k = 0; k < 20; ++k) {
        plain.kick(plain_discs, h), plain.drift(plain_discs, h);
        impulse += h * plain.wall_force(block_wall);
      }
      plain_discs.t = fast_discs.t;
      fast.advance(fast_discs, h, 20);
      plain_discs.t = fast_discs.t;
      state = state && same(plain_discs, fast_discs);
      for (const std::size_t wall : {base_wall, block_wall})
        forces = forces && plain.wall_force(wall) == fast.wall_force(wall);
      impulses = impulses && impulse == fast.wall_impulse(block_wall);
      pressed += fast.wall_impulse(block_wall).y;
    }
    BOOST_TEST(state);
    BOOST_TEST(forces);
    BOOST_TEST(impulses);
    BOOST_TEST(pressed > 0.0);
    BOOST_TEST(same_memory(plain, plain_discs, fast));
  }
}

BOOST_AUTO_TEST_CASE(methods_step_it_as_they_step_the_plain_one) {
  static_assert(Splittable<FastDiscSystem<LatchingSpring>, Discs>);
  for (const PeriodicBox& box : boxes) {
    const Packing p = thrown(8, 0.1, box);
    Discs plain_discs = p.discs, fast_discs = p.discs, at_once = p.discs;
    DiscSystem plain{p.shapes, p.box, latching, 0.5};
    FastDiscSystem fast{p.shapes, p.box, latching, 0.5}, other{p.shapes, p.box, latching, 0.5};
    plain.begin(plain_discs), fast.begin(fast_discs), other.begin(at_once);
    const CentralDifferenceOf<Discs> method;
    method.start(plain, plain_discs, 1e-3), method.start(fast, fast_discs, 1e-3), method.start(other, at_once, 1e-3);
    for (long n = 0; n < 1500; ++n)
      method.step(plain, plain_discs, 1e-3), method.step(fast, fast_discs, 1e-3);
    other.advance(at_once, 1e-3, 1500);
    BOOST_TEST(same(plain_discs, fast_discs));
    BOOST_TEST(same(plain_discs, at_once));
  }
}

BOOST_AUTO_TEST_CASE(jammed_discs_are_all_near_and_give_the_same_bits) {
  // A dense lattice that hardly moves: the near list saves nothing.
  Packing p{.shapes = {}, .discs = {}, .box = {.width = 24.0, .height = 24.0 * std::sqrt(0.75)}};
  std::mt19937 random{3};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  for (int i = 0; i < 144; ++i) {
    p.shapes.add(0.998, 1.0);
    p.discs.add(2.0 * (i % 12 - 5.75) + i / 12 % 2, 2.0 * std::sqrt(0.75) * (i / 12 - 5.5), 0.02 * unit(random),
                0.02 * unit(random));
  }
  for_each_law([&](const auto& law) {
    Discs plain_discs = p.discs, fast_discs = p.discs;
    DiscSystem plain{p.shapes, p.box, law, 0.5};
    FastDiscSystem fast{p.shapes, p.box, law, 0.5};
    plain.begin(plain_discs), fast.begin(fast_discs);
    for (long n = 0; n < 3000; ++n)
      plain.kick(plain_discs, 1e-3), plain.drift(plain_discs, 1e-3);
    fast.advance(fast_discs, 1e-3, 3000);
    plain_discs.t = fast_discs.t;
    BOOST_TEST(same(plain_discs, fast_discs));
    BOOST_TEST(same_memory(plain, plain_discs, fast));
    BOOST_TEST(fast.builds() == 1);
  });
}
