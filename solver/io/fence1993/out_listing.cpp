#include "solver/io/fence1993/out_listing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <vector>

#include "solver/io/fence1993/fence_codes.hpp"
#include "solver/io/file/fortran.hpp"
#include "solver/io/file/quantity_text.hpp"

namespace talus {
namespace {

using scenes::Fence;
using scenes::FenceElement;
using scenes::FenceMember;
using scenes::FenceScene;

/// Writes the part of the listing before the states.
class Head {
 public:
  Head(const Fence& fence, const FenceScene& made, const RunPlan& plan) : fence_{fence}, made_{made}, plan_{plan} {}

  std::string text() {
    line("{}\n", fence_.title);
    control();
    const auto elements = numbered_elements();
    for (std::size_t i = 0; i < elements.size(); ++i)
      properties(i + 1, *elements[i]);
    initial_conditions(elements);
    fixities(elements);
    parameter_names();
    fence_data();
    masses();
    contacts();
    time_step();
    return text_;
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }
  /// A number in the deck's unit.
  double deck(double value, Dimension dimension) const {
    const std::string unit = deck_unit(dimension);
    if (fence_.units == us && dimension != dimension::area && dimension != dimension::pressure) return value;
    return std::strtod(decimal(value, unit, dimension, fence_.units).text.c_str(), nullptr);
  }
  std::string e3(double value, Dimension dimension) const { return fortran_e(deck(value, dimension), 3); }
  std::string e4(double value, Dimension dimension) const { return fortran_e(deck(value, dimension), 4); }
  std::string g3(double value, Dimension dimension) const { return fortran_g(deck(value, dimension), 3); }

  std::vector<const FenceElement*> numbered_elements() const {
    std::vector<const FenceElement*> list{&fence_.ground};
    for (const FenceElement& rock : fence_.rocks)
      list.push_back(&rock);
    list.push_back(&fence_.column);
    return list;
  }

  void control();
  void properties(std::size_t number, const FenceElement& e);
  void initial_conditions(const std::vector<const FenceElement*>& elements);
  void fixities(const std::vector<const FenceElement*>& elements);
  void parameter_names();
  void fence_data();
  void masses();
  void contacts();
  void time_step();

  const Fence& fence_;
  const FenceScene& made_;
  const RunPlan& plan_;
  std::string text_;
};

void Head::control() {
  line("factor of critical time step = {}", fortran_e(fence_.step_factor, 3));
  line("total no. of time steps      = {}", fence_.steps);
  line("time steps per printout      = {}", fence_.print_every);
  line("history time steps           = {}\n", fence_.history_every);
  line("no. of discrete elements       = {}", fence_.rocks.size() + 2);
  line("igrav (=1 for positive y-dir.) = {}", fence_.gravity_sign);
  line("gravity                        = {}\n", e4(fence_.gravity, dimension::acceleration));
  line("no. of elements for time history records = {}\n", fence_.history_elements.size());
  line("element history array:\n");
  line("{}\n", fmt::join(fence_.history_elements, " "));
  line("no. of variables to be stored (max. 8) = {}\n", fence_.history_codes.size());
  line("list of variables to be stored:");
  line("(see pointers defined in global.par)\n");
  line("{}\n", fmt::join(fence_.history_codes, " "));
}

void Head::properties(std::size_t number, const FenceElement& e) {
  line("Properties for element no.: {}", number);
  line("Type ( rock=0, fence=1 )       = {}", static_cast<int>(e.type));
  line("Shape                          = {}", static_cast<int>(e.solid));
  line("( sphere or                )");
  line("( ellipsoid (rock)      = 0)");
  line("( rectang. block (rock) = 1)");
  line("( cylinder (fence)      = 2)");
  line("Number of points on superquad  = {}", e.points);
  line("Length in x-dir. (large radius)= {}", e3(e.a, dimension::length));
  line("Length in y-dir. (short radius)= {}", e3(e.b, dimension::length));
  line("Power of superquad             = {}", fortran_e(e.power, 3));
  line("Mass density                   = {}", e3(e.density, dimension::density));
  line("Attachment length (fence only) = {}\n", e3(e.bar_length, dimension::length));
}

void Head::initial_conditions(const std::vector<const FenceElement*>& elements) {
  line("Element initial conditions\n");
  line("{:>4}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}", "el.", "x-loc", "y-loc", "theta", "vx", "vy",
       "ang-v", "fx", "fy", "mz");
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const FenceElement& e = *elements[i];
    line("{:>4}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}", i + 1, e3(e.position.x, dimension::length),
         e3(e.position.y, dimension::length), e3(e.angle, dimension::angle), e3(e.velocity.x, dimension::velocity),
         e3(e.velocity.y, dimension::velocity), e3(e.spin, dimension::angular_velocity),
         e3(e.force.x, dimension::force), e3(e.force.y, dimension::force), e3(e.moment, dimension::moment));
  }
  line("");
}

void Head::fixities(const std::vector<const FenceElement*>& elements) {
  line("Element fixities\n");
  line("{:>4}{:>7}{:>7}{:>7}{:>11}{:>11}", "el.", "fix-x", "fix-y", "fix-r", "x_local", "y_local");
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const FenceElement& e = *elements[i];
    line("{:>4}{:>7}{:>7}{:>7}{:>11}{:>11}", i + 1, static_cast<int>(e.held[0]), static_cast<int>(e.held[1]),
         static_cast<int>(e.held[2]), e3(e.fixed_point.x, dimension::length), e3(e.fixed_point.y, dimension::length));
  }
  line("");
}

void Head::parameter_names() {
  line("Description of Parameter Names in Element Data Structure\n");
  line("I.D number Description\n");
  for (const FenceCode& code : fence_codes())
    line("{:>6}     {}", code.number, code.title);
  line("");
}

