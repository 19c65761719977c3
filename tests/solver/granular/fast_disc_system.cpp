#include "solver/granular/fast_disc_system.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "solver/base/error.hpp"
#include "solver/cell/shear_cell.hpp"
#include "solver/granular/disc_method.hpp"
#include "solver/granular/disc_order.hpp"
#include "solver/granular/disc_system.hpp"

BOOST_AUTO_TEST_SUITE(fast_disc_system_tests)

using namespace talus;

namespace {

const LinearSpringDashpot spring{4e3, 0.0}, dashpot{4e3, 3.0}, sticky{4e3, 3.0, EndRule::attractive};
const LatchingSpring latching{4e3, 8e3, 0.0}, growing{4e3, 5e3, 2e-3};

template <class Visit>
void for_each_law(Visit&& visit) {
  visit(spring), visit(dashpot), visit(sticky), visit(latching), visit(growing);
}

/// Visits each law, without friction and with.
template <class Visit>
void for_each_law_and_friction(Visit&& visit) {
  for_each_law([&](const auto& law) {
    visit(law, Frictionless{});
    for (const double coefficient : {0.2, 5.0})
      visit(law, CoulombFriction{coefficient, 2e3});
  });
}

struct Packing {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
};

/// A square array in the middle of its box, with random velocities and a part towards its centre.
Packing thrown(std::size_t side, double unlike, const PeriodicBox& box) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  Packing p{.shapes = {}, .discs = {}, .box = box};
  for (std::size_t i = 0; i < side * side; ++i) {
    const double radius = 1.0 + unlike * unit(random);
    p.shapes.add(radius, 1.0 / (radius * radius));
    const double middle = 0.5 * static_cast<double>(side - 1);
    const double x = 2.3 * (static_cast<double>(i % side) - middle), y = 2.3 * (static_cast<double>(i / side) - middle);
    const double vy = 2.0 * unit(random) - 0.1 * y, vx = 2.0 * unit(random) - 0.1 * x;
    p.discs.add(x, y, vx, vy);
  }
  return p;
}

/// Compares discs bit for bit, except for the dissipation of a history-dependent law.
template <class L>
bool same(const L&, Discs a, const Discs& b) {
  const auto lost = static_cast<std::size_t>(L::dissipation);
  if (L::memory_size == 1) a.work[lost] = b.work[lost];
  return a == b;
}

/// Compares the contact history of the plain system with that of the fast one.
template <class L, class F>
bool same_memory(DiscSystem<L, F>& plain, FastDiscSystem<L, F>& fast, const Discs& discs) {
  constexpr bool turns = DiscSystem<L, F>::turns;
  Archive of_plain, of_fast;
  plain.serialize(of_plain, discs), fast.serialize(of_fast, discs);
  struct Contact {
    double first, second, largest, stretch;
    bool operator==(const Contact&) const = default;
  };
  const auto read = [](const Archive& from, const char* of_largest) {
    Archive archive{from.items()};
    std::vector<double> first, second, largest, stretch;
    archive.scope("contact", [&] { archive.list("first", first), archive.list("second", second); });
    largest.resize(L::memory_size * first.size()), stretch.resize(turns ? first.size() : 0);
    archive.scope("contact", [&] {
      if (L::memory_size > 0) archive.numbers(of_largest, largest);
      if (turns) archive.numbers("stretch", stretch);
    });
    std::vector<Contact> contacts;
    for (std::size_t k = 0; k < first.size(); ++k) {
      const Contact contact{first[k], second[k], L::memory_size > 0 ? largest[k] : 0.0, turns ? stretch[k] : 0.0};
      if (contact.largest != 0.0 || contact.stretch != 0.0) contacts.push_back(contact);
    }
    return contacts;
  };
  return read(of_plain, "memory") == read(of_fast, "largest");
}

const std::array boxes{PeriodicBox{}, PeriodicBox{.width = 24.0}, PeriodicBox{.width = 24.0, .height = 25.0},
                       PeriodicBox{.width = 24.0, .height = 25.0, .shear_rate = 0.4}};

}  // namespace

