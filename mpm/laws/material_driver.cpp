#include "mpm/laws/material_driver.h"

#include "mpm/laws/stress_laws.h"

#include <Eigen/Dense>

#include <cmath>
#include <stdexcept>

namespace wetfront::mpm {

namespace {

template <class Law, int dim>
class Machine {
 public:
  static constexpr int size = stress_components<dim>;
  using Point = LawPoint<Law, dim>;

  Machine(const Law& law, const PathStart<dim>& start) : law_(law) {
    law_.begin(point_);
    point_.stress = start.stress;
    point_.suction = start.suction;
  }

  PathState<dim> state() const {
    return {strain_, point_.stress, {point_.memory.begin(), point_.memory.end()}, point_.suction};
  }

  void run(const PathLeg<dim>& leg, std::vector<PathState<dim>>& states) {
    // What is driven by stress is guessed to strain on as it did; a new leg begins with no guess.
    guess_.fill(0);
    const PathState<dim> begin = state();
    for (int k = 1; k <= leg.steps; ++k) {
      const double share = static_cast<double>(k) / leg.steps;
      Step step;
      for (int i = 0; i < size; ++i) {
        step.strain[i] = leg.strain[i] / leg.steps;
        if (leg.stress[i]) step.target[i] = begin.stress[i] + share * (*leg.stress[i] - begin.stress[i]);
      }
      step.suction = begin.suction + share * (leg.suction.value_or(begin.suction) - begin.suction);
      take(step, 0);
      states.push_back(state());
    }
  }

 private:
  struct Step {
    SymmetricTensor<dim> strain{};
    std::array<std::optional<double>, size> target{};
    double suction = 0;
  };

  Point moved(const SymmetricTensor<dim>& strain, double suction) const {
    StepGradient<dim> step;
    for (int a = 0; a < dim; ++a) step.plane[a][a] = strain[a];
    step.plane[0][1] = step.plane[1][0] = strain[3];
    if constexpr (dim == 2) step.zz = strain[2];
    if constexpr (dim == 3) {
      step.plane[1][2] = step.plane[2][1] = strain[4];
      step.plane[2][0] = step.plane[0][2] = strain[5];
    }
    Point point = point_;
    point.suction = suction;
    law_.advance(point, step);
    return point;
  }

  void take(const Step& step, int halvings) {
    SymmetricTensor<dim> strain = step.strain;
    std::vector<int> free;
    for (int i = 0; i < size; ++i)
      if (step.target[i]) {
        free.push_back(i);
        strain[i] = std::ldexp(guess_[i], -halvings);
      }
    Point end = moved(strain, step.suction);
    if (!free.empty() && !solve(step, free, strain, end)) return halve(step, halvings);
    for (int i : free) guess_[i] = std::ldexp(strain[i], halvings);
    for (int i = 0; i < size; ++i) strain_[i] += strain[i];
    point_ = end;
  }

  void halve(const Step& step, int halvings) {
    if (halvings == 12)
      throw std::runtime_error(
          "material driver: a stress cannot be reached (the soil fails before). Drive that component by strain");
    Step first = step;
    for (int i = 0; i < size; ++i) {
      first.strain[i] /= 2;
      if (step.target[i]) first.target[i] = (point_.stress[i] + *step.target[i]) / 2;
    }
    first.suction = (point_.suction + step.suction) / 2;
    Step second = step;
    second.strain = first.strain;
    take(first, halvings + 1);
    take(second, halvings + 1);
  }

  /// Newton's method in the strains of `free`. Says whether all stresses were met.
  bool solve(const Step& step, const std::vector<int>& free, SymmetricTensor<dim>& strain, Point& end) const {
    const int n = static_cast<int>(free.size());
    const double stiffness = law_.constrained_modulus(point_), probe = 1e-7;
    for (int turn = 0; turn < 25; ++turn) {
      Eigen::VectorXd miss(n);
      double scale = 1e-9 * stiffness;
      for (double component : end.stress) scale = std::max(scale, std::abs(component));
      for (int r = 0; r < n; ++r) miss[r] = end.stress[free[r]] - *step.target[free[r]];
      if (!miss.allFinite()) return false;
      if (miss.cwiseAbs().maxCoeff() <= 1e-12 * scale) return true;
      Eigen::MatrixXd tangent(n, n);
      for (int c = 0; c < n; ++c) {
        SymmetricTensor<dim> probed = strain;
        // Towards less stress: away from what the surface cuts off.
        const double side = miss[c] > 0 ? -probe : probe;
        probed[free[c]] += side;
        const Point other = moved(probed, step.suction);
        for (int r = 0; r < n; ++r) tangent(r, c) = (other.stress[free[r]] - end.stress[free[r]]) / side;
      }
      // Least strain where the stress leaves it open: on an edge of the surface two lateral strains share one flow, and
      // a triaxial test stays axisymmetric. Differences are good to 1e-10.
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
      solver.setThreshold(1e-7);
      const Eigen::VectorXd change = solver.compute(tangent).solve(miss);
      if (!change.allFinite() || change.cwiseAbs().maxCoeff() > 0.2) return false;
      for (int r = 0; r < n; ++r) strain[free[r]] -= change[r];
      end = moved(strain, step.suction);
    }
    return false;
  }

  Law law_;
  Point point_{};
  SymmetricTensor<dim> strain_{};
  std::array<double, size> guess_{};
};

}  // namespace

template <int dim>
std::vector<PathState<dim>> drive(const Soil& soil, const PathStart<dim>& start,
                                  const std::vector<PathLeg<dim>>& path) {
  std::vector<PathState<dim>> states;
  with_stress_law(soil, [&](const auto& law) {
    Machine<std::decay_t<decltype(law)>, dim> machine(law, start);
    states.push_back(machine.state());
    for (const PathLeg<dim>& leg : path) machine.run(leg, states);
  });
  return states;
}

template <int dim>
std::vector<std::string> path_memory(const Soil& soil) {
  std::vector<std::string> names;
  with_stress_law(soil, [&](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    for (const ColumnSpec& spec : Law::memory_specs(dim))
      for (int c = 0; c < spec.components; ++c)
        names.push_back(spec.name + (spec.components > 1 ? " " + std::to_string(c) : ""));
  });
  return names;
}

PressureAndShear pressure_and_shear(const SymmetricTensor<3>& stress) {
  const double mean = trace<3>(stress) / 3;
  double square = 0;
  for (int k = 0; k < 3; ++k) square += (stress[k] - mean) * (stress[k] - mean);
  for (int k = 3; k < 6; ++k) square += 2 * stress[k] * stress[k];
  return {-mean, std::sqrt(1.5 * square)};
}

template std::vector<PathState<2>> drive(const Soil&, const PathStart<2>&, const std::vector<PathLeg<2>>&);
template std::vector<PathState<3>> drive(const Soil&, const PathStart<3>&, const std::vector<PathLeg<3>>&);
template std::vector<std::string> path_memory<2>(const Soil&);
template std::vector<std::string> path_memory<3>(const Soil&);

}  // namespace wetfront::mpm
