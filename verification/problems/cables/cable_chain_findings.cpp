#include "verification/problems/cables/cable_findings.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// Point of a chain: a broken hanger of a body, in body coordinates, or an anchor.
struct ChainPoint {
  std::optional<Body> body;
  Vec3 p;  ///< [m]
};

struct ChainCable {
  double rest{};  ///< [m]
  ElasticPlastic law;
};

/// Order in which the cables are listed; the ends of cable c are exchanged if bit c of `turned` is set.
struct Listing {
  std::vector<std::size_t> order;
  unsigned turned{};
};

/// Result for a chain past its broken hangers.
struct LaidChain {
  std::vector<double> tensions;  ///< of the cables [N]
  std::vector<Vec2> positions;   ///< positions of the points [m]
  double lost{};                 ///< energy recorded as lost by breaking cables [J]
};

Body hung(const char* name, double x, int multiplicity = 1) {
  return {.name = name, .mobility = Mobility::particle, .mass = 1.0, .p_WB = {x, -1.0}, .multiplicity = multiplicity};
}

LaidChain laid(const std::vector<ChainPoint>& points, const std::vector<ChainCable>& cables, const Listing& listing,
               int multiplicity = 1) {
  SceneBuilder builder;
  std::vector<CableEnd> ends;
  for (const ChainPoint& point : points)
    ends.push_back({point.body ? std::optional{builder.add(*point.body)} : std::nullopt, point.p});
  const auto turned = [&](std::size_t c) { return listing.turned >> c & 1U; };
  for (const std::size_t c : listing.order)
    builder.add(Cable{.name = fmt::format("cable{}", c),
                      .a = ends[c + turned(c)],
                      .b = ends[c + 1 - turned(c)],
                      .rest_length = cables[c].rest,
                      .law = cables[c].law,
                      .multiplicity = multiplicity});
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].body) builder.add(Hanger{"at " + points[i].body->name, *ends[i].body, points[i].p, 1.0});
  const Model model = builder.build();
  const Dynamics dynamics{model};
  State state = rest_state(model);
  std::fill_n(state.mode.begin() + static_cast<std::ptrdiff_t>(dynamics.layout().first_hanger), model.hangers.size(),
              Mode{1});
  Workspace work = dynamics.workspace();
  dynamics.update(state, work);
  dynamics.update_modes(state, work);
  const Snapshot seen{dynamics, state};
  LaidChain found;
  found.positions.resize(points.size());
  found.lost = state.work[static_cast<std::size_t>(Mechanism::cable_break)];
  for (std::size_t c = 0; c < cables.size(); ++c) {
    const std::size_t cable = index(*find_cable(model, fmt::format("cable{}", c)));
    const auto [a, b] = dynamics.cables().ends()[cable];
    found.tensions.push_back(seen.forces().tensions[cable]);
    found.positions[c + turned(c)] = seen.geometry().joints.p_WP(a);
    found.positions[c + 1 - turned(c)] = seen.geometry().joints.p_WP(b);
  }
  return found;
}

/// Three cables of different length and stiffness, and their total compliance [m/N] and rest length [m].
const std::vector<ChainCable> three{
    {3.0, {.stiffness = 100.0}}, {4.0, {.stiffness = 50.0}}, {2.0, {.stiffness = 200.0}}};
constexpr double compliance_of_three = 1.0 / 100.0 + 1.0 / 50.0 + 1.0 / 200.0, rest_of_three = 9.0;

std::vector<ChainPoint> line_of_four(Vec2 to) {
  return {{{}, {}}, {hung("first", 3.0), {}}, {hung("second", 7.0), {}}, {{}, {to.x, to.y, 0.0}}};
}

