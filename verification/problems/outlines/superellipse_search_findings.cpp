#include <random>

#include "solver/dynamics/candidates.hpp"
#include "verification/problems/outlines/superellipse_findings.hpp"
#include "verification/reference/outlines/overlap.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

using reference::Outline;
using reference::OutlineKind;

/// A shape in the forms of solver and reference.
struct Kind {
  const char* name;
  Shape shape;
  Outline outline;
};

const std::array kinds{
    Kind{"circle", Circle{0.8}, {OutlineKind::circle, {0.8, 0.8, 2.0}, 0.0, 0.0, 0.0}},
    Kind{"rectangle", Rectangle{1.2, 0.3}, {OutlineKind::rectangle, {1.2, 0.3, 2.0}, 0.0, 0.0, 0.0}},
    Kind{
        "superquadric n = 2", Superquadric{0.4, 1.0, 2.0}, {OutlineKind::superellipse, {0.4, 1.0, 2.0}, 0.0, 0.0, 0.0}},
    Kind{"superquadric n = 20",
         Superquadric{0.5, 1.1, 20.0},
         {OutlineKind::superellipse, {0.5, 1.1, 20.0}, 0.0, 0.0, 0.0}},
    Kind{"half_plane", HalfPlane{}, {OutlineKind::half_plane, {}, 0.0, 0.0, 0.0}}};

/// Sets bodies to random positions; solver and reference get the same positions.
class RandomPositions {
 public:
  explicit RandomPositions(double reach) : coordinate_{-reach, reach} {}
  void put(Outline& outline) {
    outline.x = coordinate_(random_);
    outline.y = coordinate_(random_);
    outline.angle = angle_(random_);
  }

 private:
  std::mt19937_64 random_{20};
  std::uniform_real_distribution<double> coordinate_, angle_{-std::numbers::pi, std::numbers::pi};
};

Pose pose_of(const Outline& outline) { return {{outline.x, outline.y}, rotation(outline.angle), {}, 0.0}; }

/// Results of the search for one pair of shapes: numbers of positions.
struct Searched {
  int touching{}, apart{};
  int left_out_touching{}, left_out_apart{};
};

Searched search_pairs(const Kind& a, const Kind& b, const Setup& setup) {
  Candidate pair{BodyId{0}, BodyId{1}, bounds(a.shape), bounds(b.shape), 0, 0};
  if (setup.has("boxes_too_small")) pair.bounds_a.half_width *= 0.9;
  RandomPositions positions{3.0};
  Outline A = a.outline, B = b.outline;
  Searched found;
  for (int i = 0; i < (setup.coarse ? 300 : 2000); ++i) {
    positions.put(A);
    positions.put(B);
    const bool touches = reference::overlap_by_points(A, B, 64);
    const bool left_out = out_of_reach(pair, pose_of(A), pose_of(B));
    ++(touches ? found.touching : found.apart);
    if (left_out) ++(touches ? found.left_out_touching : found.left_out_apart);
  }
  return found;
}

/// A scene of six randomly placed bodies, any of which may touch each other and the ground.
Model random_scene(RandomPositions& positions) {
  SceneBuilder builder;
  std::vector<BodyId> ids;
  std::vector<const Kind*> of;
  for (std::size_t i = 0; i < 7; ++i) {
    const Kind& kind = i == 6 ? kinds.back() : kinds[i % 4];
    Outline outline = kind.outline;
    positions.put(outline);
    Body body{.name = fmt::format("body{}", i), .mass = 1.0, .inertia = 1.0, .shape = kind.shape};
    body.mobility = i == 6 ? Mobility::fixed : Mobility::free;
    body.p_WB = {outline.x, i == 6 ? -2.0 : outline.y};
    body.angle = i == 6 ? 0.1 : outline.angle;
    ids.push_back(builder.add(body));
    of.push_back(&kind);
  }
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t j = i + 1; j < 7; ++j) {
      const bool circle = i % 4 == 0 || (j % 4 == 0 && j < 6);
      const bool by_nodes = !circle && j < 6 && (i + j) % 2 == 1;
      builder.add(Contact{.name = fmt::format("contact{}-{}", i, j),
                          .a = ids[i],
                          .b = ids[j],
                          .law = LinearSpringDashpot{1.0, 0.0},
                          .method = by_nodes ? ContactMethod::nodes : ContactMethod::resultant});
    }
  }
  return builder.build();
}

