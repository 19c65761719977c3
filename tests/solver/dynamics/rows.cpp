#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "solver/dynamics/dynamics.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/advance.hpp"
#include "solver/model/model_builder.hpp"

BOOST_AUTO_TEST_SUITE(rows_tests)

using namespace talus;

namespace {

/// Ends of a row of cables that are tied to the world.
struct Ties {
  bool first{}, last{};
};

struct Hung {
  Model model;
  std::vector<std::array<Vec2, 2>> p_B;  ///< ends of the two rows at each body
};

/// Bodies side by side, tied together by an upper and a lower row of cables.
Hung hung(std::size_t bodies, Ties ties, const CableLaw& law, std::mt19937& random) {
  std::uniform_real_distribution<double> some{-0.3, 0.3};
  ModelBuilder builder;
  Hung made;
  std::vector<BodyId> ids;
  for (std::size_t i = 0; i < bodies; ++i) {
    ids.push_back(builder.add(Body{.name = std::to_string(i),
                                   .mass = 1.0 + some(random),
                                   .inertia = 1.0 + some(random),
                                   .p_WB = {some(random), some(random)},
                                   .angle = 0.2 * some(random)}));
    made.p_B.push_back({Vec2{some(random), 1.0 + some(random)}, Vec2{some(random), -1.0 + some(random)}});
  }
  for (std::size_t row = 0; row < 2; ++row) {
    int number = 0;
    const auto end = [&](std::size_t i) {
      const Vec2 p = made.p_B[i][row];
      return CableEnd{ids[i], {p.x, p.y, static_cast<double>(i)}};
    };
    const auto tie = [&](const CableEnd& a, const CableEnd& b) {
      builder.add(Cable{.name = std::to_string(row) + "." + std::to_string(number++),
                        .a = a,
                        .b = b,
                        .rest_length = 1.1 + some(random),
                        .law = law});
    };
    const double height = row == 0 ? 1.0 : -1.0;
    if (ties.first) tie({std::nullopt, {0.1, height, -1.0}}, end(0));
    for (std::size_t i = 0; i + 1 < bodies; ++i)
      tie(end(i), end(i + 1));
    if (ties.last) tie(end(bodies - 1), {std::nullopt, {-0.1, height, static_cast<double>(bodies)}});
  }
  made.model = builder.build();
  return made;
}

/// Force of one cable at its end A, computed separately.
Vec2 pull(const Cable& cable, const Layout& layout, const State& state, Mode mode) {
  const auto of = [&](const CableEnd& end) {
    Pose at{in_plane(end.p), {}, {}, 0.0};
    if (end.body) {
      const double* const q = &state.q[layout.first[index(*end.body)]];
      const double* const v = &state.v[layout.first[index(*end.body)]];
      const Pose body{{q[0], q[1]}, rotation(q[2]), {v[0], v[1]}, v[2]};
      at.p_WB = world_point(body, in_plane(end.p));
      at.v_WB = velocity_at(body, at.p_WB);
    }
    return at;
  };
  const Pose a = of(cable.a), b = of(cable.b);
  const double across = cable.b.p.z - cable.a.p.z;
  const Path line = path(a.p_WB, a.v_WB, b.p_WB, b.v_WB, across * across);
  return std::visit(
      [&](const auto& law) {
        using L = std::decay_t<decltype(law)>;
        const std::array<double, L::memory_size> memory{};
        return law({line.length - cable.rest_length, line.length_rate}, memory, mode).total() * line.pull_A;
      },
      cable.law);
}

}  // namespace

