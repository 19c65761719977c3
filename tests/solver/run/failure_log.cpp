/// Each failure is found once, with the time of the step after which it is first visible, by modes or by memory alone.
#include "solver/run/failure_log.hpp"

#include <boost/test/unit_test.hpp>

#include "solver/model/model_builder.hpp"

BOOST_AUTO_TEST_SUITE(failure_log_tests)

using namespace talus;

namespace {

/// Two cables that may yield and break, from the origin to a particle.
Model two_cables() {
  ModelBuilder builder;
  const BodyId bob = builder.add(Body{.name = "bob", .mobility = Mobility::particle, .mass = 1.0, .p_WB = {0.0, -1.0}});
  for (const char* name : {"first", "second"})
    builder.add(Cable{.name = name,
                      .a = {bob, {}},
                      .b = {std::nullopt, {}},
                      .rest_length = 1.0,
                      .law = ElasticPlastic{.stiffness = 1.0, .yield = 1.0, .strength = 2.0}});
  return builder.build();
}

struct Observed {
  Model model = two_cables();
  Dynamics dynamics{model};
  FailureLog log{dynamics};
  State state = rest_state(model);

  std::size_t step(double time) {
    state.t = time;
    log(state, {});
    return log.failures().size();
  }
  Slot slot(std::size_t cable) const { return dynamics.layout().cable_slots[cable]; }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_cable_that_yielded_within_a_step_is_found_by_its_memory) {
  Observed run;
  run.state.mode[run.slot(1).mode] = ElasticPlastic::taut;
  BOOST_TEST(run.step(1.0) == 0);
  run.state.z[run.slot(1).memory] = 0.25;  // and taut again at the end of the step
  BOOST_TEST(run.step(2.0) == 1);
  BOOST_TEST(run.log.failures()[0].part == "cable 'second'");
  BOOST_TEST(run.log.failures()[0].what == "yields");
  BOOST_TEST(run.log.failures()[0].time == 2.0);
  run.state.z[run.slot(1).memory] = 0.5;
  BOOST_TEST(run.step(3.0) == 1);  // only once
  run.state.z[run.slot(0).memory] = 0.5;
  BOOST_TEST(run.step(4.0) == 2);  // the other cable can still yield
}

BOOST_AUTO_TEST_CASE(a_cable_that_breaks_is_found_by_its_mode) {
  Observed run;
  BOOST_TEST(run.step(0.0) == 0);
  run.state.mode[run.slot(0).mode] = ElasticPlastic::yielding;
  BOOST_TEST(run.step(1.0) == 1);
  run.state.mode[run.slot(0).mode] = ElasticPlastic::broken;
  BOOST_TEST(run.step(2.0) == 2);
  BOOST_TEST(run.log.failures()[1].part == "cable 'first'");
  BOOST_TEST(run.log.failures()[1].what == "breaks");
  BOOST_TEST(run.log.failures()[1].time == 2.0);
}

BOOST_AUTO_TEST_CASE(a_failure_of_the_first_state_is_found) {
  Observed run;
  run.state.mode[run.slot(0).mode] = ElasticPlastic::broken;
  BOOST_TEST(run.step(0.0) == 1);
}

BOOST_AUTO_TEST_SUITE_END()
