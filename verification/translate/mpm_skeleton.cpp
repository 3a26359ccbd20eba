#include "verification/translate/mpm_skeleton.h"

#include <algorithm>

namespace wetfront::verification {
namespace {

using Kind = SkeletonCondition::Kind;

mpm::MovingSide moving(const Boundary& boundary) {
  mpm::MovingSide side;
  side.side = boundary.side;
  side.origin = boundary.origin.text();
  for (std::size_t a = 0; a < 3; ++a)
    if (boundary.skeleton->axes[a]) side.velocity[a] = boundary.skeleton->velocity[a];
  return side;
}

void add_condition(const Boundary& boundary, mpm::Problem<2>& problem) {
  const std::string origin = boundary.origin.text();
  switch (boundary.skeleton->kind) {
    case Kind::free:
      return;
    case Kind::fixed:
      problem.fixities.push_back({boundary.side, boundary.skeleton->axes, origin});
      return;
    case Kind::moving:
      problem.skeleton_boundary.push_back(moving(boundary));
      return;
    case Kind::contact:
      problem.skeleton_boundary.push_back(mpm::FrictionalContact{boundary.side, boundary.skeleton->friction, origin});
      return;
    case Kind::absorbing:
      problem.skeleton_boundary.push_back(mpm::AbsorbingSide{boundary.side, origin});
      return;
    case Kind::periodic:
      problem.skeleton_boundary.push_back(mpm::PeriodicSkeleton{boundary.side, boundary.partner, origin});
  }
}

/// One pascal, times the record.
mpm::Traction load_of(const Boundary& boundary) {
  mpm::Traction load;
  load.side = boundary.side;
  load.pressure = 1;
  load.factor = {boundary.load->time, boundary.load->value};
  load.origin = boundary.origin.text();
  return load;
}

/// The same of a traction, one axis at a time.
mpm::Traction traction_of(const Boundary& boundary, std::size_t axis) {
  const Record& record = (*boundary.traction)[axis];
  mpm::Traction load;
  load.side = boundary.side;
  load.force[axis] = 1;
  load.factor = {record.time, record.value};
  load.origin = boundary.origin.text();
  return load;
}

}  // namespace

void add_skeleton_sides(const Scene& scene, mpm::Problem<2>& problem) {
  for (const Boundary& boundary : scene.boundaries) {
    if (boundary.skeleton) add_condition(boundary, problem);
    if (boundary.load) problem.skeleton_boundary.push_back(load_of(boundary));
    for (std::size_t axis = 0; boundary.traction && axis < 2; ++axis)
      if (std::ranges::any_of((*boundary.traction)[axis].value, [](double value) { return value != 0; }))
        problem.skeleton_boundary.push_back(traction_of(boundary, axis));
  }
}

mpm::SkeletonScheme skeleton_scheme_of(const SkeletonSettings& settings) {
  mpm::SkeletonScheme scheme;
  if (settings.shape == SkeletonSettings::Shape::quadratic_spline) scheme.shape = mpm::ShapeFunctions::quadratic_spline;
  if (settings.update == SkeletonSettings::Update::usf) scheme.update = mpm::StressUpdate::usf;
  if (settings.update == SkeletonSettings::Update::usl) scheme.update = mpm::StressUpdate::usl;
  if (settings.apic) scheme.transfer = mpm::Transfer::apic;
  scheme.pic = settings.pic;
  if (!settings.b_bar) scheme.locking = mpm::LockingRemedy::none;
  using Integration = SkeletonSettings::Integration;
  if (settings.integration == Integration::mixed) scheme.integration = mpm::StressIntegration::mixed;
  if (settings.integration == Integration::points) scheme.integration = mpm::StressIntegration::points;
  return scheme;
}

}  // namespace wetfront::verification
