#pragma once

#include <cmath>

namespace talus {

/// A vector in the plane of motion (x to the right, y up); components in one consistent unit.
struct Vec2 {
  double x{};
  double y{};

  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr Vec2& operator+=(Vec2& a, Vec2 b) { return a = a + b; }
constexpr Vec2& operator-=(Vec2& a, Vec2 b) { return a = a - b; }

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }

/// z component of a x b: the moment of force b acting at lever arm a, counter-clockwise > 0.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

/// w x r: the velocity of a point at lever arm r on a body that turns at w [rad/T], counter-clockwise > 0.
constexpr Vec2 cross(double w, Vec2 r) { return {-w * r.y, w * r.x}; }

/// Euclidean length. sqrt is correctly rounded everywhere (hypot is not), which keeps results the same on all machines.
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }

/// A point or vector in space: the plane of motion plus z along the fence, which enters only the geometry: nothing
/// moves along z.
struct Vec3 {
  double x{};
  double y{};
  double z{};

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double norm(Vec3 a) { return std::sqrt(dot(a, a)); }

/// The part of a that lies in the plane of motion.
constexpr Vec2 in_plane(Vec3 a) { return {a.x, a.y}; }

}  // namespace talus
