#include "verification/problems/fence/sample2_variants.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "verification/problems/fence/sample2_print.hpp"

namespace talus::verification::problems {
namespace {

using scenes::Fence;
using scenes::FenceScene;

const char* name_of(Mark mark) {
  constexpr std::array names{"proved", "inferred", "fitted", "unknown"};
  return names[static_cast<std::size_t>(mark)];
}

Sample2Change of_records(std::function<void(Fence&)> change) { return {std::move(change), {}}; }

/// Another rule for nodes in the columns: of the rock (`rock`), or of the other layer's.
Sample2Change of_node_depth(bool rock, NodeDepth rule) {
  return {{}, [rock, rule](FenceScene& made) {
            for (Contact& contact : made.scene.model.contacts) {
              const bool of_rock = contact.name.rfind("rock", 0) == 0;
              if (of_rock == rock && contact.name != "rock-ground") contact.node_depth = rule;
            }
          }};
}

/// Columns as true rectangles with their corners as nodes.
void sharpen(FenceScene& made) {
  for (Body& body : made.scene.model.bodies) {
    if (const auto* outline = std::get_if<Superquadric>(&body.shape); outline && outline->exponent > 2.0)
      body.shape = Rectangle{outline->half_width, outline->half_height};
  }
  for (Contact& contact : made.scene.model.contacts)
    contact.node_depth = NodeDepth::nearest;
}

/// Dashpots of the nodes times a factor.
void scale_dashpots(FenceScene& made, double factor) {
  for (Contact& contact : made.scene.model.contacts)
    std::get<LinearSpringDashpot>(contact.law).damping *= factor;
}

/// Top cables of stiffness E A over the unstretched length, of the same tension at the start.
void unstretch(FenceScene& made) {
  const Model& model = made.scene.model;
  for (Cable& cable : made.scene.model.cables) {
    if (cable.name.find("top") == std::string::npos) continue;
    const Vec3 a = reference_point(model, cable.a), b = reference_point(model, cable.b);
    const double length = std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
    double& stiffness = std::get<ElasticPlastic>(cable.law).stiffness;
    const double tension = stiffness * (length - cable.rest_length);
    stiffness += tension / length;  // E A/L0 = (E A + T)/l
    cable.rest_length = length - tension / stiffness;
  }
}

/// The step of the rule with E A over the unstretched length of the central column's segment.
void shorten_step(FenceScene& made) {
  const Cable& first = made.scene.model.cables[index(*made.members[2].top)];
  const Vec3 a = reference_point(made.scene.model, first.a), b = reference_point(made.scene.model, first.b);
  made.scene.plan.step *= std::sqrt(first.rest_length / std::hypot(b.x - a.x, b.y - a.y, b.z - a.z));
}

void add_starts(std::vector<Sample2Rule>& rules) {
  rules.push_back({"contact forces of the first touch act for half a step before the start", Mark::inferred,
                   "App. II.5.2, element 3", "no kick",
                   of_records([](Fence& f) { f.options.start = scenes::FenceStart::plain; })});
  rules.push_back({"a touch without overlap, as at the start, is a contact", Mark::inferred, "Eq. 17: delta >= 0",
                   "rock 1e-9 ft further away", of_records([](Fence& f) { f.rocks[0].position.x += 1e-9; })});
  rules.push_back({"dashpots see the velocities of one step before", Mark::inferred,
                   "Eqs. 19, 23, 24; App. II.5.2, parameters 26-28", "those of the half step before the forces",
                   of_records([](Fence& f) { f.options.integrator = "central_difference"; })});
}

void add_outlines(std::vector<Sample2Rule>& rules) {
  const auto power = [](double value) { return of_records([value](Fence& f) { f.column.power = value; }); };
  rules.push_back({"power 0 of a column stands for .1, exponent 20", Mark::fitted, "Eq. 1; App. II.5.1", "exponent 40",
                   power(0.05)});
  rules.push_back({"", Mark::fitted, "", "exponent 10", power(0.2)});
  rules.push_back({"four nodes of a column, at parametric 45 degrees", Mark::fitted, "App. II.4: points = 2",
                   "eight nodes", of_records([](Fence& f) { f.column.points = 3; })});
  rules.push_back({"", Mark::fitted, "", "a rectangle with nodes at its corners, nearest side", {{}, sharpen}});
  rules.push_back({"twelve nodes of the rock", Mark::proved, "App. II.4: points = 4; App. II.5.2, rock",
                   "sixteen nodes", of_records([](Fence& f) { f.rocks[0].points = 5; })});
  rules.push_back({"", Mark::proved, "", "eight nodes", of_records([](Fence& f) { f.rocks[0].points = 3; })});
}

void add_contacts(std::vector<Sample2Rule>& rules) {
  rules.push_back({"nodes of the rock: depth below the side face", Mark::inferred, "section 3.5; App. II.5.2, rock",
                   "to the nearest point of the outline", of_node_depth(true, NodeDepth::nearest)});
  rules.push_back(
      {"", Mark::inferred, "", "along the ray from the centroid", of_node_depth(true, NodeDepth::centroid_ray)});
  rules.push_back({"nodes of the other layer: depth along the ray from the centroid", Mark::fitted,
                   "section 3.5; App. II.5.2, element 11", "to the nearest point of the outline",
                   of_node_depth(false, NodeDepth::nearest)});
  rules.push_back({"", Mark::fitted, "", "below the side face", of_node_depth(false, NodeDepth::side_face)});
  rules.push_back({"a dashpot may pull until the overlap ends", Mark::proved, "Eq. 17; section 5, problem 1",
                   "contact forces clamped at zero",
                   of_records([](Fence& f) { f.options.end_rule = EndRule::clamped; })});
  rules.push_back({"the dashpot of Eq. 21 stands at each node",
                   Mark::proved,
                   "Eq. 21; App. II.5.2, rock",
                   "half of it at each node",
                   {{}, [](FenceScene& made) { scale_dashpots(made, 0.5); }}});
  rules.push_back({"factor 2 in the stiffness of ground and rock",
                   Mark::fitted,
                   "App. II.5.2: .8723E+08",
                   "factor 1",
                   {{}, [](FenceScene& made) {
                      for (Contact& contact : made.scene.model.contacts) {
                        if (contact.name == "rock-ground") std::get<LinearSpringDashpot>(contact.law).stiffness *= 0.5;
                      }
                    }}});
}

void add_cables(std::vector<Sample2Rule>& rules) {
  rules.push_back({"step from the stiffness E A over the stretched length",
                   Mark::proved,
                   "App. II.5.2: time .993E-02",
                   "over the unstretched length; the second time would print as .992E-02",
                   {{}, shorten_step}});
  rules.push_back(
      {"", Mark::proved, "", "the shortest step that prints both times, .82709E-04", {{}, [](FenceScene& made) {
                                                                                        made.scene.plan.step =
                                                                                            0.82709e-4;
                                                                                      }}});
  rules.push_back({"cable forces with the same stiffness",
                   Mark::inferred,
                   "Eq. 12",
                   "E A over the unstretched length, same tension at the start",
                   {{}, unstretch}});
  rules.push_back({"the bottom cable is double wrapped, k = 2 E A/l", Mark::inferred, "section 2.1", "k = E A/l",
                   of_records([](Fence& f) { f.area_bottom *= 0.5; })});
  rules.push_back({"the bottom cable ends at the last column", Mark::unknown, "not in the report",
                   "a segment to a fixed point",
                   of_records([](Fence& f) { f.options.bottom_end = scenes::BottomEnd::anchored; })});
}

std::vector<std::string> row_of(const Sample2Rule& rule, const std::string& mark, const Sample2Run& run) {
  const auto all = deviations(run);
  const auto number = [](double value) { return fmt::format("{:.3g}", value); };
  return {rule.rule,
          mark,
          rule.source,
          rule.alternative,
          number(mean_deviation(all, 0, 2, 8)),
          number(mean_deviation(all, 1, 2, 8)),
          number(run.states[0][1][3]),
          number(run.states[0][2][5]),
          number(run.states[1][10][3])};
}

}  // namespace

std::vector<Sample2Rule> sample2_rules() {
  std::vector<Sample2Rule> rules;
  add_starts(rules);
  add_outlines(rules);
  add_contacts(rules);
  add_cables(rules);
  return rules;
}

Table rules_table(long& evaluations) {
  Table table{
      "rules",
      "The rules of the historical fence with their marks (proved: matches every printed digit or a closed form; "
      "inferred: clearly the best of those tried; fitted: chosen to match the printed numbers), and what the "
      "states "
      "become when one alone is replaced: mean size of the deviations of elements 2 to 8 from the print, in units of "
      "the "
      "last printed digit, and three numbers of which the print has -.490E+02, .378E+00 and -.110E+01. What does not "
      "move here is "
      "not tested by this deck.",
      {"rule", "mark", "source", "replaced by", "print 1", "print 2", "rock vx [ft/s]", "el. 3 omega [rad/s]",
       "el. 11 vx [ft/s]"},
      {}};
  const auto add = [&](const Sample2Rule& rule, const std::string& mark) {
    const Sample2Run run = run_sample2(rule.change);
    evaluations += run.evaluations;
    if (run.states.size() < printed_steps.size()) {
      table.rows.push_back({rule.rule, mark, rule.source, rule.alternative, "diverges", "", "", "", ""});
    } else {
      table.rows.push_back(row_of(rule, mark, run));
    }
  };
  add({"all rules as they are", Mark::proved, "", "", {}}, "");
  for (const Sample2Rule& rule : sample2_rules())
    add(rule, rule.rule.empty() ? "" : name_of(rule.mark));
  return table;
}

}  // namespace talus::verification::problems
