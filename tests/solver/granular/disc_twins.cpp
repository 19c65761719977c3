#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>

#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/laws/law_list.hpp"
#include "tests/solver/laws/law_examples.hpp"

BOOST_AUTO_TEST_SUITE(disc_twins_tests)

using namespace talus;

namespace {

constexpr double step = 1e-3;

/// Random draws that are the same on every platform, unlike the distributions of the standard library.
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : random_{seed} {}
  std::size_t below(std::size_t count) { return random_() % count; }
  double within(double size) { return size * (static_cast<double>(random_()) / 2147483648.0 - 1.0); }

 private:
  std::mt19937 random_;
};

struct Scene {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
  double skin{};
};

/// A row of wall discs; in the middle of their numbers is a free disc, above or below the wall.
void add_wall(Scene& scene, Draw& draw, std::size_t wall, std::size_t side, double y, Vec2 v) {
  for (std::size_t i = 0; i < side; ++i) {
    const double x = 2.35 * (static_cast<double>(i) - 0.5 * static_cast<double>(side - 1));
    if (i == side / 2) {
      scene.shapes.add(0.9, 1.0);
      scene.discs.add(x, y > 0.0 ? y + 2.1 : y - 2.1, draw.within(1.0), draw.within(1.0));
    }
    scene.shapes.add(1.0, 0.0, wall);
    scene.discs.add(x, y, v.x, v.y);
  }
}

/// Colliding discs, of equal or different size, in one of four boxes; in some scenes with a wall above them that is
/// driven or moved by forces, and one below that falls freely, numbered before or after the discs.
Scene drawn(Draw& draw) {
  constexpr std::size_t side = 7;
  Scene scene;
  const std::size_t box = draw.below(4);
  const double spacing = draw.below(3) == 0 ? 2.02 : 2.35, unlike = draw.below(2) == 0 ? 0.0 : 0.1;
  if (box > 0) scene.box.width = 2.35 * side;
  if (box > 1) scene.box.height = 2.35 * side;
  if (box > 2) scene.box.shear_rate = 0.3;
  scene.skin = draw.below(2) == 0 ? 0.5 : 1.2;
  const bool walls = box < 2 && draw.below(3) > 0, first = draw.below(2) == 0;
  const double middle = 0.5 * static_cast<double>(side - 1), edge = 2.35 * (middle + 1.0);
  std::size_t above = 0, below = 0;
  if (walls) {
    above = scene.shapes.add(DiscWall{.mass = draw.below(2) == 0 ? 0.0 : 20.0, .gravity = 1.0});
    below = scene.shapes.add(DiscWall{.mass = 50.0, .gravity = 0.5});
  }
  const auto add_above = [&] {
    add_wall(scene, draw, above, side, edge, {0.3, scene.shapes.walls[above - 1].mass > 0.0 ? -3.0 : 0.0});
  };
  if (walls && first) add_above();
  for (std::size_t i = 0; i < side * side; ++i) {
    const double radius = 1.0 + unlike * (draw.within(1.0) - 1.0);
    scene.shapes.add(radius, unlike > 0.0 ? 1.0 / (radius * radius) : 1.0);
    const double x = spacing * (static_cast<double>(i % side) - middle),
                 y = spacing * (static_cast<double>(i / side) - middle);
    scene.discs.add(x, y, draw.within(2.0) - 0.1 * x, draw.within(2.0) - 0.1 * y);
  }
  if (walls && !first) add_above();
  if (walls) add_wall(scene, draw, below, side, -edge, {});
  return scene;
}

/// A plain system and a fast one with a random number of threads that receive the same calls.
template <class L, class F>
class Twins {
 public:
  Twins(const Scene& scene, const L& law, const F& friction, Draw& draw)
      : scene_{scene}, law_{law}, friction_{friction}, draw_{draw}, keeps_{draw.below(2) == 0} {
    plain_.begin(theirs_);
    fast_ = made();
    fast_->begin(ours_);
  }

