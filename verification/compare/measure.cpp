#include "verification/compare/measure.h"

#include "verification/compare/balance.h"
#include "verification/compare/events.h"
#include "verification/compare/measuring.h"
#include "verification/compare/profile.h"
#include "verification/compare/side_flux.h"
#include "verification/scene/weather.h"
#include "verification/translate/initial_pressure.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {

void Measuring::infiltration() {
  for (std::size_t t = 0; t < timeline_.comparison_times.size(); ++t) {
    const double time = timeline_.comparison_times[t];
    const Read taken = read_number([&](const meshes::FieldHistory& history) {
      return ledger_at(history.ledger, &meshes::LedgerRow::infiltrated, time) / area_of(history);
    });
    const double a = taken.candidate[0], b = taken.reference.reference[0];
    // Where all rain runs off, what both take in is round-off of the rain, and its ratio says nothing.
    const double noise = 1e-9 * rain_asked(scene_, candidate_.mesh, time) / area_of(candidate_);
    if (!(a > noise || b > noise)) continue;
    add({"cumulative_infiltration", "cumulative infiltration" + at_time(t), static_cast<int>(t)}, taken,
        of_numbers(relative_difference), fmt::format("candidate {:.6g} m, reference {:.6g} m", a, b));
  }
}

void Measuring::events() {
  const Read ponding = read_number([](const meshes::FieldHistory& history) { return ponding_time(history.ledger); });
  add_event({"ponding_time", "time of ponding [s]"}, ponding);
  // Where the soil takes all rain until it is full, it is full when it ponds: deficit / rain, with no solver involved.
  if (!timeline_.filling_time || timeline_.end() < *timeline_.filling_time) return;
  const double expected = *timeline_.filling_time;
  const double before = ledger_at(reference_.ledger, &meshes::LedgerRow::run_off, 0.99 * expected);
  if (before > 1e-6 * ledger_at(reference_.ledger, &meshes::LedgerRow::rain_asked, expected)) return;
  const double candidate = ponding.candidate[0], reference = ponding.reference.reference[0];
  Measurement filling{"filling_time", "filling time against storage deficit / rain", -1, "", 0, {}, ""};
  filling.error = relative_difference(candidate, expected);
  filling.reference.bound = relative_difference(reference, expected);  // here the truth is known
  filling.explanation = fmt::format("candidate {} s, deficit / rain {:.6g} s, reference {} s", value_text(candidate),
                                    expected, value_text(reference));
  add(std::move(filling));
}

void Measuring::gauges() {
  const double unit_weight = scene_.water->density * gravity_magnitude(scene_);
  for (const meshes::Gauge& gauge : candidate_.gauges) {
    const auto of_gauge = [&](auto value) {
      return read_number([&](const meshes::FieldHistory& history) {
        for (const meshes::Gauge& other : history.gauges)
          if (other.name == gauge.name) return static_cast<double>(value(other));
        return nothing;
      });
    };
    add_event({"arrival_time", "p > 0.2 kPa at probe " + gauge.name + " [s]", -1, gauge.name},
              of_gauge([](const meshes::Gauge& g) { return crossing_time(g, arrival_pressure); }));
    add_event({"rise_rate", "rise of head at probe " + gauge.name + " [m/s]", -1, gauge.name},
              of_gauge([&](const meshes::Gauge& g) { return rise_rate(g, unit_weight); }));
  }
}

