#include "solver/app/capacity/rock_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "solver/app/sweep/design.hpp"
#include "solver/base/error.hpp"
#include "solver/io/file/toml_field.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "solver/scenes/fence_element.hpp"

namespace talus::app {
namespace {

constexpr const char* rock_path = "fence.rock[0].";

/// Whether the document has a field; one that is missing is added empty, to this copy.
bool has_field(TomlValue document, std::string_view path) {
  const auto* const text = std::get_if<std::string>(&field_at(document, path).data);
  return text == nullptr || !text->empty();
}

/// The result of `read`, whose errors are those of the fields that the file sets: the base alone is right.
template <class Read>
auto of_set(const CapacityFile& file, Read&& read) {
  try {
    return read();
  } catch (const InputError& error) {
    if (file.fields.empty()) throw;
    throw InputError{fmt::format("{}: set: {}", file.file.string(), error.what())};
  }
}

/// The base with the fields that the file sets.
TomlValue base_document(TomlValue document, const CapacityFile& file) {
  return of_set(file, [&] {
    for (const auto& [field, value] : file.fields)
      set_field(document, field, value);
    return document;
  });
}

SceneFile read_base(const TomlValue& document, const std::string& name, const CapacityFile& file) {
  SceneFile scene = of_set(file, [&] { return read_scene_file(document, name); });
  if (!scene.fence) throw InputError{fmt::format("{}: it must be a fence, with a table [fence]", name)};
  if (const std::size_t count = scene.fence->fence.rocks.size(); count != 1)
    throw InputError{fmt::format("{}: found {} rocks; it must be one, which is replaced by others", name, count)};
  return scene;
}

/// The ends of all positions along the fence that the file asks for, without their changes [m].
std::array<double, 2> ends_along(const CapacityFile& file, double own) {
  std::vector<double> all = file.positions.empty() ? std::vector{own} : file.positions;
  if (file.hazard) {
    if (file.hazard->along) all.insert(all.end(), file.hazard->along->begin(), file.hazard->along->end());
    if (file.hazard->table_has_along)
      for (const Rock& rock : file.hazard->table)
        all.push_back(rock.along);
  }
  const auto [smallest, largest] = std::ranges::minmax(all);
  return {smallest - file.changes.along, largest + file.changes.along};
}

}  // namespace

RockRuns::RockRuns(const TomlValue& base, const std::string& name, const CapacityFile& file)
    : document_{base_document(base, file)},
      base_{read_base(document_, name, file)},
      gives_mass_{has_field(document_, fmt::format("{}mass", rock_path))},
      fields_{file.fields},
      changes_{file.changes} {
  const UnitSystem& units = this->units();
  const scenes::FenceElement& rock = base_.fence->fence.rocks.front();
  if (rock.velocity.x == 0.0)
    throw InputError{fmt::format("{}: rock: velocity: found none along x; it must move towards the fence", name)};
  own_.mass = scenes::mass_properties(rock).mass * si_size(units, dimension::mass);
  own_.speed = norm(rock.velocity) * si_size(units, dimension::velocity);
  own_.height = height_at({});
  own_.spin = rock.spin * si_size(units, dimension::angular_velocity);
  own_.along = rock.along * si_size(units, dimension::length);
  sets_spin_ = !file.spins.empty() || file.changes.spin > 0.0 ||
               (file.hazard && (file.hazard->spin || file.hazard->table_has_spin));
  sets_along_ = !file.positions.empty() || file.changes.along > 0.0 ||
                (file.hazard && (file.hazard->along || file.hazard->table_has_along));
  if (sets_along_ && !is_full())
    throw InputError{fmt::format(
        "{}: [fence.options]: symmetry: found \"half\"; it must be \"full\" for positions along the fence", name)};
  if (!sets_along_) return;
  for (const double along : ends_along(file, own_.along)) {
    Rock there = own_;
    there.along = along;
    try {
      static_cast<void>(read_scene_file(with_parameters(document_, run(there, {})), name));
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}: along: {}", file.file.string(), error.what())};
    }
  }
}

