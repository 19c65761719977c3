#include "solver/app/calibration/impact_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "solver/app/calibration/impact_bodies.hpp"
#include "solver/app/calibration/law_options.hpp"

namespace talus::app {
namespace {

/// Quoted quantities of a scene, from values in SI units.
class Quantities {
 public:
  explicit Quantities(const UnitSystem& units) : units_{units} {}
  std::string operator()(double in_si, Dimension dimension) const {
    return fmt::format("\"{} {}\"", in_si / si_size(units_, dimension), symbol(units_, dimension));
  }
  std::string pair(double x, double y, Dimension dimension) const {
    return fmt::format("[{}, {}]", (*this)(x, dimension), (*this)(y, dimension));
  }

 private:
  const UnitSystem& units_;
};

/// Radius of discs, and half width of plates, over the largest overlap. While a plate turns in the contact, the point
/// of contact moves by this radius times the angle, which changes the effective mass: the smaller, the better.
constexpr double radius_over_overlap = 30.0;

}  // namespace

std::string impact_scene(const CalibrateOptions& options, const ImpactSceneRequest& request, const UnitSystem& units) {
  const Quantities quantity{units};
  const ImpactBodies bodies = bodies_of(options);
  const double radius = radius_over_overlap * request.largest_overlap;
  const double flight = 0.5 * request.contact_time, gap = flight * request.speed;
  // A contact that ends before the outlines part leaves an overlap, less than the largest one. Impacts of nearly no
  // restitution are not followed to their end.
  const double parting = request.largest_overlap / (std::max(request.restitution, 0.01) * request.speed);
  const auto disc = [&](int number, double mass, double x, double speed) {
    return fmt::format(
        "[[body]]\nname = \"body_{}\"\nmobility = \"particle\"\nmass = {}\nshape = {{ kind = \"circle\", radius = {} "
        "}}\n"
        "position = {}\nvelocity = {}\n",
        number, quantity(mass, dimension::mass), quantity(radius, dimension::length),
        quantity.pair(x, 0.0, dimension::length), quantity.pair(speed, 0.0, dimension::velocity));
  };
  const bool is_struck = bodies.first.has_value();  // body 2, by body 1
  std::string text = fmt::format(
      "# body_1 and body_2 meet with {} and part: `talus run FILE --impacts --out FOLDER` prints the restitution. It\n"
      "# differs from that of the calibration by at most the error of the step. Sizes and distances are free: radii "
      "are\n"
      "# {:g} times the largest overlap, and the bodies meet after half a contact time.\n"
      "title = \"Impact of a calibration\"\nunits = \"{}\"\n",
      quantity(request.speed, dimension::velocity), radius_over_overlap, options.units);
  if (is_struck) {
    text += disc(1, bodies.first->mass, -radius - gap, request.speed);
  } else {
    text += "[[body]]\nname = \"body_1\"\nmobility = \"fixed\"\n";
    text += bodies.second.inertia
                ? fmt::format("shape = {{ kind = \"circle\", radius = {} }}\nposition = {}\n",
                              quantity(radius, dimension::length), quantity.pair(-radius - gap, 0.0, dimension::length))
                : fmt::format("shape = {{ kind = \"half_plane\" }}\nposition = {}\nangle = \"-90 deg\"\n",
                              quantity.pair(-gap, 0.0, dimension::length));
  }
  const ContactSide& second = bodies.second;
  const double speed = is_struck ? 0.0 : -request.speed;
  if (second.inertia) {
    // A plate of the height 4 arm, hit on its left side.
    const double arm = second.arm;
    text += fmt::format(
        "[[body]]\nname = \"body_2\"\nmobility = \"{}\"\nmass = {}\ninertia = {}\nshape = {{ kind = \"rectangle\", "
        "half_width = {}, half_height = {} }}\nposition = {}\n",
        second.pinned ? "pinned" : "free", quantity(second.mass, dimension::mass),
        quantity(*second.inertia, dimension::inertia), quantity(radius, dimension::length),
        quantity(2.0 * arm, dimension::length), quantity.pair(radius, -arm, dimension::length));
    text += second.pinned ? fmt::format("pin = {}\nspin = {}\n", quantity.pair(0.0, 0.0, dimension::length),
                                        quantity(-speed / arm, dimension::angular_velocity))
                          : fmt::format("velocity = {}\n", quantity.pair(speed, 0.0, dimension::velocity));
  } else {
    text += disc(2, second.mass, radius, speed);
  }
  return text + "[[contact]]\nname = \"impact\"\nbetween = [\"body_1\", \"body_2\"]\n" +
         scene_lines(request.law, units) +
         fmt::format(
             "[run]\nintegrator = \"{}\"\nstep = {}\nend = {}\n"
             "# The step is as long as the restitution allows; the energy within the contact may be off by more.\n"
             "watch = \"off\"\n",
             options.integrator, quantity(request.step, dimension::time),
             quantity(flight + request.contact_time + parting + 10.0 * request.step, dimension::time));
}

}  // namespace talus::app