/// Tension, and positions of the massless points between the cables, in every order and with either end first.
void check_listings(Findings& findings) {
  const Vec2 to{10.0, 3.0};
  const double length = norm(to), tension = (length - rest_of_three) / compliance_of_three;
  double force_error = 0.0, position_error = 0.0;
  Listing listing{.order = {0, 1, 2}};
  do {
    for (listing.turned = 0; listing.turned < 8; ++listing.turned) {
      const LaidChain found = laid(line_of_four(to), three, listing);
      double along = 0.0;
      for (std::size_t c = 0; c < 3; ++c) {
        keep_worst(force_error, found.tensions[c] - tension);
        along += three[c].rest + tension / three[c].law.stiffness;
        keep_worst(position_error, norm(found.positions[c + 1] - along / length * to));
      }
    }
  } while (std::next_permutation(listing.order.begin(), listing.order.end()));
  findings.expect_round_off("tension of three cables past broken hangers, largest error over 48 listing orders",
                            force_error, 0.0, 1.5e-13,
                            "a dozen roundings of lengths near 10 m, 5.1e-16 m rms, times the stiffness of 29 N/m: "
                            "5e-14 as a random walk, three times that",
                            "N");
  findings.expect_round_off(
      "positions of the points between three cables past broken hangers, largest error over 48 listing orders",
      position_error, 0.0, 1e-14, "a dozen roundings of lengths near 10 m", "m");
}

/// Chain at a plane of symmetry: the body in the plane represents only itself, the cables and the next body represent
/// two. Both hangers are broken, so the cables run straight along the fence to their mirror image and exert no force
/// across it.
void check_mirror_image(Findings& findings) {
  const std::vector<ChainCable> two{{3.0, {.stiffness = 100.0}}, {4.0, {.stiffness = 50.0}}};
  const double from = 1.0, to = 10.0;  // along the fence
  const double tension = (to - from - 7.0) / (1.0 / 100.0 + 1.0 / 50.0);
  const std::vector<ChainPoint> points{
      {hung("middle", 0.0), {0.0, 0.0, from}}, {hung("next", 0.5, 2), {0.0, 0.0, 4.0}}, {{}, {0.0, 3.0, to}}};
  double force_error = 0.0, position_error = 0.0;
  for (const std::vector<std::size_t>& order : {std::vector<std::size_t>{0, 1}, {1, 0}}) {
    for (unsigned turned = 0; turned < 4; ++turned) {
      const LaidChain found = laid(points, two, {order, turned}, 2);
      for (const double t : found.tensions)
        keep_worst(force_error, t - tension);
      for (const Vec2 position : found.positions)
        keep_worst(position_error, norm(position - Vec2{0.0, 3.0}));
    }
  }
  findings.expect_round_off(
      "tension of two cables past broken hangers up to a plane of symmetry, largest error over 8 listing orders",
      force_error, 0.0, 1.8e-13,
      "a dozen roundings of lengths near 10 m, 5.1e-16 m rms, times the stiffness of 33 N/m: 6e-14 as a random walk, "
      "three times that",
      "N");
  findings.expect_exact(
      "positions of the points of two cables along the fence past broken hangers, largest error over 8 listing orders",
      position_error, 0.0,
      "the cables run straight along the fence: in the plane, all points coincide with the last one", "m");
}

/// The middle cable is loaded beyond its strength: all cables lose their tension at once, and their stored energy,
/// T^2/2 times the sum of their compliances, is lost.
void check_break_within(Findings& findings) {
  const double length = 10.0, tension = (length - rest_of_three) / compliance_of_three;
  std::vector<ChainCable> cables = three;
  cables[1].law.strength = 0.999 * tension;
  const LaidChain found = laid(line_of_four({length, 0.0}), cables, {.order = {0, 1, 2}});
  double left = 0.0;
  for (const double t : found.tensions)
    keep_worst(left, t);
  findings.expect_exact("largest tension in a chain after the break of its middle cable", left, 0.0,
                        "no cable of a broken chain carries tension", "N");
  findings.expect_round_off("energy loss when the middle cable of a chain breaks", found.lost,
                            0.5 * tension * tension * compliance_of_three, 1e-13,
                            "a dozen roundings of lengths near 10 m, 5.1e-16 m rms, times the tension of 29 N: 5e-14 "
                            "as a random walk, twice that",
                            "J");
}

}  // namespace

void check_chains(Findings& findings) {
  const auto group = findings.in("chains");
  check_listings(findings);
  check_mirror_image(findings);
  check_break_within(findings);
}

}  // namespace talus::verification::problems
