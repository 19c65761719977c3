#include <fmt/format.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "solver/model/model_builder.hpp"
#include "solver/run/snapshot.hpp"
#include "verification/problems/cables/cable_findings.hpp"
#include "verification/study/expectations.hpp"

namespace talus::verification::problems {
namespace {

/// An end of a cable as the check lists it: a body of the net, or an anchor.
struct NetEnd {
  std::optional<std::size_t> body;
  Vec2 place;  ///< [m]
};

struct NetCable {
  NetEnd a, b;
  double rest{}, stiffness{};
};

struct Net {
  std::vector<Vec2> places;    ///< of the bodies [m]
  std::vector<double> masses;  ///< [kg]
  std::vector<NetCable> cables;
};

/// Draws of a seed, the same on every machine: the distributions of the standard library need not be.
class NetDraw {
 public:
  explicit NetDraw(unsigned seed) : engine_{seed} {}
  std::size_t below(std::size_t count) { return engine_() % count; }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }

 private:
  std::mt19937 engine_;
};

/// Adds cables from one body to the next, with an anchor before the first or after the last or without. Now and then a
/// cable is listed with its ends the other way round, or two cables change places.
void add_chain(Net& net, std::size_t first, std::size_t count, NetDraw& draw) {
  std::vector<NetEnd> points;
  const auto anchor = [&](std::size_t beside) {
    return NetEnd{std::nullopt, net.places[beside] + Vec2{draw.between(-2.0, 2.0), draw.between(0.5, 2.0)}};
  };
  if (draw.below(2) == 0) points.push_back(anchor(first));
  for (std::size_t i = first; i < first + count; ++i)
    points.push_back({i, net.places[i]});
  if (draw.below(2) == 0) points.push_back(anchor(first + count - 1));
  const std::size_t begin = net.cables.size();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    NetCable cable{points[i], points[i + 1], 0.0, draw.between(10.0, 100.0)};
    // A quarter of the cables are slack.
    cable.rest = norm(cable.b.place - cable.a.place) * draw.between(0.7, 1.1);
    if (draw.below(8) == 0) std::swap(cable.a, cable.b);
    net.cables.push_back(cable);
  }
  const std::size_t added = net.cables.size() - begin;
  if (added > 1 && draw.below(4) == 0)
    std::swap(net.cables[begin + draw.below(added)], net.cables[begin + draw.below(added)]);
}

/// Two to four chains over bodies that follow one another; the next may begin at the last body of the one before.
Net drawn_net(NetDraw& draw) {
  Net net;
  const std::size_t chains = 2 + draw.below(3);
  for (std::size_t c = 0; c < chains; ++c) {
    const bool shared = !net.places.empty() && draw.below(3) == 0;
    const std::size_t first = shared ? net.places.size() - 1 : net.places.size();
    const std::size_t count = 2 + draw.below(6);
    while (net.places.size() < first + count) {
      net.places.push_back({static_cast<double>(net.places.size()), draw.between(-1.0, 1.0)});
      net.masses.push_back(draw.between(1.0, 3.0));
    }
    add_chain(net, first, count, draw);
  }
  return net;
}

Model model_of(const Net& net) {
  ModelBuilder builder;
  std::vector<BodyId> bodies;
  for (std::size_t i = 0; i < net.places.size(); ++i)
    bodies.push_back(builder.add(Body{.name = fmt::format("body{}", i),
                                      .mobility = Mobility::particle,
                                      .mass = net.masses[i],
                                      .p_WB = net.places[i]}));
  const auto end = [&](const NetEnd& e) {
    return e.body ? CableEnd{bodies[*e.body], {}} : CableEnd{{}, {e.place.x, e.place.y, 0.0}};
  };
  for (std::size_t c = 0; c < net.cables.size(); ++c) {
    const NetCable& cable = net.cables[c];
    builder.add(Cable{.name = fmt::format("cable{}", c),
                      .a = end(cable.a),
                      .b = end(cable.b),
                      .rest_length = cable.rest,
                      .law = TensionOnly{cable.stiffness}});
  }
  return builder.build();
}