/// Overlap of two outlines as computed for their contact.
double pair_depth(const Kind& a, const Outline& A, const Kind& b, const Outline& B, const Setup& setup) {
  SceneBuilder builder;
  const auto add = [&](const Kind& kind, const Outline& at, const char* name) {
    Shape shape = kind.shape;
    if (auto* outline = std::get_if<Superquadric>(&shape); outline && setup.has("pair_exponent_off"))
      outline->exponent *= 1.05;
    return builder.add(
        Body{.name = name, .mass = 1.0, .inertia = 1.0, .shape = shape, .p_WB = {at.x, at.y}, .angle = at.angle});
  };
  const BodyId one = add(a, A, "one"), other = add(b, B, "other");
  builder.add_contact("contact", one, other, LinearSpringDashpot{1.0, 0.0});
  const Model model = builder.build();
  record_use(model);
  const Dynamics dynamics{model};
  Workspace work = dynamics.workspace();
  dynamics.update_all(rest_state(model), work);
  return dynamics.contact_depth(work, ContactId{0});
}

}  // namespace

void check_pairs(Findings& findings, const Setup& setup) {
  double worst_inside = 0.0, worst_apart = 0.0, minimum = 0.0;
  constexpr int count = 900;
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t j = std::max<std::size_t>(i, 2); j < 4; ++j) {
      RandomPositions positions{1.2};
      for (int n = 0; n < (setup.coarse ? 1 : 3); ++n) {
        Outline A = kinds[i].outline, B = kinds[j].outline;
        positions.put(A), positions.put(B);
        const double brute = reference::minimum_displacement(A, B, count);
        const double found = pair_depth(kinds[i], A, kinds[j], B, setup);
        double& worst = brute > 0.0 ? worst_inside : worst_apart;
        keep_largest(worst, found - brute);
        minimum = std::min(minimum, brute);
      }
    }
  }
  findings.expect_truncation(
      {"pair_overlap", "overlap of pairs of superellipses and rectangles: largest error against brute force"},
      worst_inside, 0.0, 6.1e-6, 2.0,
      "boundary points spaced by 2 pi/900 of the parametric angle, between which chords cut off up to (2 pi/900)^2/8 = "
      "6.1e-6 of the half axis of 1 m for n = 2, and 2.2e-6 m for n = 20; twice that for both outlines",
      "m");
  findings.expect_truncation(
      {"pair_distance", "distance of pairs of superellipses and rectangles: largest error against brute force"},
      worst_apart, 0.0, 6.1e-6, 2.0, "the distance of the same polygons: as for the overlap", "m");
}

void check_search(Findings& findings, const Setup& setup) {
  Table table{.name = "search",
              .caption =
                  "2000 random pairs of each combination of shapes: number of touching pairs by brute force, of "
                  "touching pairs that the search omits, of separate pairs, and of separate pairs that it omits.",
              .columns = {"A", "B", "touching", "omitted", "separate", "omitted"}};
  int left_out_touching = 0, left_out_apart = 0, apart = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (std::size_t j = i; j < kinds.size(); ++j) {
      if (i + 1 == kinds.size()) continue;
      const Searched found = search_pairs(kinds[i], kinds[j], setup);
      left_out_touching += found.left_out_touching;
      left_out_apart += found.left_out_apart;
      apart += found.apart;
      table.rows.push_back(cells("{} | {} | {} | {} | {} | {}", kinds[i].name, kinds[j].name, found.touching,
                                 found.left_out_touching, found.apart, found.left_out_apart));
    }
  }
  findings.expect_exact({"omitted_touching", "touching pairs omitted by the contact search"}, left_out_touching, 0.0,
                        "the bounding box of a touching shape cannot be separated from that of the other shape");
  findings.expect_between({"omitted_separate", "fraction of separate pairs omitted by the contact search"},
                          static_cast<double>(left_out_apart) / apart, 0.8, 1.0,
                          "a search that omits nothing would always pass the previous check; the separate pairs that "
                          "it may not omit are those whose boxes overlap at their corners");
  if (!setup.coarse) findings.table(table);
}

void check_scenes(Findings& findings, const Setup& setup) {
  RandomPositions positions{2.5};
  int differing = 0;
  double touching = 0.0;
  const int count = setup.coarse ? 20 : 200;
  for (int i = 0; i < count; ++i) {
    const Model model = random_scene(positions);
    record_use(model);
    const Dynamics dynamics{model};
    Workspace searched = dynamics.workspace(), whole = dynamics.workspace();
    State a = rest_state(model), b = a;
    dynamics.update(a, searched);
    dynamics.update_modes(a, searched);
    dynamics.update_all(b, whole);
    dynamics.update_modes(b, whole);
    Rates of_a{a}, of_b{b};
    dynamics.rates(a, searched, of_a);
    dynamics.rates(b, whole, of_b);
    if (a.mode != b.mode || of_a.v != of_b.v) ++differing;
    for (const Mode mode : a.mode)
      touching += mode != 0 ? 1.0 / count : 0.0;
  }
  findings.expect_exact(
      {"unculled_scenes", "random scenes whose contacts or accelerations differ if no pair is omitted"}, differing, 0.0,
      "the same operations on the touching pairs");
  findings.note(fmt::format("On average {:.1f} contact laws act in a random scene.", touching));
}

}  // namespace talus::verification::problems
