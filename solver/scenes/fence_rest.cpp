/// Static equilibrium of a fence before impact.

#include <Eigen/Dense>
#include <cmath>

#include "solver/dynamics/dynamics.hpp"
#include "solver/scenes/fence_maker.hpp"

namespace talus::scenes {
namespace {

/// Rise of a segment with horizontal length d that carries the vertical load V at its inner end, from
/// k (l - l0) r/l = V, l^2 = d^2 + r^2. The left side increases with r from the point where the segment becomes taut.
double rise_under(double load, double across, double rest_length, double stiffness) {
  double low = std::sqrt(std::max(0.0, rest_length * rest_length - across * across));
  double high = rest_length + across + load / stiffness;
  for (int halving = 0; halving < 200; ++halving) {
    const double r = 0.5 * (low + high), l = std::sqrt(across * across + r * r);
    (stiffness * (l - rest_length) * r / l < load ? low : high) = r;
  }
  return 0.5 * (low + high);
}

}  // namespace

/// Applies the residual force of the static shape as a constant force. The shape is balanced except for the last digit
/// of its forces; with the residual cancelled, a column at rest remains exactly at rest. (Weight and pull differ by
/// less than a factor of 2, so that their difference is exact, and so is the sum of weight and residual.)
Model FenceMaker::balanced(Model model) const {
  const Dynamics dynamics{model};
  State state = rest_state(model);
  Workspace work = dynamics.workspace();
  Rates rates{state};
  dynamics.update(state, work);
  dynamics.update_modes(state, work);
  for (std::size_t h = 0; h < model.hangers.size(); ++h) {
    if (state.mode[dynamics.layout().first_hanger + h] == 0) continue;
    throw FenceError{
        {0, "options",
         fmt::format("hanger_strength: found {:.6g}; hanger '{}' breaks under the weight alone; it must be "
                     "more",
                     fence_.options.hanger_strength, model.hangers[h].name)}};
  }
  dynamics.rates(state, work, rates, false);
  // Contact forces are excluded: a rock may touch the fence at the start.
  std::vector<Vec2> pulls(model.bodies.size());
  for (std::size_t j = 0; j < work.joints.size(); ++j) {
    const Joint& joint = dynamics.cables().joints()[j];
    if (joint.on_body) pulls[index(joint.body)] += work.joints.force(j);
  }
  for (const std::vector<Column>& layer : layers_) {
    for (const Column& column : layer) {
      Body& body = model.bodies[index(column.body)];
      if (body.mobility == Mobility::free) body.force += -pulls[index(column.body)] - body.mass * model.gravity;
    }
  }
  return model;
}

void FenceMaker::check_stretched() const {
  const Model model = builder_.build();
  std::vector<std::string> known;
  for (const Cable& cable : model.cables)
    known.push_back(cable.name);
  for (const StretchedCable& stretched : fence_.stretched_cables) {
    if (!find_cable(model, stretched.cable))
      throw FenceError{{0, "stretched_cable", unknown_name("cable", stretched.cable, known).what()}};
  }
}

/// Moves each column to the height given by the stretched segments of each side alone (the mean of both sides). This is
/// exact if both sides are stretched equally and the bottom cable is slack; otherwise it is the initial guess for
/// hung().
void FenceMaker::hang_sides(Model& model) const {
  const StaticShape shape = static_shape(fence_);
  const double end = fence_.column.position.y + shape.heights.back() + column(0).y_top;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    std::vector<double> sums(model.bodies.size(), 0.0), sides(model.bodies.size(), 0.0);
    for (const int side : full() ? std::vector{1, -1} : std::vector{1}) {
      double joint = end;
      for (std::size_t s = shape.distances.size(); s-- > 0;) {
        const double across = shape.distances[s];
        const double load = shape.horizontal_tension * (shape.heights[s + 1] - shape.heights[s]) / across;
        const auto id = find_cable(
            model, fmt::format("{}top{}{}", prefix(static_cast<int>(layer) + 1), side < 0 ? "-" : "", s + 1));
        const Cable& cable = model.cables[index(*id)];
        joint -= rise_under(load, across, cable.rest_length, std::get<ElasticPlastic>(cable.law).stiffness);
        const std::size_t body = index(*cable.a.body);
        sums[body] += joint - column(static_cast<int>(s)).y_top;
        sides[body] += 1.0;
      }
    }
    for (std::size_t body = 0; body < model.bodies.size(); ++body) {
      if (sides[body] > 0.0) model.bodies[body].p_WB.y = sums[body] / sides[body];
    }
  }
}