/// Accelerations of the bodies [m/s^2] from k (l - l0) along each cable that is taut.
std::vector<Vec2> accelerations(const Net& net, const std::vector<Vec2>& at) {
  std::vector<Vec2> found(at.size());
  for (const NetCable& cable : net.cables) {
    const Vec2 from = cable.a.body ? at[*cable.a.body] : cable.a.place;
    const Vec2 to = cable.b.body ? at[*cable.b.body] : cable.b.place;
    const double length = norm(to - from), tension = std::max(0.0, cable.stiffness * (length - cable.rest));
    const Vec2 pull = tension / length * (to - from);
    if (cable.a.body) found[*cable.a.body] += 1.0 / net.masses[*cable.a.body] * pull;
    if (cable.b.body) found[*cable.b.body] -= 1.0 / net.masses[*cable.b.body] * pull;
  }
  return found;
}

}  // namespace

void check_nets(Findings& findings) {
  constexpr int nets = 200, moves = 3;
  NetDraw draw{1};
  double worst = 0.0;
  for (int n = 0; n < nets; ++n) {
    const Net net = drawn_net(draw);
    const Model model = model_of(net);
    const Dynamics dynamics{model};
    Workspace work = dynamics.workspace();
    State state = rest_state(model);
    for (int move = 0; move < moves; ++move) {
      std::vector<Vec2> at(net.places.size());
      for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] = net.places[i] + Vec2{draw.between(-0.1, 0.1), draw.between(-0.1, 0.1)};
        state.q[2 * i] = at[i].x, state.q[2 * i + 1] = at[i].y;
      }
      Rates rates{state};
      dynamics.evaluate(state, work, rates, false);
      const std::vector<Vec2> expected = accelerations(net, at);
      for (std::size_t i = 0; i < at.size(); ++i)
        keep_worst(worst, norm(Vec2{rates.v[2 * i], rates.v[2 * i + 1]} - expected[i]));
    }
  }
  findings.expect("accelerations of bodies in 200 nets of cables, worst", worst, 0.0,
                  Tolerance::round_off(1e-12,
                                       "forces of up to 100 N, a dozen roundings each, and a few of them at "
                                       "a body of at least 1 kg"),
                  "m/s^2");
}

/// Behind a plane of symmetry: the body in the plane hangs there once, the cable and the next body stand for two. Both
/// hangers are broken, so the cables run straight along the fence to their mirror image and pull nothing out of that.
void check_mirrored_chain(Findings& findings) {
  const double rest[] = {3.0, 4.0}, stiff[] = {100.0, 50.0};
  const double from = 1.0, to = 10.0;  // along the fence
  const double tension = (to - from - 7.0) / (1.0 / stiff[0] + 1.0 / stiff[1]);
  double force_error = 0.0, place_error = 0.0;
  for (unsigned listing = 0; listing < 8; ++listing) {
    ModelBuilder builder;
    const BodyId middle =
        builder.add(Body{.name = "middle", .mobility = Mobility::particle, .mass = 1.0, .p_WB = {0.0, -1.0}});
    const BodyId next = builder.add(
        Body{.name = "next", .mobility = Mobility::particle, .mass = 1.0, .p_WB = {0.5, -1.0}, .copies = 2});
    const CableEnd ends[] = {{middle, {0.0, 0.0, from}}, {next, {0.0, 0.0, 4.0}}, {{}, {0.0, 3.0, to}}};
    for (const std::size_t place : {0U, 1U}) {
      const std::size_t c = (listing & 1U) != 0 ? 1 - place : place;
      const bool other_way = (listing >> (c + 1) & 1U) != 0;
      builder.add(Cable{.name = fmt::format("cable{}", c),
                        .a = ends[other_way ? c + 1 : c],
                        .b = ends[other_way ? c : c + 1],
                        .rest_length = rest[c],
                        .law = ElasticPlastic{.stiffness = stiff[c]},
                        .copies = 2});
    }
    builder.add(Hanger{"hanger0", middle, {0.0, 0.0, from}, 1.0});
    builder.add(Hanger{"hanger1", next, {0.0, 0.0, 4.0}, 1.0});
    const Model model = builder.build();
    const Dynamics dynamics{model};
    State state = rest_state(model);
    for (std::size_t h = 0; h < 2; ++h)
      state.mode[dynamics.layout().first_hanger + h] = 1;
    Workspace work = dynamics.workspace();
    dynamics.update(state, work);
    dynamics.settle(state, work);
    const Snapshot seen{dynamics, state};
    for (std::size_t c = 0; c < 2; ++c)
      keep_worst(force_error, seen.forces().tensions[index(*find_cable(model, fmt::format("cable{}", c)))] - tension);
    for (std::size_t j = 0; j < dynamics.cables().joints().size(); ++j)
      keep_worst(place_error, norm(seen.geometry().joints.p_WP(j) - Vec2{0.0, 3.0}));
  }
  const auto group = findings.in("chains");
  findings.expect("tension of two cables past broken hangers to their mirror image, worst of 8 listings", force_error,
                  0.0, Tolerance::round_off(1e-12, "a hundred times roundings of lengths of ten"), "N");
  findings.expect("places of the points of two cables past broken hangers, seen along them, worst of 8 listings",
                  place_error, 0.0, Tolerance::exact("all are where the last one is"), "m");
}

