/// Overlaps of bodies without a contact between them (solver/stability/missing_contacts.hpp).
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <set>

#include "solver/geometry/penetration.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/stability/missing_contacts.hpp"
#include "solver/stability/start_overlaps.hpp"

BOOST_AUTO_TEST_SUITE(missing_contacts_tests)

using namespace talus;

namespace {

/// Bodies of several outlines over a floor, with a contact between the first two.
Model scattered() {
  ModelBuilder builder;
  const std::vector<Shape> shapes{Circle{0.2}, Rectangle{0.3, 0.1}, Superquadric{0.3, 0.2, 3.0},
                                  Circle{0.1}, NoShape{},           Rectangle{0.1, 0.4}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    builder.add(Body{.name = "body" + std::to_string(i),
                     .mass = 1.0,
                     .inertia = 1.0,
                     .shape = shapes[i],
                     .p_WB = {2.0 * static_cast<double>(i), 5.0}});
  }
  builder.add(Body{.name = "floor", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  builder.add(Body{.name = "post", .mobility = Mobility::fixed, .shape = Circle{0.5}, .p_WB = {0.0, -3.0}});
  builder.add(Contact{.name = "c",
                      .a = static_cast<BodyId>(1),
                      .b = static_cast<BodyId>(0),
                      .law = LinearSpringDashpot{1.0, 0.0, EndRule::clamped}});
  return builder.build();
}

using Pair = std::pair<BodyId, BodyId>;

std::set<Pair> pairs_of(const std::vector<UndeclaredOverlap>& found) {
  std::set<Pair> pairs;
  for (const UndeclaredOverlap& overlap : found)
    pairs.insert({overlap.a, overlap.b});
  return pairs;
}

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_without_a_contact_of_which_one_moves) {
  const Model model = scattered();
  const Dynamics dynamics{model};
  const MissingContacts missing{dynamics};
  // Five moving outlines, a floor and a post: 21 pairs less that of the two fixed bodies and that with a contact.
  BOOST_TEST(missing.size() == 19U);
  BOOST_TEST(missing.is_checked());
  BOOST_TEST(missing.pairs().size() == 19U);
}

// Random walks: each pair is found as often, and at the same step, as by a comparison of all outlines at each step,
// but for displacements that are not compared, of a twentieth of half the width of each body.
BOOST_AUTO_TEST_CASE(every_overlap_is_found_once) {
  const Model model = scattered();
  const Dynamics dynamics{model};
  MissingContacts missing{dynamics};
  std::mt19937_64 random{3};
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  State state = rest_state(model);
  std::set<Pair> found, deep, shallow;
  for (int step = 0; step < 10000; ++step) {
    for (double& q : state.q)
      q = 0.999 * q + 0.03 * uniform();
    Workspace work = dynamics.workspace();
    dynamics.update_all(state, work);
    for (const Pair& pair : pairs_of(missing.new_overlaps(work)))
      BOOST_TEST(found.insert(pair).second);
    for (const Candidate& pair : missing.pairs()) {
      const std::size_t a = index(pair.a), b = index(pair.b);
      const double overlap = penetration(model.bodies[a].shape, work.poses[a], model.bodies[b].shape, work.poses[b]);
      const double reported = plausible_overlap * smaller_size(pair);
      double moved = 0.0;
      for (const Bounds& outline : {pair.bounds_a, pair.bounds_b})
        moved += is_unbounded(outline) ? 0.0 : 0.05 * minimum_half_width(outline);
      if (overlap > reported) shallow.insert({pair.a, pair.b});
      if (overlap > reported + 1.001 * moved) deep.insert({pair.a, pair.b});
    }
    BOOST_TEST_REQUIRE(std::ranges::includes(found, deep));
    BOOST_TEST_REQUIRE(std::ranges::includes(shallow, found));
  }
  BOOST_TEST(found.size() > 10U);
}

BOOST_AUTO_TEST_CASE(a_restored_check_continues_with_the_same_results) {
  const Model model = scattered();
  const Dynamics dynamics{model};
  MissingContacts one{dynamics}, other{dynamics};
  std::mt19937_64 random{5};
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  State state = rest_state(model);
  for (int step = 0; step < 5000; ++step) {
    for (double& q : state.q)
      q = 0.999 * q + 0.03 * uniform();
    Workspace work = dynamics.workspace();
    dynamics.update_all(state, work);
    if (step % 7 == 0) {
      Archive saved;
      other.serialize(saved);
      MissingContacts restored{dynamics};
      Archive archive{saved.items()};
      restored.serialize(archive);
      other = restored;
    }
    BOOST_TEST_REQUIRE((pairs_of(one.new_overlaps(work)) == pairs_of(other.new_overlaps(work))));
  }
}

BOOST_AUTO_TEST_CASE(the_warning_of_a_start_names_the_largest_overlap) {
  Model model = scattered();
  const Dynamics apart{model};
  BOOST_TEST(missing_contact_warning(apart, rest_state(model)) == "");
  model.bodies[3].p_WB = {0.25, 5.0};
  model.bodies[2].p_WB = {2.0, -0.1};
  const Dynamics dynamics{model};
  BOOST_TEST(missing_contact_warning(dynamics, rest_state(model)) ==
             "at the start bodies 'body2' and 'floor' overlap by 150 % of half the width of the smaller one, and no "
             "[[contact]] is declared between them: they pass through each other without a force; so does 1 more pair");
}

BOOST_AUTO_TEST_SUITE_END()