/// The columns in equilibrium on stretched cables: heights at which weights and pulls balance, by Newton's method. The
/// stiffness matrix is symmetric and positive definite as long as the cables are taut.
Model FenceMaker::hung(Model model) {
  hang_sides(model);
  std::vector<std::size_t> bodies;
  for (const std::vector<Column>& layer : layers_) {
    for (const Column& column : layer) {
      if (has_y(model.bodies[index(column.body)].mobility)) bodies.push_back(index(column.body));
    }
  }
  const auto count = static_cast<Eigen::Index>(bodies.size());
  const auto forces = [&](const Model& at) {
    const Dynamics dynamics{at};
    State state = rest_state(at);
    Workspace work = dynamics.workspace();
    Rates rates{state};
    dynamics.update_all(state, work);
    dynamics.cables().update_modes(state, work);
    dynamics.cables().load(state, work, nullptr);
    Eigen::VectorXd sum(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::size_t body = bodies[static_cast<std::size_t>(i)];
      sum[i] = work.wrenches.y[body] + at.bodies[body].mass * at.gravity.y;
    }
    return sum;
  };
  const double nudge = 1e-8 * fence_.sag;
  for (int pass = 0; pass < 100; ++pass) {
    const Eigen::VectorXd residual = forces(model);
    if (residual.cwiseAbs().maxCoeff() < 1e-9 * column_weight()) break;
    Eigen::MatrixXd stiffness(count, count);
    for (Eigen::Index j = 0; j < count; ++j) {
      Model moved = model;
      moved.bodies[bodies[static_cast<std::size_t>(j)]].p_WB.y += nudge;
      stiffness.col(j) = (forces(moved) - residual) / nudge;
    }
    const Eigen::VectorXd step = stiffness.fullPivLu().solve(-residual);
    // A step of more than a tenth of the sag would leave the neighbourhood in which the cables are taut.
    const double fraction = std::min(1.0, 0.1 * fence_.sag / step.cwiseAbs().maxCoeff());
    for (Eigen::Index i = 0; i < count; ++i)
      model.bodies[bodies[static_cast<std::size_t>(i)]].p_WB.y += fraction * step[i];
  }
  if (!(forces(model).cwiseAbs().maxCoeff() < 1e-6 * column_weight()))
    throw FenceError{{0, "stretched_cable", "no static equilibrium with these; they must be less stretched"}};
  for (FenceMember& member : made_.members) {
    if (member.layer > 0 && member.body) member.position = model.bodies[index(*member.body)].p_WB;
  }
  return model;
}

StaticShape static_shape(const Fence& fence) {
  const int count = columns_of_half(fence);
  const bool even = fence.columns % 2 == 0;
  const double mass = mass_properties(fence.column).mass;
  const double weight = mass * fence.gravity;
  StaticShape shape;
  // Loads inside the segments, in column weights; for an odd count each side carries half of the central column.
  std::vector<double> loads;
  double reach = even ? 0.5 * fence.spacing : 0.0;
  double load = 0.0;
  for (int i = 0; i < count; ++i) {
    const double distance = i + 1 < count ? fence.spacing : 0.5 * fence.span - reach;
    if (distance <= 0.0) {
      throw FenceError{{0, "columns",
                        fmt::format("found {}; {} apart they do not fit into half the span, {}; they must be fewer",
                                    fence.columns, fence.spacing, 0.5 * fence.span)}};
    }
    double own = 1.0;
    for (const ChangedColumn& changed : fence.changed_columns) {
      FenceElement other = fence.column;
      other.a = changed.a, other.b = changed.b, other.density = changed.density;
      if (changed.number == i + 1) own = mass_properties(other).mass / mass;
    }
    load += i == 0 && !even ? 0.5 * own : own;
    shape.distances.push_back(distance);
    loads.push_back(load);
    reach += distance;
  }
  double moment = 0.0;
  for (std::size_t i = 0; i < loads.size(); ++i)
    moment += loads[i] * shape.distances[i];
  const double H = shape.horizontal_tension = weight / fence.sag * moment;
  shape.heights = {0.0};
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double d = shape.distances[i];
    const double rise = loads[i] * (weight / H) * d;
    shape.heights.push_back(i + 1 < loads.size() ? shape.heights.back() + rise : fence.sag);
    shape.tensions.push_back(H * std::sqrt(d * d + rise * rise) / d);
  }
  return shape;
}

}  // namespace talus::scenes
