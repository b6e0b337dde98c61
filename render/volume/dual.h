#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace crest {

/// A number and its gradient in space, carried through arithmetic together (forward differentiation): one
/// formula gives a field's value and its exact gradient.
struct Dual {
  double value = 0;
  glm::dvec3 gradient{0};

  Dual(double constant = 0) : value(constant) {}
  Dual(double v, glm::dvec3 g) : value(v), gradient(g) {}
};

inline Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.gradient + b.gradient}; }
inline Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.gradient - b.gradient}; }
inline Dual operator-(const Dual& a) { return {-a.value, -a.gradient}; }
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.gradient * b.value + b.gradient * a.value};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.gradient - b.gradient * quotient) / b.value};
}
// So that a formula can say sin(x) of either kind of number.
using std::cos;
using std::exp;
using std::sin;
using std::sqrt;

inline Dual sin(const Dual& a) { return {std::sin(a.value), a.gradient * std::cos(a.value)}; }
inline Dual cos(const Dual& a) { return {std::cos(a.value), a.gradient * -std::sin(a.value)}; }
inline Dual exp(const Dual& a) {
  const double e = std::exp(a.value);
  return {e, a.gradient * e};
}
/// At 0, where it has none, the gradient is 0: the middle of those around it.
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, root > 0 ? a.gradient / (2 * root) : glm::dvec3(0)};
}

inline double value_of(double a) { return a; }
inline double value_of(const Dual& a) { return a.value; }

/// A point in space, in numbers that do or do not carry a gradient.
template <class T>
struct Point {
  T x, y, z;
};
inline Point<double> plain_point(glm::dvec3 p) { return {p.x, p.y, p.z}; }
inline Point<Dual> dual_point(glm::dvec3 p) {
  return {Dual(p.x, {1, 0, 0}), Dual(p.y, {0, 1, 0}), Dual(p.z, {0, 0, 1})};
}

}  // namespace crest