BOOST_AUTO_TEST_CASE(rows_of_any_length_pull_as_their_cables_do_one_by_one) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> some{-0.3, 0.3};
  for (const CableLaw& law : {CableLaw{TensionOnly{50.0, 1.0}}, CableLaw{ElasticPlastic{.stiffness = 80.0}}}) {
    for (const Ties ties : {Ties{false, false}, Ties{true, false}, Ties{false, true}, Ties{true, true}}) {
      for (std::size_t bodies = 2; bodies <= 19; ++bodies) {
        const Hung scene = hung(bodies, ties, law, random);
        const Dynamics dynamics{scene.model};
        State state = rest_state(scene.model);
        for (double& q : state.q)
          q += some(random);
        for (double& v : state.v)
          v = some(random);
        // Rotated by more than an eighth of a turn, by many turns, and beyond the range of the series.
        if (bodies % 3 == 0) state.q[2] += 2.0, state.q[5] -= 40.0;
        if (bodies % 5 == 0) state.q[3 * bodies - 1] += 2e5;
        Workspace work = dynamics.workspace();
        Rates rates{state};
        dynamics.update(state, work);
        dynamics.update_modes(state, work);
        // In the modes that were just updated, laws with linear branches remain on them.
        dynamics.update(state, work);
        BOOST_TEST(work.active.on_linear_branch == std::holds_alternative<ElasticPlastic>(law));
        dynamics.rates(state, work, rates);

        Workspace bare = dynamics.workspace();
        Rates alone{state};
        dynamics.update(state, bare, Need::rates);
        BOOST_TEST(bare.pulled == work.active.on_linear_branch);
        dynamics.rates(state, bare, alone);
        BOOST_TEST(alone.v == rates.v);
        BOOST_TEST(alone.work == rates.work);
        BOOST_TEST(alone.impulse == rates.impulse);  // of the anchors, too

        std::vector<Wrench> wrenches(bodies);
        for (std::size_t c = 0; c < scene.model.cables.size(); ++c) {
          const Cable& cable = scene.model.cables[c];
          const Layout& layout = dynamics.layout();
          const Vec2 force = pull(cable, layout, state, state.mode[layout.cable_slots[c].mode]);
          for (const auto& [end, sign] : {std::pair{cable.a, 1.0}, std::pair{cable.b, -1.0}}) {
            if (!end.body) continue;
            Wrench& wrench = wrenches[index(*end.body)];
            const Vec2 arm = rotation(state.q[3 * index(*end.body) + 2]) * in_plane(end.p);
            wrench.force += sign * force;
            wrench.moment += cross(arm, sign * force);
          }
        }
        for (std::size_t i = 0; i < bodies; ++i) {
          const Body& body = scene.model.bodies[i];
          const Rotation turned = rotation(state.q[3 * i + 2]);
          BOOST_TEST(work.poses.cosine[i] == turned.cosine);
          BOOST_TEST(work.poses.sine[i] == turned.sine);
          // Some dozen operations on forces of up to 100, each rounded to 1e-16 relative.
          BOOST_TEST(std::abs(rates.v[3 * i] - wrenches[i].force.x / body.mass) < 1e-12);
          BOOST_TEST(std::abs(rates.v[3 * i + 1] - wrenches[i].force.y / body.mass) < 1e-12);
          BOOST_TEST(std::abs(rates.v[3 * i + 2] - wrenches[i].moment / body.inertia) < 1e-12);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(cables_that_go_slack_and_yield_move_the_same_with_and_without_recorded_paths) {
  std::mt19937 random{11};
  for (const std::size_t bodies : {3UL, 8UL, 13UL}) {
    const Hung scene = hung(bodies, {true, true}, ElasticPlastic{.stiffness = 80.0, .yield = 40.0}, random);
    const Dynamics dynamics{scene.model};
    RigidBodySystem with{dynamics, true}, without{dynamics, false};
    Workspace work = dynamics.workspace();
    State with_state = rest_state(scene.model);
    for (std::size_t i = 0; i < with_state.v.size(); ++i)
      with_state.v[i] = i % 2 == 0 ? 1.5 : -1.0;
    with.begin(with_state);
    State bare = with_state, recorded = with_state;
    Rates rates{recorded};
    long changes = 0;
    for (int n = 0; n < 4000; ++n) {
      const std::vector<Mode> before = with_state.mode;
      with.kick(with_state, 1e-3), with.drift(with_state, 1e-3);
      without.kick(bare, 1e-3), without.drift(bare, 1e-3);
      dynamics.update(recorded, work), dynamics.update_modes(recorded, work);
      dynamics.rates(recorded, work, rates);
      kick_velocities(recorded, rates, 1e-3), drift_coordinates(recorded, 1e-3);
      changes += with_state.mode == before ? 0 : 1;
      if (with_state.q != bare.q || with_state.v != bare.v || with_state.mode != bare.mode || with_state != recorded)
        BOOST_FAIL("they part at step " << n);
    }
    BOOST_TEST(changes > 20);
    BOOST_TEST(changes < 3000);  // most steps change no mode, and evaluate no path
  }
}

BOOST_AUTO_TEST_SUITE_END()