BOOST_AUTO_TEST_CASE(fast_and_plain_give_the_same_bits) {
  for_each_law_and_friction([](const auto& law, const auto& friction) {
    for (const PeriodicBox& box : boxes) {
      for (const double unlike : {0.0, 0.1}) {
        Packing p = thrown(10, unlike, box);
        Discs plain_discs = p.discs, fast_discs = p.discs;
        DiscSystem plain{p.shapes, p.box, law, 0.5, friction};
        FastDiscSystem fast{p.shapes, p.box, law, 0.5, friction};
        fast.keep_work();
        plain.begin(plain_discs), fast.begin(fast_discs);
        const EulerCromerOf<Discs> method;
        bool memory = true, state = true;
        long hits = 0;
        const auto kept = [&](Mechanism of) { return fast_discs.work[static_cast<std::size_t>(of)]; };
        for (long n = 0; n < 100; ++n) {
          for (long k = 0; k < 20; ++k)
            method.step(plain, plain_discs, 1e-3);
          fast.advance(fast_discs, 1e-3, 20);
          state = state && same(law, plain_discs, fast_discs);
          plain.for_each_contact(plain_discs, [&](const auto&) { ++hits; });
          if (n % 10 == 0) memory = memory && same_memory(plain, fast, fast_discs);
        }
        BOOST_TEST(state);
        BOOST_TEST(memory);
        BOOST_TEST(hits > 100);
        if constexpr (!fast.has_history) {
          BOOST_TEST((kept(Mechanism::contact_damping) > 0.0) == contact_kernel(law).needs_rate());
          BOOST_TEST((kept(Mechanism::contact_release) > 0.0) == (law == dashpot));
        }
        BOOST_TEST((kept(Mechanism::friction) > 0.0) == fast.turns);
        BOOST_TEST(fast.builds() == plain.builds());
        BOOST_TEST(fast.prunings() > 2 * fast.builds());
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(any_number_of_threads_gives_the_same_bits) {
  for_each_law_and_friction([](const auto& law, const auto& friction) {
    for (const PeriodicBox& box : {boxes[0], boxes[3]}) {
      const Packing p = thrown(12, 0.1, box);
      Discs alone = p.discs;
      FastDiscSystem one{p.shapes, p.box, law, 0.5, friction};
      one.keep_work();
      one.begin(alone);
      one.advance(alone, 1e-3, 300);
      Discs without = p.discs;
      FastDiscSystem keeps_none{p.shapes, p.box, law, 0.5, friction};
      keeps_none.begin(without);
      keeps_none.advance(without, 1e-3, 300);
      BOOST_TEST(without.dissipated() == 0.0);
      without.work = alone.work;
      BOOST_TEST((without == alone));
      for (const std::size_t threads : {2U, 3U, 7U}) {
        Discs together = p.discs;
        FastDiscSystem several{p.shapes, p.box, law, 0.5, friction, threads};
        several.keep_work();
        several.begin(together);
        several.advance(together, 1e-3, 290);
        for (int n = 0; n < 10; ++n)  // one stripe after another
          several.kick(together, 1e-3), several.drift(together, 1e-3);
        together.t = alone.t;
        BOOST_TEST((together == alone));
        BOOST_TEST(several.builds() > 1);
        if constexpr (FastDiscSystem<std::decay_t<decltype(law)>>::has_history)
          BOOST_TEST(several.lost() == one.lost());
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(no_thread_at_all_is_refused) {
  const Packing p = thrown(2, 0.0, boxes[0]);
  BOOST_CHECK_THROW((FastDiscSystem{p.shapes, p.box, latching, 0.5, Frictionless{}, 0}), InputError);
}

BOOST_AUTO_TEST_CASE(threads_share_a_moved_wall) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  const auto law = std::get<LatchingSpring>(cell.law);
  const FilledCell filled = fill(cell);
  const double h = cell.contact_time() / 20.0;
  Discs alone = filled.discs, together = filled.discs;
  FastDiscSystem one{filled.shapes, filled.box, law, 0.4 * cell.diameter};
  FastDiscSystem three{filled.shapes, filled.box, law, 0.4 * cell.diameter, Frictionless{}, 3};
  one.begin(alone), three.begin(together);
  Vec2 on_one, on_three;
  one.advance(alone, h, 12000, [&] { on_one += one.wall_force(block_wall); });
  three.advance(together, h, 12000, [&] { on_three += three.wall_force(block_wall); });
  BOOST_TEST((alone == together));
  BOOST_TEST((on_one == on_three));
  BOOST_TEST(on_one.y > 0.0);
  BOOST_TEST(one.lost() == three.lost());
}

namespace {

/// Compares contacts and losses in every twentieth step of 0.001, whose drift has another length.
template <class L, class F>
void expect_contacts_of_the_plain_one(const L& law, const F& friction, double skin, double other) {
  const Packing p = thrown(10, 0.1, boxes[3]);
  Discs discs = p.discs, fast_discs = p.discs;
  DiscSystem plain{p.shapes, p.box, law, skin, friction};
  FastDiscSystem fast{p.shapes, p.box, law, skin, friction};
  plain.begin(discs), fast.begin(fast_discs);
  long compared = 0;
  bool pairs = true, forces = true, losses = true;
  for (long n = 0; n < 40; ++n) {
    for (long k = 0; k < 19; ++k)
      plain.kick(discs, 1e-3), plain.drift(discs, 1e-3);
    fast.advance(fast_discs, 1e-3, 19);
    plain.kick(discs, 1e-3), fast.kick(fast_discs, 1e-3);
    std::vector<DiscContact> theirs, ours;
    plain.for_each_contact(discs, [&](const DiscContact& c) {
      if (c.depth > 0.0 && c.force != 0.0) theirs.push_back(c);
    });
    fast.for_each_contact(fast_discs, [&](const DiscContact& c) {
      if (c.force != 0.0) ours.push_back(c);
    });
    pairs = pairs && theirs.size() == ours.size();
    for (std::size_t c = 0; c < ours.size() && pairs; ++c) {
      pairs = ours[c].a == theirs[c].a && ours[c].b == theirs[c].b && ours[c].depth == theirs[c].depth;
      forces = forces && ours[c].force == theirs[c].force && ours[c].friction == theirs[c].friction &&
               ours[c].stored == theirs[c].stored && ours[c].n_ab == theirs[c].n_ab;
      ++compared;
    }
    if constexpr (FastDiscSystem<L>::has_history) {
      const double lost = discs.work[static_cast<std::size_t>(Mechanism::contact_damping)];
      losses = losses && std::abs(fast.lost() - lost) <= 1e-11 * lost;
    }
    plain.drift(discs, other), fast.drift(fast_discs, other);
  }
  BOOST_TEST(pairs);
  BOOST_TEST(forces);
  BOOST_TEST(losses);
  BOOST_TEST(compared > 100);
}

}  // namespace

BOOST_AUTO_TEST_CASE(contacts_and_losses_are_those_of_the_plain_one) {
  for_each_law_and_friction([](const auto& law, const auto& friction) {
    expect_contacts_of_the_plain_one(law, friction, 0.5, 1e-3);
    // Discs that were in contact are beyond the list at once.
    expect_contacts_of_the_plain_one(law, friction, 0.1, 0.2);
  });
}

BOOST_AUTO_TEST_CASE(contacts_are_reported_after_a_new_list) {
  for_each_law_and_friction([](const auto& law, const auto& friction) {
    const Packing p = thrown(10, 0.1, boxes[1]);
    Discs discs = p.discs;
    FastDiscSystem fast{p.shapes, p.box, law, 0.5, friction};
    fast.begin(discs);
    const auto touching = [&] {
      long count = 0;
      fast.for_each_contact(discs, [&](const DiscContact&) { ++count; });
      return count;
    };
    long before = 0, lists = 0;
    for (long n = 0; n < 2000; ++n) {
      const long builds = fast.builds();
      fast.advance(discs, 1e-3, 1);
      if (fast.builds() == builds) {
        before = touching();
        continue;
      }
      // At most half of them separate in one step.
      BOOST_TEST(2 * touching() >= before);
      lists += before > 2 ? 1 : 0;
    }
    BOOST_TEST(lists > 1);
  });
}

BOOST_AUTO_TEST_CASE(what_is_put_back_goes_on_with_the_same_bits) {
  for_each_law_and_friction([](const auto& law, const auto& friction) {
    for (const PeriodicBox& box : boxes) {
      const Packing p = thrown(10, 0.1, box);
      Discs discs = p.discs;
      FastDiscSystem whole{p.shapes, p.box, law, 0.5, friction};
      whole.keep_work();
      whole.begin(discs);
      whole.advance(discs, 1e-3, 307);
      Archive saved;
      whole.serialize(saved, discs);
      Discs again = discs;
      FastDiscSystem other{p.shapes, p.box, law, 0.5, friction, 2};
      other.keep_work();
      Archive put_back{saved.items()};
      other.serialize(put_back, again);
      whole.advance(discs, 1e-3, 500), other.advance(again, 1e-3, 500);
      BOOST_TEST((discs == again));
    }
  });
}

BOOST_AUTO_TEST_CASE(walls_feel_the_same_forces) {
  // The shear cell: discs of walls are held, driven, and moved by forces; with the discs in two orders.
  const ShearCell cell = ice_cell(8e3, 5e3);
  const auto law = std::get<LatchingSpring>(cell.law);
  const FilledCell filled = fill(cell);
  std::vector<std::size_t> reverse(filled.discs.size());
  std::iota(reverse.rbegin(), reverse.rend(), std::size_t{});
  const double h = cell.contact_time() / 20.0;
  for (const auto& order : {order_by_rows(filled.shapes, filled.discs), reverse}) {
    const DiscShapes shapes = reordered(filled.shapes, order);
    Discs plain_discs = reordered(filled.discs, order), fast_discs = plain_discs;
    DiscSystem plain{shapes, filled.box, law, 0.4 * cell.diameter};
    FastDiscSystem fast{shapes, filled.box, law, 0.4 * cell.diameter};
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
      Vec2 fast_impulse;
      fast.advance(fast_discs, h, 20, [&] { fast_impulse += h * fast.wall_force(block_wall); });
      plain_discs.t = fast_discs.t;
      state = state && same(law, plain_discs, fast_discs);
      for (const std::size_t wall : {base_wall, block_wall})
        forces = forces && plain.wall_force(wall) == fast.wall_force(wall);
      impulses = impulses && impulse == fast_impulse;
      pressed += fast_impulse.y;
    }
    BOOST_TEST(state);
    BOOST_TEST(forces);
    BOOST_TEST(impulses);
    BOOST_TEST(pressed > 0.0);
    BOOST_TEST(same_memory(plain, fast, fast_discs));
  }
}

BOOST_AUTO_TEST_CASE(methods_step_it_as_they_step_the_plain_one) {
  for_each_law_and_friction([](const auto& law, const auto& friction) {
    for (const std::string& name : disc_method_names()) {
      const Packing p = thrown(8, 0.1, boxes[3]);
      Discs plain_discs = p.discs, fast_discs = p.discs;
      DiscSystem plain{p.shapes, p.box, law, 0.5, friction};
      FastDiscSystem fast{p.shapes, p.box, law, 0.5, friction};
      fast.keep_work();
      plain.begin(plain_discs), fast.begin(fast_discs);
      DiscMethod for_plain = make_disc_method(name), for_fast = for_plain;
      std::visit([&](auto& method) { method.start(plain, plain_discs, 1e-3); }, for_plain);
      std::visit([&](auto& method) { method.start(fast, fast_discs, 1e-3); }, for_fast);
      for (long n = 0; n < 600; ++n) {
        std::visit([&](auto& method) { method.step(plain, plain_discs, 1e-3); }, for_plain);
        std::visit([&](auto& method) { method.step(fast, fast_discs, 1e-3); }, for_fast);
      }
      BOOST_TEST(same(law, plain_discs, fast_discs));
      BOOST_TEST(fast.evaluations() == plain.evaluations());
    }
  });
}

BOOST_AUTO_TEST_CASE(many_steps_at_once_are_those_of_a_leapfrog) {
  const Packing p = thrown(8, 0.1, boxes[3]);
  Discs discs = p.discs, at_once = p.discs;
  FastDiscSystem system{p.shapes, p.box, latching, 0.5}, other{p.shapes, p.box, latching, 0.5};
  system.begin(discs), other.begin(at_once);
  const CentralDifferenceOf<Discs> method;
  method.start(system, discs, 1e-3), method.start(other, at_once, 1e-3);
  for (long n = 0; n < 1500; ++n)
    method.step(system, discs, 1e-3);
  other.advance(at_once, 1e-3, 1500);
  BOOST_TEST((discs == at_once));
}

BOOST_AUTO_TEST_CASE(jammed_discs_are_all_near_and_give_the_same_bits) {
  // A dense lattice with rattling discs: the near list saves nothing, until it is checked again.
  Packing p{.shapes = {}, .discs = {}, .box = {.width = 24.0, .height = 24.0 * std::sqrt(0.75)}};
  std::mt19937 random{3};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  for (int i = 0; i < 144; ++i) {
    p.shapes.add(0.998, 1.0);
    p.discs.add(2.0 * (i % 12 - 5.75) + i / 12 % 2, 2.0 * std::sqrt(0.75) * (i / 12 - 5.5), 0.4 * unit(random),
                0.4 * unit(random));
  }
  int all_near = 0;
  for_each_law_and_friction([&](const auto& law, const auto& friction) {
    Discs plain_discs = p.discs, fast_discs = p.discs;
    DiscSystem plain{p.shapes, p.box, law, 0.5, friction};
    FastDiscSystem fast{p.shapes, p.box, law, 0.5, friction};
    fast.keep_work();
    plain.begin(plain_discs), fast.begin(fast_discs);
    for (long n = 0; n < 12000; ++n)
      plain.kick(plain_discs, 1e-3), plain.drift(plain_discs, 1e-3);
    fast.advance(fast_discs, 1e-3, 12000);
    plain_discs.t = fast_discs.t;
    BOOST_TEST(same(law, plain_discs, fast_discs));
    BOOST_TEST(same_memory(plain, fast, fast_discs));
    BOOST_TEST(fast.builds() == 1);
    BOOST_TEST(fast.prunings() > 3);
    all_near += fast.prunings() < 10 ? 1 : 0;
  });
  BOOST_TEST(all_near > 10);  // cases that friction has brought to rest have a near list again
}

BOOST_AUTO_TEST_SUITE_END()