/// Three unlike cables past two broken hangers, of which the middle one is pulled beyond its strength: all let go at once,
/// and the energy that they stored, T^2/2 times the sum of their compliances, is lost.
void check_parted_chain(Findings& findings) {
  const double rest[] = {3.0, 4.0, 2.0}, stiff[] = {100.0, 50.0, 200.0};
  const double length = 10.0, compliance = 1.0 / stiff[0] + 1.0 / stiff[1] + 1.0 / stiff[2];
  const double tension = (length - 9.0) / compliance;
  ModelBuilder builder;
  std::array<BodyId, 2> bodies{};
  for (std::size_t i = 0; i < 2; ++i)
    bodies[i] = builder.add(Body{.name = i == 0 ? "first" : "second",
                                 .mobility = Mobility::particle,
                                 .mass = 1.0,
                                 .p_WB = {3.0 + 4.0 * static_cast<double>(i), -1.0}});
  const CableEnd ends[] = {{{}, {}}, {bodies[0], {}}, {bodies[1], {}}, {{}, {length, 0.0, 0.0}}};
  for (std::size_t c = 0; c < 3; ++c)
    builder.add(
        Cable{.name = fmt::format("cable{}", c),
              .a = ends[c],
              .b = ends[c + 1],
              .rest_length = rest[c],
              .law = ElasticPlastic{.stiffness = stiff[c], .strength = c == 1 ? 0.999 * tension : 10.0 * tension}});
  for (const BodyId body : bodies)
    builder.add(Hanger{fmt::format("hanger{}", index(body)), body, {}, 1.0});
  const Model model = builder.build();
  const Dynamics dynamics{model};
  State state = rest_state(model);
  for (std::size_t h = 0; h < 2; ++h)
    state.mode[dynamics.layout().first_hanger + h] = 1;
  Workspace work = dynamics.workspace();
  dynamics.update(state, work);
  dynamics.settle(state, work);
  const Snapshot seen{dynamics, state};
  double left = 0.0;
  for (const double t : seen.forces().tensions)
    keep_worst(left, t);
  const auto group = findings.in("chains");
  findings.expect("tension in a chain after its middle cable broke, largest", left, 0.0,
                  Tolerance::exact("all are loose"), "N");
  findings.expect("energy loss when the middle cable of a chain breaks",
                  state.work[static_cast<std::size_t>(Mechanism::cable_break)], 0.5 * tension * tension * compliance,
                  Tolerance::round_off(1e-13, "a hundred roundings of lengths of ten, times 30 N"), "J");
}

}  // namespace talus::verification::problems