void Measuring::balances() {
  const auto own = [&](const std::string& quantity, const std::string& description, double error,
                       std::string explanation = "") {
    add({quantity, description, -1, "", error, {}, std::move(explanation)});
  };
  own("water_balance", "water balance of the candidate, nodal", imbalance(candidate_.ledger, timeline_.stage_end));
  own("reference_balance", "water balance of the reference", imbalance(reference_.ledger, {timeline_.end()}));
  const double end = candidate_.ledger.back().time;
  const double asked = rain_asked(scene_, candidate_.mesh, end);
  if (!(asked > 0)) return;
  if (std::ranges::none_of(scene_.rains, [&](const Rain& rain) { return under_water(scene_, rain.side); }))
    own("rain_asked", "rain the candidate's boundary was asked for, against the scene",
        relative_difference(candidate_.ledger.back().rain_asked, asked));
  double from = 0, worst_nodal = 0, worst_points = 0;
  for (const double until : timeline_.stage_end) {
    worst_nodal = std::max(worst_nodal, undelivered(candidate_.ledger, from, until, Sum::nodal));
    const double points = undelivered(candidate_.ledger, from, until, Sum::points);
    if (!std::isnan(points)) worst_points = std::max(worst_points, points);
    from = until;
  }
  own("rain_delivered", "rain delivered, from stored water, against asked less run-off", worst_nodal,
      fmt::format("the same from particle sums: {:.3g}", worst_points));
}

/// Net water that came in through each side that both solutions know, against the largest of them.
void Measuring::side_fluxes() {
  for (std::size_t t = 0; t < timeline_.comparison_times.size(); ++t) {
    const double time = timeline_.comparison_times[t];
    const std::vector<std::string> sides = common_sides(candidate_, reference_);
    if (sides.size() < 2) return;  // one side alone is the water balance again
    const Read passed = read([&](const meshes::FieldHistory& history) {
      std::vector<double> net;
      for (const std::string& side : sides) net.push_back(net_inflow(history, side, time));
      return net;
    });
    const std::vector<double> alike(sides.size(), 1);
    std::string text;
    for (std::size_t i = 0; i < sides.size(); ++i)
      text += fmt::format("{}{}: candidate {:.6g}, reference {:.6g}", i == 0 ? "" : "; ", sides[i], passed.candidate[i],
                          passed.reference.reference[i]);
    add(
        {"side_inflow", "net inflow through each side" + at_time(t), static_cast<int>(t)}, passed,
        [&](const auto& a, const auto& b) { return relative_linf(a, b, alike); }, text);
  }
}

/// Rain refused and water that left, at the last time that every solution reached.
void Measuring::water_lost() {
  double end = timeline_.end();
  for (const auto* one : {&candidate_, &reference_, &histories_.finer, &histories_.tighter})
    end = std::min(end, one->ledger.empty() ? 0 : one->ledger.back().time);
  if (histories_.coarser && !histories_.coarser->ledger.empty())
    end = std::min(end, histories_.coarser->ledger.back().time);
  const double rain = rain_asked(scene_, candidate_.mesh, end) / area_of(candidate_);
  if (!(rain > 0)) return;
  const auto lost = [&](const char* quantity, const char* description, double meshes::LedgerRow::*column) {
    const Read share = read_number([&](const meshes::FieldHistory& history) {
      const double value = ledger_at(history.ledger, column, end) / area_of(history) / rain;
      return std::abs(value) < 1e-6 ? 0 : value;  // what tolerances of the solvers leave of the rain
    });
    const double a = share.candidate[0], b = share.reference.reference[0];
    add({quantity, fmt::format("{} until {:.6g} s, over the rain fallen", description, end)}, share,
        of_numbers(absolute_difference),
        a == 0 && b == 0 ? "none in either"
                         : fmt::format("candidate {:.6g} mm, reference {:.6g} mm of {:.6g} mm", 1e3 * rain * a,
                                       1e3 * rain * b, 1e3 * rain));
  };
  // Rain on water is no rain on the ground; solvers differ in whether they count it as refused.
  if (std::ranges::none_of(scene_.rains, [&](const Rain& one) { return under_water(scene_, one.side); }))
    lost("run_off", "rain refused", &meshes::LedgerRow::run_off);
  lost("outflow", "water that left through other sides", &meshes::LedgerRow::outflow);
}

std::vector<Measurement> measure(const Scene& scene, const Timeline& timeline, const Histories& histories) {
  return Measuring(scene, timeline, histories).all();
}

}  // namespace wetfront::verification
