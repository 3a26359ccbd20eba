#pragma once

#include "mpm/plan/phase.h"

#include <functional>
#include <string>

namespace wetfront::mpm {

/// One timed piece of work of a plan. What it works on was bound when its effect joined.
class Kernel {
 public:
  Kernel(Phase phase, std::string name, std::string effect, std::function<void()> body)
      : phase_(phase), name_(std::move(name)), effect_(std::move(effect)), body_(std::move(body)) {}

  void run();

  Phase phase() const { return phase_; }
  const std::string& name() const { return name_; }
  const std::string& effect() const { return effect_; }
  long calls() const { return calls_; }
  /// CPU seconds of this thread, estimated from the timed calls; without the kernels run from within this one.
  double cpu_seconds() const;

 private:
  Phase phase_;
  std::string name_, effect_;
  std::function<void()> body_;
  long calls_ = 0, timed_calls_ = 0;
  double timed_seconds_ = 0;
};

/// CPU time of the calling thread [s].
double thread_cpu_seconds();

}  // namespace wetfront::mpm
