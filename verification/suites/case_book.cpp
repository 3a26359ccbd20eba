#include "verification/suites/case_book.h"

#include "mpm/simulation.h"
#include "verification/compare/verdict.h"
#include "verification/run/provenance.h"
#include "verification/suites/problem_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

double counter(const meshes::FieldHistory& history, const std::string& name) {
  const auto found = history.counters.find(name);
  return found == history.counters.end() ? 0 : found->second;
}

/// Runs at reference tolerances owe the stricter balance.
constexpr double reference_tolerance = 1e-6;

}  // namespace

double relative_imbalance(const meshes::FieldHistory& history) {
  const auto& ledger = history.ledger;
  double passed = 0, worst = 0;
  for (const meshes::SideLedger& side : history.sides)
    for (std::size_t i = 1; i < side.outflow.size(); ++i)
      passed += std::abs(side.asked[i] - side.run_off[i] - side.asked[i - 1] + side.run_off[i - 1]) +
                std::abs(side.outflow[i] - side.outflow[i - 1]) + std::abs(side.evaporated[i] - side.evaporated[i - 1]);
  for (const auto& row : ledger) {
    const double error = row.stored - ledger.front().stored - row.infiltrated + row.outflow;
    worst = std::isfinite(error) ? std::max(worst, std::abs(error)) : std::numeric_limits<double>::infinity();
  }
  return passed > 0 ? worst / passed : worst / ledger.front().stored;
}

CaseBook::CaseBook(const Case& test) {
  record_.case_name = test.name;
  record_.title = test.title;
  record_.requirement = test.requirement + " Source: " + test.source;
  runs_ = {"Runs",
           "Cost",
           "One row per solution; water imbalance relative to |inflow| + |outflow|.",
           {"run", "DoF", "tolerance", "steps", "Newton", "failed solves", "CPU [s]", "water imbalance"},
           {}};
}

void CaseBook::describe(reports::Table setup) {
  const auto told = [&](const reports::Table& table) { return table.section == setup.section; };
  if (std::none_of(record_.tables.begin(), record_.tables.end(), told)) record_.tables.push_back(std::move(setup));
}

void CaseBook::sign(const meshes::Mesh& mesh, int threads) {
  record_.provenance = provenance(record_.case_name, mesh, threads);
}

void CaseBook::enter(const std::string& label, const meshes::FieldHistory& history, double tolerance) {
  const double imbalance = relative_imbalance(history);
  Balance& balance = tolerance <= reference_tolerance ? at_reference_ : at_default_;
  balance.worst = std::max(balance.worst, imbalance);
  ++balance.runs;
  const double dofs = counter(history, "degrees of freedom");
  if (dofs >= degrees_of_freedom_) sign(history.mesh, 1);
  degrees_of_freedom_ = std::max(degrees_of_freedom_, dofs);
  record_.cpu_seconds += history.cpu_seconds;
  runs_.rows.push_back({label, fmt::format("{:g}", dofs), fmt::format("{:g}", tolerance),
                        fmt::format("{:g}", counter(history, "steps")),
                        fmt::format("{:g}", counter(history, "Newton iterations")),
                        fmt::format("{:g}", counter(history, "failed nonlinear solves")),
                        fmt::format("{:.3f}", history.cpu_seconds), fmt::format("{:.1e}", imbalance)});
}

meshes::FieldHistory CaseBook::solve(const std::string& label, const mpm::Problem<2>& problem) {
  describe(problem_setup(problem));
  try {
    meshes::FieldHistory history = mpm::run(problem);
    enter(label, problem, history);
    return history;
  } catch (const mpm::GaveUp& failure) {
    enter(label + " (gave up)", problem, failure.partial);
    throw;
  }
}

void CaseBook::enter(const std::string& label, const mpm::Problem<2>& problem, const meshes::FieldHistory& history) {
  point_runs_.enter(label, problem, history);
  const double nodes = static_cast<double>(history.mesh.node_count());
  if (nodes >= degrees_of_freedom_) sign(history.mesh, problem.threads);
  spend(history.cpu_seconds, nodes);
}

reports::Finding& CaseBook::add(const std::string& quantity, const std::string& description, double error,
                                const Gate& gate) {
  reports::Finding& out = record_.findings.emplace_back();
  out.quantity = quantity;
  out.description = description;
  out.unit = gate.unit;
  out.error = error;
  out.tolerance = gate.tolerance;
  out.reason = gate.reason;
  return out;
}

