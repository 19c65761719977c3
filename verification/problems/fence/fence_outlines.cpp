#include <variant>

#include "solver/geometry/shape.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/problems/fence/fence_layouts.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::fence_layouts {

/// Checks rock outlines given by a power, and ground that is not level.
void check_outlines(Findings& findings) {
  scenes::Fence fence = fence_of_today();
  scenes::FenceElement& rock = fence.rocks[0];
  rock.power = 1.0;
  const auto outline = [&](scenes::FenceContact contact) {
    fence.options.contact = contact;
    const Model model = scenes::fence_scene(fence).scene.model;
    return model.bodies[index(*find_body(model, "rock"))].shape;
  };
  // Nodes of 1993: at the centres of twelve equal angles.
  const std::vector<Vec2> nodes = boundary_nodes(outline(scenes::FenceContact::nodes), 12);
  double apart = nodes.size() == 12 ? 0.0 : std::nan("");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double angle = (static_cast<double>(i) + 0.5) * std::numbers::pi / 6.0;
    keep_worst(apart, norm(nodes[i] - rock.a * Vec2{std::cos(angle), std::sin(angle)}) / rock.a);
  }
  findings.expect_round_off(
      "nodes of a circular superquadric outline, largest distance from the middles of twelve equal angles", apart, 0.0,
      1e-15, "a sine or cosine, a product and a square root");
  findings.expect_true("circular superquadric outline replaced by a circle for contact by resultant",
                       std::holds_alternative<Circle>(outline(scenes::FenceContact::resultant)),
                       "the gaps of circles have closed forms");
  fence.ground.angle = 0.3;  // of the level surface, which the profile replaces
  fence.ground_profile = {{-50.0, -6.0}, {50.0, -2.0}};
  fence.options.contact = scenes::FenceContact::resultant;
  const Scene scene = scenes::fence_scene(fence).scene;
  Probe probe{scene.model};
  probe.evaluate(first_state(scene));
  const double slope = 4.0 / 100.0, over = rock.position.y - (-4.0 + slope * rock.position.x);
  findings.expect_round_off("distance of the rock from a ground profile in world coordinates",
                            -probe.overlap(index(*find_contact(scene.model, "rock-ground"))),
                            over / std::hypot(1.0, slope) - rock.a, 1e-14, "a dozen operations on lengths of 50 ft",
                            "ft");
}

/// Checks which columns a rock can hit in a full fence: those within half their spacing of it, two if it is midway
/// between them. The spacings differ from 2 in any unit.
void check_reach(Findings& findings) {
  scenes::Fence fence = fence_of_today();
  fence.options.symmetry = scenes::FenceSymmetry::full;
  double wrong = 0.0;
  for (const double spacing : {2.5, 3.5}) {
    fence.spacing = spacing;
    for (const double spacings : {0.0, 0.3, 0.49, 0.5, 0.51, 1.0, 1.5, -0.5, -2.4, -2.5}) {
      fence.rocks[0].along = spacings * spacing;
      const Model model = scenes::fence_scene(fence).scene.model;
      for (int i = -6; i <= 6; ++i) {
        const std::string name = i < 0 ? fmt::format("rock-column-{}", 1 - i) : fmt::format("rock-column{}", 1 + i);
        const bool within = std::abs(spacings - i) <= 0.5;
        wrong += find_contact(model, name).has_value() == within ? 0.0 : 1.0;
      }
    }
  }
  findings.expect_exact("columns wrongly within or out of reach of a rock between two columns", wrong, 0.0,
                        "a count over thirteen columns, ten positions of the rock and two spacings");
}

}  // namespace talus::verification::problems::fence_layouts
