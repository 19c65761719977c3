/// The table of impacts: one row for each interval in which a contact acts, for every law; speeds, forces and impulses
/// of scenes with known results; a log that is saved and restored within an impact.
#include "solver/run/impact_log.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "tests/solver/laws/law_examples.hpp"

BOOST_AUTO_TEST_SUITE(impact_log_tests)

using namespace talus;

namespace {

/// The impacts of a run by velocity Verlet, and its last state.
struct Run {
  explicit Run(const Scene& scene) : dynamics{scene.model}, log{dynamics}, state{scene.initial} {
    RigidBodySystem system{dynamics, scene.plan.ledger};
    Integrator integrator = make_integrator("velocity_verlet");
    const Observer observer = std::ref(log);
    static_cast<void>(simulate(system, integrator, state, scene.plan, {&observer, 1}));
  }
  Dynamics dynamics;
  ImpactLog log;
  State state;
};

Scene falling(ContactLaw law, double end, double step, double gap = 0.01) {
  Scene scene = scenes::bouncing_disc({.gap = gap, .speed = 1.0, .gravity = 0.0, .contact = std::move(law)});
  scene.plan = {step, end, end, false};
  return scene;
}

/// Three discs: the first strikes the others, which touch each other from the start, in the order of a contact and in
/// reverse.
Model three_discs(bool reversed) {
  ModelBuilder builder;
  const auto add = [&](const char* name, Vec2 p) {
    return builder.add(
        Body{.name = name, .mobility = Mobility::free, .mass = 2.0, .inertia = 0.5, .shape = Circle{1.0}, .p_WB = p});
  };
  const BodyId striker = add("striker", {-2.5, 0.25}), first = add("first", {0.0, 0.0}), last = add("last", {2.0, 0.0});
  const auto touch = [&](const char* name, BodyId a, BodyId b) {
    if (reversed) std::swap(a, b);
    builder.add(Contact{.name = name,
                        .a = a,
                        .b = b,
                        .law = LinearSpringDashpot{1e4, 0.0, EndRule::clamped},
                        .friction = CoulombFriction{.coefficient = 0.3, .stiffness = 5e3}});
  };
  touch("strike", striker, first);
  touch("push", first, last);
  return builder.build();
}

Scene struck(bool reversed) {
  Scene scene{.title = "three discs", .model = three_discs(reversed)};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, BodyId{0}, {2.0, 0.0}, 3.0);
  scene.plan = {1e-4, 0.5, 0.5, false};
  return scene;
}

Vec2 velocity(const Run& run, std::size_t body) {
  const std::size_t first = run.dynamics.layout().first[body];
  return {run.state.v[first], run.state.v[first + 1]};
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_law_has_one_row_for_an_impact) {
  const auto check = []<class L>(const L& given) {
    for (L law : examples<L>()) {
      BOOST_TEST_CONTEXT(L::name) {
        // Dashpots so strong that the contact never opens again have no end.
        const double time = law.contact_time(1.0, 1.0);
        if (!std::isfinite(time) || law.largest_overlap(1.0, 1.0) > 0.4) continue;
        const Run run{falling(law, 0.01 + 8.0 * time, time / 2000.0)};
        BOOST_TEST_REQUIRE(run.log.impacts().size() == 1);
        const RecordedImpact& impact = run.log.impacts()[0];
        BOOST_TEST(!impact.from_start);
        BOOST_TEST(impact.touch_time == 0.01, boost::test_tools::tolerance(1e-3));
        BOOST_TEST(impact.approach_speed == 1.0, boost::test_tools::tolerance(1e-12));
        if (!impact.ended) continue;  // released, and still near the plane
        BOOST_TEST(impact.restitution().value() == law.restitution(1.0, 1.0), boost::test_tools::tolerance(5e-3));
        BOOST_TEST(impact.largest_overlap == law.largest_overlap(1.0, 1.0), boost::test_tools::tolerance(1e-2));
        BOOST_TEST(impact.normal_impulse == 1.0 + *impact.restitution(), boost::test_tools::tolerance(5e-3));
        BOOST_TEST(impact.impulse.y == -impact.normal_impulse, boost::test_tools::tolerance(1e-12));  // on the plane
        BOOST_TEST(impact.peak_force > 0.0);
        BOOST_TEST(impact.separation_time - impact.touch_time > 0.99 * time);
      }
    }
    static_cast<void>(given);
  };
  ContactLaws::for_each(check);
}

BOOST_AUTO_TEST_CASE(a_contact_that_never_acts_has_no_row) {
  const Run run{falling(LinearSpringDashpot{1e4, 0.0}, 0.1, 1e-3, 0.5)};
  BOOST_TEST(run.log.impacts().empty());
}

BOOST_AUTO_TEST_CASE(a_contact_from_the_start_has_the_speeds_of_the_first_state) {
  const Run run{falling(LinearSpringDashpot{1e4, 0.0}, 0.1, 1e-4, -0.001)};
  BOOST_TEST_REQUIRE(run.log.impacts().size() == 1);
  const RecordedImpact& impact = run.log.impacts()[0];
  BOOST_TEST(impact.from_start);
  BOOST_TEST(impact.ended);
  BOOST_TEST(impact.touch_time == 0.0);
  BOOST_TEST(impact.approach_speed == 1.0);
  BOOST_TEST(impact.largest_overlap == std::sqrt(1e-4 + 1e-6), boost::test_tools::tolerance(1e-4));
}

