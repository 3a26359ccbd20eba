#include "mpm/plan/derive_effects.h"

#include "mpm/boundary/skeleton_boundaries.h"
#include "mpm/coupling/fixed_stress.h"
#include "mpm/coupling/relaxation.h"
#include "mpm/coupling/true_time.h"
#include "mpm/coupling/weakened_rest.h"
#include "mpm/plan/check_numbers.h"
#include "mpm/record/motion_ledger.h"
#include "mpm/record/probes.h"
#include "mpm/record/rest_watch.h"
#include "mpm/record/riders.h"
#include "mpm/seepage/free_drainage.h"
#include "mpm/seepage/held_pressure.h"
#include "mpm/seepage/periodic.h"
#include "mpm/seepage/seepage.h"
#include "mpm/seepage/surface_exchange.h"
#include "mpm/skeleton/deforming_skeleton.h"
#include "mpm/skeleton/gravity.h"
#include "mpm/skeleton/initial_stress.h"
#include "mpm/skeleton/rigid_skeleton.h"
#include "mpm/two_velocity/rain.h"
#include "mpm/two_velocity/two_velocity.h"

#include <algorithm>

namespace wetfront::mpm {

namespace {

template <int dim>
bool has_elastic_soil(const Problem<dim>& problem) {
  const auto elastic = [](const Soil& soil) { return soil.elastic.has_value(); };
  const bool any = std::any_of(problem.soils.begin(), problem.soils.end(), elastic);
  if (any && !std::all_of(problem.soils.begin(), problem.soils.end(), elastic))
    throw CannotPlan(
        "some soils are elastic and some are rigid (one skeleton effect acts on all points). Give every "
        "soil an elastic law, or none");
  return any;
}

/// Whoever builds one of these takes its line out.
template <int dim>
void refuse_what_is_not_there_yet(const StagePlan<dim>& plan) {
  const Problem<dim>& problem = plan.problem;
  const std::string where = plan.stage.origin + ": stage '" + plan.stage.name + "' ";
  if (problem.skeleton.update == StressUpdate::usf && plan.stage.motion == SkeletonMotion::quasi_static)
    throw CannotPlan(where +
                     "updates stress first, in a skeleton that goes from equilibrium to equilibrium (where what comes "
                     "first in a cycle means nothing). Use musl or usl");
  if (problem.skeleton.shape != ShapeFunctions::linear &&
      (plan.stage.liquid || plan.stage.motion == SkeletonMotion::quasi_static))
    throw CannotPlan(where +
                     "moves its skeleton by splines, with liquid or quasi-statically (water and elastic corrections "
                     "live on the nodes of the mesh, splines on others). Use linear shape functions");
  if (problem.skeleton.update == StressUpdate::usf && plan.stage.liquid)
    throw CannotPlan(where +
                     "updates stress first, with liquid (which reads momenta where velocities are by then). "
                     "Use musl or usl");
}

template <int dim>
void join_gravity(StagePlan<dim>& plan) {
  const Problem<dim>& problem = plan.problem;
  if (std::any_of(problem.gravity.begin(), problem.gravity.end(), [](double g) { return g != 0; }))
    plan.join(std::make_unique<Gravity<dim>>(problem.gravity_origin));
}

template <int dim>
std::shared_ptr<SkeletonCycle<dim>> join_skeleton(StagePlan<dim>& plan) {
  const Problem<dim>& problem = plan.problem;
  if (!has_elastic_soil(problem)) {
    plan.join(std::make_unique<RigidSkeleton<dim>>(problem.soils.front().origin));
    return nullptr;
  }
  refuse_what_is_not_there_yet(plan);
  const Origin& origin = problem.soils.front().elastic->origin;
  auto skeleton = std::make_unique<DeformingSkeleton<dim>>(origin);
  const auto cycle = skeleton->cycle();
  plan.join(std::move(skeleton));
  if (problem.initial_stress == InitialStress::k0) plan.join(std::make_unique<InitialStressEffect<dim>>(origin));
  if (!problem.skeleton_boundary.empty()) plan.join(std::make_unique<SkeletonBoundaries<dim>>(problem, cycle));
  return cycle;
}

/// The origin of the first water boundary of a kind; empty when the problem has none.
template <class Kind, int dim>
const Origin* first_origin(const Problem<dim>& problem) {
  for (const auto& boundary : problem.water_boundary)
    if (const auto* found = std::get_if<Kind>(&boundary)) return &found->origin;
  return nullptr;
}

/// What passes the film of the surface: "rainfall, evaporation, water level, ..."; empty when nothing does.
template <int dim>
std::string exchange_name(const Problem<dim>& problem) {
  std::vector<std::string> kinds;
  const auto add = [&kinds](bool there, const char* kind) {
    if (there && std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.emplace_back(kind);
  };
  for (const auto& boundary : problem.water_boundary) {
    const auto* rain = std::get_if<RainSide>(&boundary);
    add(rain != nullptr, "rainfall");
    add(rain != nullptr && !rain->evaporation.start.empty(), "evaporation");
    add(std::holds_alternative<WaterLevelSide>(boundary), "water level");
    add(std::holds_alternative<FluxSide>(boundary), "flux");
    const bool held = std::holds_alternative<PressureSide>(boundary) || std::holds_alternative<TotalHeadSide>(boundary);
    add(held && std::visit([](const auto& b) { return b.side == free_surface; }, boundary), "pressure at the surface");
  }
  std::string name;
  for (const auto& kind : kinds) name += (name.empty() ? "" : ", ") + kind;
  return name;
}

/// Held nodes first and ties last: the conditions in between look at the former, the latter at both.
template <int dim>
void join_water_boundaries(StagePlan<dim>& plan, const std::shared_ptr<NodalWater<dim>>& water) {
  const Problem<dim>& problem = plan.problem;
  for (const auto& boundary : problem.water_boundary) {
    check_condition(boundary);
    for (double time : breaks_of(boundary)) plan.add_break(time);
  }
  const Origin *held = first_origin<PressureSide>(problem), *head = first_origin<TotalHeadSide>(problem);
  if (held != nullptr || head != nullptr)
    plan.join(std::make_unique<HeldPressure<dim>>(held != nullptr ? *held : *head, water));
  if (const std::string name = exchange_name(problem); !name.empty()) {
    const auto first = std::find_if(problem.water_boundary.begin(), problem.water_boundary.end(), exchanges);
    const auto& origin_of = first != problem.water_boundary.end() ? *first : problem.water_boundary.front();
    plan.join(std::make_unique<SurfaceExchange<dim>>(
        name, std::visit([](const auto& b) { return b.origin; }, origin_of), water));
  }
  if (const Origin* origin = first_origin<FreeDrainageSide>(problem))
    plan.join(std::make_unique<FreeDrainage<dim>>(*origin, water));
  if (const Origin* origin = first_origin<PeriodicSides>(problem))
    plan.join(std::make_unique<Periodic<dim>>(*origin, water));
}

template <int dim>
void join_seepage(StagePlan<dim>& plan, const std::shared_ptr<SkeletonCycle<dim>>& cycle) {
  const std::string where = plan.stage.origin + ": stage '" + plan.stage.name + "' ";
  const bool inertia = cycle != nullptr && *plan.stage.liquid == LiquidScheme::semi_implicit;
  if (inertia && plan.stage.motion == SkeletonMotion::quasi_static)
    throw CannotPlan(where +
                     "uses the scheme semi-implicit with quasi-static motion (from equilibrium to equilibrium nothing "
                     "has inertia, so its water can have none against the grains). Use seepage, or dynamic motion");
  if (inertia && plan.problem.skeleton.update != StressUpdate::musl)
    throw CannotPlan(where +
                     "uses the scheme semi-implicit in a skeleton that does not map its velocities back (its step is "
                     "known to be stable with MUSL only). Use musl, or the scheme seepage");
  auto water = std::make_shared<NodalWater<dim>>();
  std::unique_ptr<SkeletonOfFlow<dim>> split;
  if (cycle != nullptr && plan.stage.motion == SkeletonMotion::dynamic)
    split = std::make_unique<TrueTimeMotion<dim>>(cycle);
  if (cycle != nullptr && plan.stage.motion == SkeletonMotion::quasi_static)
    split = std::make_unique<FixedStress<dim>>(cycle);
  plan.join(std::make_unique<Seepage<dim>>(plan.stage.origin, *plan.stage.liquid, water, std::move(split)));
  join_water_boundaries(plan, water);
}

template <int dim>
void join_two_velocities(StagePlan<dim>& plan, SkeletonCycle<dim>* cycle) {
  auto water = std::make_shared<TwoVelocityWater<dim>>(plan);
  plan.join(std::make_unique<TwoVelocityLiquid<dim>>(plan.stage.origin, water, cycle));
  if (const Origin* origin = first_origin<RainSide>(plan.problem))
    plan.join(std::make_unique<RainOnTwoVelocity<dim>>(*origin, water));
}

template <int dim>
void join_liquid(StagePlan<dim>& plan, const std::shared_ptr<SkeletonCycle<dim>>& cycle) {
  if (!plan.stage.liquid) {
    if (cycle != nullptr && plan.stage.motion == SkeletonMotion::quasi_static)
      plan.join(std::make_unique<QuasiStaticMotion<dim>>(plan.stage.origin, cycle));
    return;
  }
  const std::string where = plan.stage.origin + ": stage '" + plan.stage.name + "'";
  if (!plan.problem.water)
    throw CannotPlan(where + " moves pore liquid, but the scene has no water. Add water or leave the stage dry");
  if (*plan.stage.liquid == LiquidScheme::seepage || *plan.stage.liquid == LiquidScheme::semi_implicit)
    return join_seepage(plan, cycle);
  if (cycle != nullptr && plan.stage.motion == SkeletonMotion::quasi_static)
    throw CannotPlan(where +
                     " moves its skeleton from equilibrium to equilibrium and its liquid in true time (the two have no "
                     "common step). Use dynamic motion, or the scheme seepage");
  join_two_velocities(plan, cycle.get());
}

}  // namespace

namespace {

bool two_velocities(const Stage& stage) {
  return stage.liquid == LiquidScheme::implicit_drag || stage.liquid == LiquidScheme::explicit_drag;
}

}  // namespace

template <int dim>
void check(const Problem<dim>& problem) {
  if (problem.mesh.dim != dim)
    throw CannotPlan("the mesh has dimension " + std::to_string(problem.mesh.dim) + ", the problem " +
                     std::to_string(dim) + " (a column is a strip one cell wide in the MPM)");
  if (problem.stages.empty()) throw CannotPlan("the problem has no stage. Add one");
  double before = 0;
  const Stage* last = nullptr;
  for (const Stage& stage : problem.stages) {
    if (last && two_velocities(*last) && stage.liquid && !two_velocities(stage))
      throw CannotPlan(stage.origin + ": stage '" + stage.name + "' uses the scheme seepage after stage '" +
                       last->name +
                       "' used implicit-drag (whose water lies in the points; its nodal pressures, from which seepage "
                       "would start, hold another amount). Put the seepage stages first");
    last = &stage;
    if (!(stage.end_time > before))
      throw CannotPlan(stage.origin + ": stage '" + stage.name + "' ends at " + std::to_string(stage.end_time) +
                       " s, not after the one before it. Put stages in order of their end times");
    before = stage.end_time;
  }
  for (int region : problem.mesh.region)
    if (region < 0 || static_cast<std::size_t>(region) >= problem.soils.size())
      throw CannotPlan("the mesh has more regions than the problem has soils (every region needs one)");
  if (problem.water && problem.initial_pressure.size() != problem.mesh.node_count())
    throw CannotPlan("the scene has water, but no initial pressure for each of its " +
                     std::to_string(problem.mesh.node_count()) + " mesh nodes. Say how the water lies at the start");
  check_numbers(problem);
}

template <int dim>
std::unique_ptr<StagePlan<dim>> make_plan(const Problem<dim>& problem, std::size_t stage, Fields<dim>& fields) {
  auto plan = std::make_unique<StagePlan<dim>>(problem, stage, fields);
  join_gravity(*plan);
  const auto cycle = join_skeleton(*plan);
  join_liquid(*plan, cycle);
  if (cycle != nullptr && plan->stage.motion == SkeletonMotion::dynamic)
    plan->join(std::make_unique<MotionLedger<dim>>(problem.soils.front().elastic->origin, cycle));
  if (plan->stage.ends_with == StageEnd::rest) plan->join(std::make_unique<RestWatch<dim>>(plan->stage.origin));
  if (!problem.riders.empty()) plan->join(std::make_unique<Riders<dim>>(problem.riders.front().origin));
  if (!problem.probes.empty()) plan->join(std::make_unique<Probes<dim>>(problem.probes.front().origin));
  plan->check();
  return plan;
}

template <int dim>
std::unique_ptr<StagePlan<dim>> make_plan_of_weakened_rest(const Problem<dim>& problem, std::size_t stage,
                                                           Fields<dim>& fields) {
  auto plan = std::make_unique<StagePlan<dim>>(problem, stage, fields);
  join_gravity(*plan);
  plan->join(std::make_unique<WeakenedRest<dim>>(plan->stage.origin, join_skeleton(*plan)));
  plan->check();
  return plan;
}

template void check(const Problem<2>&);
template void check(const Problem<3>&);
template std::unique_ptr<StagePlan<2>> make_plan(const Problem<2>&, std::size_t, Fields<2>&);
template std::unique_ptr<StagePlan<3>> make_plan(const Problem<3>&, std::size_t, Fields<3>&);
template std::unique_ptr<StagePlan<2>> make_plan_of_weakened_rest(const Problem<2>&, std::size_t, Fields<2>&);
template std::unique_ptr<StagePlan<3>> make_plan_of_weakened_rest(const Problem<3>&, std::size_t, Fields<3>&);

}  // namespace wetfront::mpm