  /// Makes the next random call.
  void proceed() {
    const double h = draw_.below(2) == 0 ? step : step * (0.75 + draw_.within(0.25));
    switch (draw_.below(10)) {
      case 0:
        return kick(h);
      case 1:
        return drift(h);
      case 2:
        return evaluate();
      case 3:
        return plain_.update_modes(theirs_), fast_->update_modes(ours_);
      case 4:
        return put_back();
      default:
        return advance(h, 1 + static_cast<long>(draw_.below(20)));
    }
  }
  void kick(double h) { plain_.kick(theirs_, h), fast_->kick(ours_, h); }
  void drift(double h) { plain_.drift(theirs_, h), fast_->drift(ours_, h); }
  void advance(double h, long steps) {
    for (long n = 0; n < steps; ++n) {
      plain_.kick(theirs_, h), plain_.drift(theirs_, h);
      theirs_.t += h;
    }
    fast_->advance(ours_, h, steps);
  }
  void evaluate() {
    DiscRates theirs{theirs_}, ours{ours_};
    plain_.evaluate(theirs_, theirs), fast_->evaluate(ours_, ours);
    rates_ = rates_ && theirs.vx == ours.vx && theirs.vy == ours.vy && theirs.spin == ours.spin;
  }
  /// Saves the fast system, and restores it into another one.
  void put_back() {
    Archive saved;
    fast_->serialize(saved, ours_);
    contacts_ += saved_contacts(saved);
    prunings_ += fast_->prunings();
    fast_ = made();
    Archive archive{saved.items()};
    fast_->serialize(archive, ours_);
  }

  bool same() const {
    Discs theirs = theirs_;
    constexpr auto lost = static_cast<std::size_t>(L::dissipation);
    if (!keeps_) theirs.work = ours_.work;
    if (fast_->has_history) theirs.work[lost] = ours_.work[lost];
    const double loss = fast_->has_history ? theirs_.work[lost] : 0.0;
    return rates_ && theirs == ours_ && (loss == 0.0 || std::abs(fast_->lost() - loss) <= 1e-11 * loss);
  }
  bool same_walls() const {
    for (std::size_t wall = 1; wall <= scene_.shapes.walls.size(); ++wall)
      if (!(plain_.wall_force(wall) == fast_->wall_force(wall))) return false;
    return true;
  }
  long contacts() const { return contacts_; }  ///< number of contacts that were saved
  long prunings() const { return prunings_ + fast_->prunings(); }
  long plain_builds() const { return plain_.builds(); }
  long fast_builds() const { return fast_->builds(); }

 private:
  std::unique_ptr<FastDiscSystem<L, F>> made() {
    auto made = std::make_unique<FastDiscSystem<L, F>>(scene_.shapes, scene_.box, law_, scene_.skin, friction_,
                                                       1 + draw_.below(4));
    if (keeps_) made->keep_work();
    return made;
  }
  static long saved_contacts(const Archive& saved) {
    Archive archive{saved.items()};
    std::vector<double> first;
    archive.scope("contact", [&] { archive.list("first", first); });
    return static_cast<long>(first.size());
  }

  const Scene& scene_;
  L law_;
  F friction_;
  Draw& draw_;
  bool keeps_, rates_{true};
  long contacts_{}, prunings_{};
  DiscSystem<L, F> plain_{scene_.shapes, scene_.box, law_, scene_.skin, friction_};
  std::unique_ptr<FastDiscSystem<L, F>> fast_;
  Discs theirs_ = scene_.discs, ours_ = scene_.discs;
};

CoulombFriction example(CoulombFriction, double) { return {0.5, 2e3}; }
Mindlin example(Mindlin, double radius) { return {0.5, 3e3, radius}; }

/// Calls visit(law, friction) without friction and with each that the law can have.
template <Law L, class Visit>
void for_each_friction(const L& law, Visit&& visit) {
  visit(law, Frictionless{});
  DiscFrictions::for_each([&]<class F>(const F&) {
    if constexpr (CanHaveFriction<L, F>) {
      double radius = 0.0;
      if constexpr (HasContactRadius<L>) radius = law.radius;
      visit(law, example(F{}, radius));
    }
  });
}

template <class Visit>
void for_each_law_and_friction(Visit&& visit) {
  const auto with = [&](const auto& law) { for_each_friction(law, visit); };
  with(LinearSpringDashpot{4e3, 0.0}), with(LinearSpringDashpot{4e3, 3.0});
  with(LinearSpringDashpot{4e3, 3.0, EndRule::attractive});
  with(LatchingSpring{4e3, 8e3, 0.0}), with(LatchingSpring{4e3, 5e3, 2e-3});
  with(Hertz{8e3, 0.5, 5.0, EndRule::clamped, HertzDashpot::tsuji});
  with(Hertz{8e3, 0.5, 3.0, EndRule::attractive, HertzDashpot::constant});
  with(HuntCrossley{4e3, 0.05, 1.5, 0.05}), with(HuntCrossley{4e3, 0.05, 2.3, 0.05});
}