void CaseBook::judge(const std::string& quantity, const std::string& description, double error, const Gate& gate) {
  reports::Finding& out = add(quantity, description, error, gate);
  // Nothing is uncertain here but the number itself: what is not a number has failed.
  out.verdict = std::isnan(error) ? reports::Verdict::fail : verdict(error, 0, gate.tolerance);
}

void CaseBook::expect(const std::string& quantity, const std::string& description, double measured, double expected,
                      const Gate& gate) {
  const double difference = std::abs(measured - expected);
  judge(quantity, fmt::format("{}: {:.6g}, expected {:.6g}", description, measured, expected),
        gate.unit == "1" ? difference / std::abs(expected) : difference, gate);
}

void CaseBook::judge_order(const std::string& quantity, const std::string& description, double order,
                           const OrderGate& gate) {
  const double middle = 0.5 * (gate.lowest + gate.highest);
  judge(quantity, fmt::format("{}: {:.3f} (wanted: {:g} to {:g})", description, order, gate.lowest, gate.highest),
        std::abs(order - middle), {0.5 * (gate.highest - gate.lowest), "orders", gate.reason});
  record_.findings.back().explanation = fmt::format("distance from {:g}", middle);
  orders_ += fmt::format("{}{:.2f}", orders_.empty() ? "" : ", ", order);
}

void CaseBook::show(const std::string& quantity, const std::string& description, double value,
                    const std::string& unit) {
  add(quantity, description, value, {0, unit, ""});
}

void CaseBook::judge_balance() {
  const char* reason = "the mixed form conserves water to the Newton tolerance, at any step";
  if (at_reference_.runs > 0)
    judge("water_balance", fmt::format("water balance, worst of {} runs at tolerance 1e-6 or less", at_reference_.runs),
          at_reference_.worst, {1e-8, "1", reason});
  if (at_default_.runs > 0)
    judge("water_balance", fmt::format("water balance, worst of {} runs at more than 1e-6", at_default_.runs),
          at_default_.worst, {1e-7, "1", reason});
}

void CaseBook::judge_points() {
  const auto judge_all = [&](const PointRuns::Worst& worst, const std::string& who, const Gate& nodes) {
    if (worst.runs == 0) return;
    const auto text = [&](const char* what) {
      return fmt::format("{}, worst of {} runs of {}", what, worst.runs, who);
    };
    judge("water_balance", text("rain not delivered"), worst.audit.nodes, nodes);
    judge("water_balance", text("rain not delivered, summed over points"), worst.audit.points,
          {1e-4, "1", "the points hold the water that the nodes do, but for the mean over a cell of a curved law"});
    judge(
        "overshoot", text("pressure above what it may be"), worst.audit.overshoot,
        {1, "Pa", "ponding inside the Newton step left none in trials; a lagged switch overshoots by 6 kPa and more"});
  };
  judge_all(point_runs_.seepage(), "seepage",
            {1e-8, "1", "nodal sums are conserved to the residual of Newton's method, 1e-9 in trials"});
  judge_all(point_runs_.two_velocities(), "schemes with inertia",
            {1e-6, "1", "conserved to round-off over up to 1e5 steps"});
}

reports::Record CaseBook::finish(const std::string& failure) {
  judge_balance();
  judge_points();
  if (!failure.empty()) {
    judge("completes", "every run of the case completes", 1, {0, "failures", "a reference that stops judges nothing"});
    record_.findings.back().explanation = failure;
    record_.log.push_back(failure);
  }
  record_.verdict = overall(record_.findings);
  if (!point_runs_.empty()) record_.tables.push_back(point_runs_.table());
  if (!runs_.rows.empty()) record_.tables.push_back(runs_);
  if (!orders_.empty()) record_.provenance["observed_orders"] = orders_;
  if (degrees_of_freedom_ > 0) record_.provenance["degrees_of_freedom"] = fmt::format("{:g}", degrees_of_freedom_);
  return std::move(record_);
}

reports::Record run_case(const Case& test) {
  CaseBook book(test);
  try {
    test.run(book);
  } catch (const std::exception& failure) {
    return book.finish(failure.what());
  }
  return book.finish();
}

}  // namespace wetfront::verification
