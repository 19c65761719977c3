#pragma once

namespace talus {

/// Physical dimension as powers of mass M, length L and time T. Angles are pure numbers here; `angle` marks those that
/// are given in rad or deg, so that a bare number or a length is rejected where an angle is required.
struct Dimension {
  int mass{};
  int length{};
  int time{};
  int angle{};

  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

constexpr Dimension operator*(Dimension a, Dimension b) {
  return {a.mass + b.mass, a.length + b.length, a.time + b.time, a.angle + b.angle};
}
constexpr Dimension operator/(Dimension a, Dimension b) {
  return {a.mass - b.mass, a.length - b.length, a.time - b.time, a.angle - b.angle};
}

namespace dimension {
inline constexpr Dimension number{};
inline constexpr Dimension mass{1, 0, 0, 0};
inline constexpr Dimension length{0, 1, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension angle{0, 0, 0, 1};
inline constexpr Dimension velocity = length / time;
inline constexpr Dimension acceleration = velocity / time;
inline constexpr Dimension angular_velocity = angle / time;
inline constexpr Dimension momentum = mass * velocity;
inline constexpr Dimension force = mass * acceleration;
inline constexpr Dimension moment = force * length;
inline constexpr Dimension energy = force * length;
inline constexpr Dimension angular_momentum = momentum * length;
inline constexpr Dimension inertia = mass * length * length;
inline constexpr Dimension stiffness = force / length;
inline constexpr Dimension area = length * length;
inline constexpr Dimension density = mass / area / length;
inline constexpr Dimension pressure = force / area;
inline constexpr Dimension damping = force / velocity;
inline constexpr Dimension frequency = number / time;
}  // namespace dimension

}  // namespace talus