// e of bodies that do not approach does not exist.
BOOST_AUTO_TEST_CASE(restitution_requires_an_approach_and_an_end) {
  RecordedImpact impact;
  impact.approach_speed = 2.0, impact.separation_speed = 1.0;
  BOOST_TEST(!impact.restitution().has_value());
  impact.ended = true;
  BOOST_TEST(impact.restitution().value() == 0.5);
  impact.approach_speed = 0.0;
  BOOST_TEST(!impact.restitution().has_value());
}

BOOST_AUTO_TEST_CASE(the_order_of_the_bodies_changes_only_the_sign_of_the_impulse) {
  const Run forward{struck(false)}, reversed{struck(true)};
  BOOST_TEST_REQUIRE(forward.log.impacts().size() == reversed.log.impacts().size());
  BOOST_TEST_REQUIRE(forward.log.impacts().size() >= 2);
  for (std::size_t i = 0; i < forward.log.impacts().size(); ++i) {
    const RecordedImpact &a = forward.log.impacts()[i], &b = reversed.log.impacts()[i];
    const auto near = [](double found, double expected) {
      BOOST_TEST(std::abs(found - expected) < 1e-9 * (1.0 + std::abs(expected)), found << " for " << expected);
    };
    near(b.approach_speed, a.approach_speed), near(b.separation_speed, a.separation_speed);
    near(b.slip_before, a.slip_before), near(b.slip_after, a.slip_after);
    near(b.normal_impulse, a.normal_impulse), near(b.tangential_impulse, a.tangential_impulse);
    near(b.impulse.x, -a.impulse.x), near(b.impulse.y, -a.impulse.y);
  }
}

BOOST_AUTO_TEST_CASE(impulses_are_the_changes_of_momentum) {
  const Run run{struck(false)};
  Vec2 of_first, of_last;
  for (const RecordedImpact& impact : run.log.impacts()) {
    (index(impact.contact) == 0 ? of_first : of_last) += impact.impulse;
  }
  // The impulses are on b: the middle disc receives the first and gives the second.
  const Vec2 striker = 2.0 * (velocity(run, 0) - Vec2{2.0, 0.0}), last = 2.0 * velocity(run, 2);
  BOOST_TEST(norm(of_first + striker) < 1e-12);
  BOOST_TEST(norm(of_last - last) < 1e-12);
  BOOST_TEST(norm(of_first - of_last - 2.0 * velocity(run, 1)) < 1e-12);
  // The striker turns counter-clockwise: where it touches, it moves up past the other, which slips back along the
  // tangent. Friction drives the other along.
  const RecordedImpact& strike =
      run.log.impacts()[0].contact == ContactId{0} ? run.log.impacts()[0] : run.log.impacts()[1];
  BOOST_TEST(strike.slip_before < -1.0);
  BOOST_TEST(strike.tangential_impulse > 0.0);
}

BOOST_AUTO_TEST_CASE(a_log_that_is_restored_within_an_impact_continues_to_the_same_rows) {
  const Scene scene = struck(false);
  const Dynamics dynamics{scene.model};
  const Run whole{scene};
  ImpactLog first{dynamics}, second{dynamics};
  long step = 0;
  bool acted = false;
  const Observer halves = [&](const Snapshot& snapshot, const StepInfo& info) {
    if (step++ < 2600) return first(snapshot, info);
    if (step == 2601) {
      Archive saved;
      first.serialize(saved);
      acted = !first.impacts().empty() && !first.impacts().back().ended;
      Archive restored{saved.items()};
      second.serialize(restored);
      BOOST_TEST(restored.left_over().empty());
    }
    second(snapshot, info);
  };
  RigidBodySystem system{dynamics, false};
  Integrator integrator = make_integrator("velocity_verlet");
  State state = scene.initial;
  static_cast<void>(simulate(system, integrator, state, scene.plan, {&halves, 1}));
  BOOST_TEST(acted);
  BOOST_TEST_REQUIRE(second.impacts().size() == whole.log.impacts().size());
  Archive expected, found;
  ImpactLog copy{whole.log};
  copy.serialize(expected), second.serialize(found);
  BOOST_TEST((expected.items() == found.items()));
}

BOOST_AUTO_TEST_CASE(damaged_archives_are_refused) {
  const Scene scene = struck(false);
  Run run{scene};
  Archive saved;
  run.log.serialize(saved);
  const auto refuses = [&](const char* item, std::vector<double> with, const char* message) {
    ArchiveItems items = saved.items();
    items[item] = std::move(with);
    Archive archive{items};
    ImpactLog log{run.dynamics};
    BOOST_CHECK_EXCEPTION(log.serialize(archive), InputError, [&](const InputError& error) {
      BOOST_TEST(std::string{error.what()} == message);
      return true;
    });
  };
  refuses("impacts", {1.0}, "impacts: found 1 numbers; it must be whole rows of 16");
  std::vector<double> row(16, 0.0);
  row[0] = 2.0;
  refuses("impacts", row, "impacts: found 2; it must be a whole number from 0 to below 2");
  row[0] = 0.0, row[2] = 0.5;
  refuses("impacts", row, "impacts: found 0.5; it must be a whole number from 0 to below 2");
  refuses("acting", {1.0, 2.0}, "acting: found 2 numbers; it must be whole rows of 12");
  std::vector<double> acting(12, 0.0);
  acting[0] = 1e3;
  const std::string rows = std::to_string(run.log.impacts().size());
  refuses("acting", acting, ("acting: found 1000; it must be a whole number from 0 to below " + rows).c_str());
  acting[0] = 0.0, acting[1] = -1.0;
  refuses("acting", acting, "acting: found -1; it must be a whole number from 0 to below 2");
  refuses("motions", {1.0}, "motions: found 1 numbers; it must have 9");
  refuses("overlaps", {}, "overlaps: found 0 numbers; it must have 2");
}

BOOST_AUTO_TEST_SUITE_END()