/// The examples of each law of discs, with forces scaled to the stiffness of the others.
template <class Visit>
void for_each_disc_law(Visit&& visit) {
  DiscLaws::for_each([&]<class L>(const L&) {
    for (L law : examples<L>()) {
      for (const auto& field : L::fields()) {
        const bool has_force = field.dimension.mass != 0;
        if (has_force) law.*field.member *= 500.0;
      }
      for_each_friction(law, visit);
    }
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_engines_give_the_same_results) {
  long saved = 0;
  for_each_law_and_friction([&](const auto& law, const auto& friction) {
    long prunings = 0;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
      Draw draw{seed};
      const Scene scene = drawn(draw);
      Twins twins{scene, law, friction, draw};
      bool same = true;
      for (int n = 0; n < 150 && same; ++n)
        twins.proceed(), same = twins.same();
      twins.advance(step, 1);
      BOOST_TEST_CONTEXT("seed " << seed) {
        BOOST_TEST(same);
        BOOST_TEST(twins.same());
        BOOST_TEST(twins.same_walls());
      }
      saved += twins.contacts(), prunings += twins.prunings();
    }
    BOOST_TEST(prunings > 500);
  });
  BOOST_TEST(saved > 5'000);
}

BOOST_AUTO_TEST_CASE(all_laws_of_discs_answer_the_same) {
  for_each_disc_law([&](const auto& law, const auto& friction) {
    for (std::uint32_t seed = 20; seed < 24; ++seed) {
      Draw draw{seed};
      const Scene scene = drawn(draw);
      Twins twins{scene, law, friction, draw};
      for (int n = 0; n < 60; ++n)
        twins.proceed();
      BOOST_TEST(twins.same());
      BOOST_TEST(twins.same_walls());
    }
  });
}

BOOST_AUTO_TEST_CASE(a_drift_may_come_before_all_else) {
  // Discs in contact, with friction, while pairs are listed that are not near: contacts have no index among the near
  // pairs.
  for_each_law_and_friction([](const auto& law, const auto& friction) {
    Scene scene{.shapes = {}, .discs = {}, .box = {}, .skin = 1.2};
    Draw draw{5};
    for (int i = 0; i < 100; ++i) {
      scene.shapes.add(1.0, 1.0);
      scene.discs.add(1.99 * (i % 10), 1.99 * (i / 10), draw.within(1.0), draw.within(1.0));
    }
    Twins twins{scene, law, friction, draw};
    twins.drift(0.5 * step);
    BOOST_TEST(twins.same());
    for (int n = 0; n < 300; ++n)
      twins.kick(step), twins.drift(0.5 * step), twins.drift(0.5 * step);
    BOOST_TEST(twins.same());
  });
}

BOOST_AUTO_TEST_CASE(a_wall_that_brakes_counts_as_fast_as_it_is_after_the_kick) {
  // A heavy wall is the fastest object, and slower after each step: its speed determines when lists are made, and so
  // the bits.
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    Draw draw{seed};
    Scene scene{.shapes = {}, .discs = {}, .box = {.width = 24.0}, .skin = 0.3};
    const std::size_t base = scene.shapes.add(DiscWall{}), top = scene.shapes.add(DiscWall{.mass = 20.0});
    for (int i = 0; i < 60; ++i) {
      scene.shapes.add(1.0, 1.0);
      scene.discs.add(2.35 * (i % 10 - 4.5) + draw.within(0.1), 2.5 * (i / 10), 2.0 + draw.within(0.05),
                      draw.within(0.05));
    }
    for (int i = 0; i < 12; ++i)
      scene.shapes.add(1.0, 0.0, base), scene.discs.add(2.0 * (i - 5.5), -2.5, 0.0, 0.0);
    for (int i = 0; i < 12; ++i)
      scene.shapes.add(1.0, 0.0, top), scene.discs.add(2.0 * (i - 5.5), 15.5, 0.3, -3.0);
    Twins twins{scene, LatchingSpring{4e3, 8e3, 0.0}, Frictionless{}, draw};
    for (int n = 0; n < 30; ++n) {
      twins.advance(step, 50);
      BOOST_REQUIRE(twins.plain_builds() == twins.fast_builds());
    }
    BOOST_TEST(twins.same());
    BOOST_TEST(twins.plain_builds() > 2);
  }
}

BOOST_AUTO_TEST_SUITE_END()
