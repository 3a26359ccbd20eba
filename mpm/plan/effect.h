#pragma once

#include "mpm/problem.h"

#include <string>

namespace wetfront::mpm {

template <int dim>
class StagePlan;

/// A piece of physics that a scene calls for. An effect that no scene entry calls for is never made: it has no column,
/// no kernel and no branch.
template <int dim>
class Effect {
 public:
  Effect(std::string name, Origin called_for_by, std::string equations)
      : name_(std::move(name)), called_for_by_(std::move(called_for_by)), equations_(std::move(equations)) {}
  virtual ~Effect() = default;
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;

  const std::string& name() const { return name_; }
  const Origin& called_for_by() const { return called_for_by_; }
  /// Paper and equations.
  const std::string& equations() const { return equations_; }

  /// Provides and requires columns, adds kernels to phases, states time-step limits. Columns have no memory yet:
  /// kernels keep references to them. Laws (variants of the problem) are visited here, once.
  virtual void join(StagePlan<dim>& plan) = 0;

 private:
  std::string name_, called_for_by_, equations_;
};

}  // namespace wetfront::mpm
