#include "mpm/boundary/rigid_planes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wetfront::mpm {

namespace {

/// The multipliers with which the planes of `set` become active: G x = v.n - approach for the Gram matrix of their
/// normals; false where these do not span so many directions.
template <int dim>
bool solve_gram(const RigidPlanes<dim>& planes, std::span<const int> set, const Vector<dim>& velocity,
                Vector<dim>& lambda) {
  const int n = static_cast<int>(set.size());
  const auto normal = [&](int k) -> const Vector<dim>& { return planes.normal[static_cast<std::size_t>(set[k])]; };
  std::array<std::array<double, dim + 1>, dim> rows{};
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) rows[r][c] = dot<dim>(normal(r), normal(c));
    rows[r][n] = dot<dim>(normal(r), velocity) - planes.approach[static_cast<std::size_t>(set[r])];
  }
  for (int k = 0; k < n; ++k) {  // a Gram matrix needs no pivoting
    if (!(rows[k][k] > 1e-10)) return false;
    for (int r = 0; r < n; ++r) {
      if (r == k) continue;
      const double factor = rows[r][k] / rows[k][k];
      for (int c = k; c <= n; ++c) rows[r][c] -= factor * rows[k][c];
    }
  }
  for (int k = 0; k < n; ++k) lambda[k] = rows[k][n] / rows[k][k];
  return true;
}

/// Tries one set of active planes.
template <int dim>
bool fits(const RigidPlanes<dim>& planes, std::span<const int> set, const Vector<dim>& velocity, Vector<dim>& out,
          std::span<double> impulse) {
  Vector<dim> lambda{};
  if (!solve_gram<dim>(planes, set, velocity, lambda)) return false;
  const double size = 1e-12 * length<dim>(velocity);
  out = velocity;
  bool shut = set.size() == dim;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const auto plane = static_cast<std::size_t>(set[k]);
    if (lambda[k] < -size) return false;
    shut = shut && planes.approach[plane] == 0;
    for (int a = 0; a < dim; ++a) out[a] -= lambda[k] * planes.normal[plane][a];
  }
  for (std::size_t k = 0; k < planes.normal.size(); ++k)
    if (dot<dim>(planes.normal[k], out) > planes.approach[k] + size) return false;
  if (shut) out.fill(0);  // to the last bit
  std::fill(impulse.begin(), impulse.end(), 0.0);
  for (std::size_t k = 0; k < set.size(); ++k) impulse[static_cast<std::size_t>(set[k])] = std::max(lambda[k], 0.0);
  return true;
}

}  // namespace

template <int dim>
Vector<dim> without_penetration(const Vector<dim>& velocity, const RigidPlanes<dim>& planes,
                                std::span<double> impulse) {
  const int count = static_cast<int>(planes.normal.size());
  Vector<dim> out{};
  std::array<int, dim> set{};
  for (int size = 0; size <= std::min(count, dim); ++size) {
    for (int k = 0; k < size; ++k) set[k] = k;
    while (true) {
      if (fits<dim>(planes, {set.data(), static_cast<std::size_t>(size)}, velocity, out, impulse)) return out;
      int k = size - 1;  // the next combination
      while (k >= 0 && set[k] == count - size + k) --k;
      if (k < 0) break;
      ++set[k];
      for (int later = k + 1; later < size; ++later) set[later] = set[later - 1] + 1;
    }
  }
  // Planes that shut every way out, to round-off: the node stays.
  for (std::size_t k = 0; k < planes.normal.size(); ++k)
    impulse[k] = std::max(dot<dim>(planes.normal[k], velocity), 0.0);
  return {};
}

template <int dim>
Vector<dim> along_planes(const Vector<dim>& velocity, const RigidPlanes<dim>& planes, std::span<const double> impulse) {
  Vector<dim> out = velocity;
  std::array<Vector<dim>, dim> basis{};  // of the active normals, orthonormal
  int count = 0;
  for (std::size_t k = 0; k < planes.normal.size() && count < dim; ++k) {
    if (!(impulse[k] > 0)) continue;
    Vector<dim> direction = planes.normal[k];
    for (int b = 0; b < count; ++b) {
      const double part = dot<dim>(direction, basis[b]);
      for (int a = 0; a < dim; ++a) direction[a] -= part * basis[b][a];
    }
    const double size = length<dim>(direction);
    if (size < 1e-5) continue;  // no direction of its own
    for (double& component : direction) component /= size;
    const double part = dot<dim>(out, direction);
    for (int a = 0; a < dim; ++a) out[a] -= part * direction[a];
    basis[count++] = direction;
  }
  return out;
}

template Vector<2> without_penetration<2>(const Vector<2>&, const RigidPlanes<2>&, std::span<double>);
template Vector<3> without_penetration<3>(const Vector<3>&, const RigidPlanes<3>&, std::span<double>);
template Vector<2> along_planes<2>(const Vector<2>&, const RigidPlanes<2>&, std::span<const double>);
template Vector<3> along_planes<3>(const Vector<3>&, const RigidPlanes<3>&, std::span<const double>);

}  // namespace wetfront::mpm
