#include <random>

#include "verification/problems/cables/cable_findings.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// Cable end in the check's separate list: a body of the net, or an anchor.
struct NetEnd {
  std::optional<std::size_t> body;
  Vec2 position;  ///< position [m]
};

struct NetCable {
  NetEnd a, b;
  double rest{}, stiffness{};
};

struct Net {
  std::vector<Vec2> positions;  ///< positions of the bodies [m]
  std::vector<double> masses;   ///< [kg]
  std::vector<NetCable> cables;
};

/// Pseudo-random numbers from a seed, the same on every machine, which the distributions of the standard library do not
/// guarantee.
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

/// Adds cables from each of `count` bodies to the next, with or without an anchor before the first and after the last.
/// Occasionally the ends of a cable are exchanged, or two cables exchange their positions in the list.
void add_chain(Net& net, std::size_t first, std::size_t count, NetDraw& draw) {
  std::vector<NetEnd> points;
  const auto anchor = [&](std::size_t beside) {
    return NetEnd{std::nullopt, net.positions[beside] + Vec2{draw.between(-2.0, 2.0), draw.between(0.5, 2.0)}};
  };
  if (draw.below(2) == 0) points.push_back(anchor(first));
  for (std::size_t i = first; i < first + count; ++i)
    points.push_back({i, net.positions[i]});
  if (draw.below(2) == 0) points.push_back(anchor(first + count - 1));
  const std::size_t begin = net.cables.size();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    NetCable cable{points[i], points[i + 1], 0.0, draw.between(10.0, 100.0)};
    // A quarter of the cables are slack.
    cable.rest = norm(cable.b.position - cable.a.position) * draw.between(0.7, 1.1);
    if (draw.below(8) == 0) std::swap(cable.a, cable.b);
    net.cables.push_back(cable);
  }
  const std::size_t added = net.cables.size() - begin;
  if (added > 1 && draw.below(4) == 0)
    std::swap(net.cables[begin + draw.below(added)], net.cables[begin + draw.below(added)]);
}

/// Net of two to four chains over consecutive bodies; a chain may begin at the last body of the previous one.
Net drawn_net(NetDraw& draw) {
  Net net;
  const std::size_t chains = 2 + draw.below(3);
  for (std::size_t c = 0; c < chains; ++c) {
    const bool shared = !net.positions.empty() && draw.below(3) == 0;
    const std::size_t first = shared ? net.positions.size() - 1 : net.positions.size();
    const std::size_t count = 2 + draw.below(6);
    while (net.positions.size() < first + count) {
      net.positions.push_back({static_cast<double>(net.positions.size()), draw.between(-1.0, 1.0)});
      net.masses.push_back(draw.between(1.0, 3.0));
    }
    add_chain(net, first, count, draw);
  }
  return net;
}

Model model_of(const Net& net) {
  SceneBuilder builder;
  std::vector<BodyId> bodies;
  for (std::size_t i = 0; i < net.positions.size(); ++i)
    bodies.push_back(builder.add_particle(fmt::format("body{}", i), net.masses[i], net.positions[i]));
  const auto end = [&](const NetEnd& e) {
    return e.body ? CableEnd{bodies[*e.body], {}} : CableEnd{{}, {e.position.x, e.position.y, 0.0}};
  };
  for (std::size_t c = 0; c < net.cables.size(); ++c) {
    const NetCable& cable = net.cables[c];
    builder.add_cable(fmt::format("cable{}", c), end(cable.a), end(cable.b), cable.rest, TensionOnly{cable.stiffness});
  }
  return builder.build();
}

/// Accelerations of the bodies [m/s^2] from the tension k (l - l0) of each taut cable.
std::vector<Vec2> accelerations(const Net& net, const std::vector<Vec2>& at) {
  std::vector<Vec2> found(at.size());
  for (const NetCable& cable : net.cables) {
    const Vec2 from = cable.a.body ? at[*cable.a.body] : cable.a.position;
    const Vec2 to = cable.b.body ? at[*cable.b.body] : cable.b.position;
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
      std::vector<Vec2> at(net.positions.size());
      for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] = net.positions[i] + Vec2{draw.between(-0.1, 0.1), draw.between(-0.1, 0.1)};
        state.q[2 * i] = at[i].x, state.q[2 * i + 1] = at[i].y;
      }
      Rates rates{state};
      dynamics.evaluate(state, work, rates, false);
      const std::vector<Vec2> expected = accelerations(net, at);
      for (std::size_t i = 0; i < at.size(); ++i)
        keep_worst(worst, norm(Vec2{rates.v[2 * i], rates.v[2 * i + 1]} - expected[i]));
    }
  }
  findings.expect_round_off({"nets", "accelerations of bodies in 200 nets of cables, largest error"}, worst, 0.0,
                            1.3e-13,
                            "forces of up to 100 N with a dozen roundings of at most 7e-15 N each, three of them on a "
                            "body of at least 1 kg: 4e-14 as a random walk, three times that",
                            "m/s^2");
}

}  // namespace talus::verification::problems