double RockRuns::start_energy(const Rock& rock) const {
  const double inertia =
      scenes::mass_properties(base_.fence->fence.rocks.front()).inertia * si_size(units(), dimension::inertia);
  return rock.kinetic_energy() + 0.5 * inertia * std::pow(rock.mass / own_.mass, 5.0 / 3.0) * rock.spin * rock.spin;
}

double RockRuns::height_at(Vec2 shift) const {
  const FenceInput& fence = *base_.fence;
  const double length = si_size(base_.scene.model.units, dimension::length);
  const BodyId ground = *fence.made.members.front().body;
  const Vec2 position = fence.fence.rocks.front().position + (1.0 / length) * shift;
  return length * scenes::height_over(base_.scene.model.bodies[index(ground)],
                                      pose(base_.scene.model, base_.scene.initial, ground), position);
}

SweptRun RockRuns::run(const Rock& rock, const std::array<double, 5>& numbers) const {
  const UnitSystem& units = this->units();
  const double length = si_size(units, dimension::length);
  const scenes::FenceElement& own = base_.fence->fence.rocks.front();
  const double size = std::cbrt(rock.mass / own_.mass);
  const double speed = rock.speed * (1.0 + changes_.speed * numbers[0]);
  const double height = rock.height + changes_.height * numbers[1];
  // At least as far from the fence as the base's rock: outlines are between an ellipse and a rectangle.
  const double of_a = std::abs(own.a * std::cos(own.angle)), of_b = std::abs(own.b * std::sin(own.angle));
  const double width = size > 1.0 ? of_a + of_b : std::hypot(of_a, of_b);
  const double away = -std::copysign(1.0, own.velocity.x) * (size - 1.0) * width * length;
  double up = height - own_.height;
  for (int correction = 0; correction < 8; ++correction)  // the ground may be inclined or uneven
    up += height - height_at({away, up});
  const Vec2 direction = (1.0 / norm(own.velocity)) * own.velocity;

  SweptRun run;
  run.parameters = fields_;
  const auto set = [&](const char* field, const TomlValue& value) {
    run.parameters.emplace_back(fmt::format("{}{}", rock_path, field), value);
  };
  const auto quantity = [](double value, const char* unit) { return TomlValue{fmt::format("{} {}", value, unit)}; };
  set("a", quantity(own.a * length * size, "m"));
  set("b", quantity(own.b * length * size, "m"));
  if (gives_mass_) set("mass", quantity(rock.mass, "kg"));
  set("position[0]", quantity(own.position.x * length + away, "m"));
  set("position[1]", quantity(own.position.y * length + up, "m"));
  set("velocity[0]", quantity(direction.x * speed, "m/s"));
  set("velocity[1]", quantity(direction.y * speed, "m/s"));
  if (changes_.angle > 0.0) set("angle", quantity(own.angle + changes_.angle * numbers[2], "rad"));
  if (sets_spin_) set("spin", quantity(rock.spin + changes_.spin * numbers[3], "rad/s"));
  if (sets_along_) set("along", quantity(rock.along + changes_.along * numbers[4], "m"));
  run.id = id_of(run);
  return run;
}

std::array<double, 5> random_numbers(std::int64_t seed, const std::vector<std::uint32_t>& purpose) {
  std::vector<std::uint32_t> seeds{static_cast<std::uint32_t>(seed)};
  seeds.insert(seeds.end(), purpose.begin(), purpose.end());
  std::seed_seq sequence(seeds.begin(), seeds.end());
  std::mt19937_64 generator{sequence};
  std::array<double, 5> numbers{};
  for (double& number : numbers)
    number = 2.0 * unit_number(generator()) - 1.0;
  return numbers;
}

}  // namespace talus::app