void Head::fence_data() {
  line("Fence Support Data Parameters\n");
  line("Horizontal cable span                = {}", g3(fence_.span, dimension::length));
  line("Vertical cable sag                   = {}", g3(fence_.sag, dimension::length));
  line("Horizontal distance between columns  = {}", g3(fence_.spacing, dimension::length));
  line("Youngs modulus of cable              = {}", g3(fence_.young, dimension::pressure));
  line("y-coordinate of top cable connection = {}", g3(fence_.y_top, dimension::length));
  line("y-coordinate of bottom cable connection = {}", g3(fence_.y_bottom, dimension::length));
  line("No. of top/bottom connections on fence = {}", fence_.connections);
  line("No. of tire columns in fence layer   = {}", fence_.columns);
  line("coefficient of restitution           = {}", fortran_g(fence_.restitution, 3));
  line("x-section area of top cable          = {}", g3(fence_.area_top, dimension::area));
  line("x-section area of bottom cable       = {}", g3(fence_.area_bottom, dimension::area));
  line("coefficient of friction              = {}", fortran_g(fence_.friction, 3));
  line("slack in between bottom connections  = {}", g3(fence_.slack, dimension::length));
  line("top cable breaking strength          = {}", g3(fence_.limit_top, dimension::force));
  line("bottom cable breaking strength       = {}\n", g3(fence_.limit_bottom, dimension::force));
  line("No. of fence layers = {}", fence_.layers);
  line("gap between fence layers = {}\n", g3(fence_.layer_spacing, dimension::length));
  line("Maximum overlap (rock/fence)  = {}", e4(fence_.rock_overlap, dimension::length));
  line("Maximum overlap (fence/fence) = {}\n", e4(fence_.layer_overlap, dimension::length));
  for (int layer = 1; layer <= fence_.layers; ++layer) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < made_.members.size(); ++i) {
      if (made_.members[i].layer == layer && made_.members[i].body) numbers.push_back(i + 1);
    }
    line("Element I.Ds of attenuators in fence layer: {}\n", layer);
    line("I.D nos. = {}\n", fmt::join(numbers, " "));
  }
}

void Head::masses() {
  line("{:>8}{:>12}{:>12}\n", "element", "mass", "m.o.i.");
  for (std::size_t i = 0; i < made_.members.size(); ++i) {
    const FenceMember& member = made_.members[i];
    line("{:>8}{:>12}{:>12}", i + 1, e4(member.mass, dimension::mass), e4(member.inertia, dimension::inertia));
  }
  line("");
}

void Head::contacts() {
  // Both lines print the overlap of two layers, even the one below the stiffness of rock and fence, which is computed
  // with the rock/fence overlap (0.6 in the deck that the manual shows, 0.5 in its listing).
  const std::string penetration = e4(fence_.layer_overlap, dimension::length);
  line("Normal contact stiffness (rock/fence) = {}\n", e4(made_.rock_column.stiffness, dimension::stiffness));
  line("Maximum fence penetration = {}\n", penetration);
  if (fence_.layers > 1) {
    line("Normal contact stiffness (fence/fence) = {}\n", e4(made_.column_column.stiffness, dimension::stiffness));
    line("Maximum fence penetration = {}\n", penetration);
  }
  line("Normal contact stiffness (ground/rock) = {}\n", e4(made_.rock_ground.stiffness, dimension::stiffness));
}

void Head::time_step() {
  line("Information: S/R chekdt - time step = {}\n", e3(plan_.step, dimension::time));
  line("note, max. stable time step = {}\n", e3(made_.critical_step, dimension::time));
  line("max time step governed by axial stiffnesses\n");
  line("of element no. = {}\n", fence_.rocks.size() + 2);
}

/// Coordinates and velocities of an element, world; a fixed end has its position and zero velocities, as in 1993.
struct Kinematics1993 {
  Vec2 p;
  double angle{};
  Vec2 v;
  double spin{};
};

Kinematics1993 kinematics_of(const FenceMember& member, const Model& model, const State& state) {
  if (!member.body || model.bodies[index(*member.body)].mobility == Mobility::fixed)
    return {member.position, member.angle, {}, 0.0};
  const Pose at = pose(model, state, *member.body);
  return {at.p_WB, angle(model, state, *member.body), at.v_WB, at.w_WB};
}

}  // namespace

OutListing::OutListing(const Fence& fence, const FenceScene& made, const RunPlan& plan)
    : fence_{&fence}, made_{&made}, text_{Head{fence, made, plan}.text()} {}

void OutListing::operator()(const State& state, const StepInfo& info) {
  of_stop_.clear();
  const bool due = info.step % fence_->print_every == 0;
  if (info.step == 0 || (!due && !info.stop)) return;
  std::string& text = due ? text_ : of_stop_;
  const auto out = std::back_inserter(text);
  const double feet = si_size(fence_->units, dimension::length) / si_size(us, dimension::length);
  fmt::format_to(out, "time = {} secs\n\n", fortran_e(state.t, 3));
  fmt::format_to(out, "{:>4}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "el.", "x", "y", "theta", "vx", "vy", "ang-v");
  for (std::size_t i = 0; i < made_->members.size(); ++i) {
    const Kinematics1993 k = kinematics_of(made_->members[i], made_->scene.model, *info.held);
    fmt::format_to(out, "{:>4}", i + 1);
    for (const double value : {feet * k.p.x, feet * k.p.y, k.angle, feet * k.v.x, feet * k.v.y, k.spin})
      fmt::format_to(out, "{:>11}", fortran_e(value, 3));
    text += '\n';
  }
  text += '\n';
}

}  // namespace talus
