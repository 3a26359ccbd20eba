#include "verification/run/problem_hash.h"

#include "verification/run/content_hash.h"
#include "verification/run/version.h"

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

/// Every struct is taken apart by name of all its members: one more member, and this does not compile until it is
/// part of the hash.
class ProblemHash {
 public:
  void add(const fem::RichardsProblem& problem) {
    const auto& [mesh, gravity, unit_weight, soils, conductivity_factor, boundary, initial_head, end_time, output_times,
                 gauges, integrator, tolerance, degree, adaptivity, source] = problem;
    add(mesh);
    hash_.add(gravity);
    hash_.add(unit_weight);
    each(soils);
    hash_.add(conductivity_factor);
    each(boundary);
    hash_.add(initial_head);
    hash_.add(end_time);
    hash_.add(output_times);
    each(gauges);
    hash_.add(integrator);
    hash_.add(tolerance);
    hash_.add(degree);
    hash_.add(adaptivity.has_value());
    if (adaptivity) add(*adaptivity);
    readable_ = readable_ && !source;
  }
  std::optional<std::string> text() {
    hash_.add(std::string_view(version::reference_code));
    return readable_ ? std::optional(hash_.text()) : std::nullopt;
  }

 private:
  template <class Entry>
  void each(const std::vector<Entry>& entries) {
    hash_.add(entries.size());
    for (const Entry& entry : entries) add(entry);
  }
  template <class... Alternatives>
  void add(const std::variant<Alternatives...>& variant) {
    hash_.add(variant.index());
    std::visit([this](const auto& alternative) { add(alternative); }, variant);
  }
  template <class... Numbers>
  void numbers(const Numbers&... number) {
    (hash_.add(number), ...);
  }

  void add(const meshes::Mesh& mesh) {
    const auto& [dim, nodes, cells, region, region_names, sides] = mesh;
    numbers(dim, nodes, cells, region, region_names);
    each(sides);
  }
  void add(const meshes::Side& side) {
    const auto& [name, faces] = side;
    numbers(std::string_view(name), faces);
  }
  void add(const fem::Gauge& gauge) {
    const auto& [name, position] = gauge;
    numbers(std::string_view(name), position);
  }
  void add(const fem::Adaptivity& adaptivity) {
    const auto& [levels, threshold] = adaptivity;
    numbers(levels, threshold);
  }

  void add(const fem::Soil& soil) {
    const auto& [name, retention, conductivity, saturated_conductivity, specific_storage, porosity, anisotropy,
                 oedometer_modulus, bishop] = soil;
    hash_.add(std::string_view(name));
    add(retention);
    add(conductivity);
    numbers(saturated_conductivity, specific_storage, porosity, anisotropy, oedometer_modulus, bishop);
  }
  void add(const fem::VanGenuchten& law) {
    const auto& [theta_r, theta_s, alpha, n, air_entry] = law;
    numbers(theta_r, theta_s, alpha, n, air_entry);
  }
  void add(const fem::ExponentialRetention& law) {
    const auto& [theta_r, theta_s, alpha] = law;
    numbers(theta_r, theta_s, alpha);
  }
  void add(const fem::HaverkampRetention& law) {
    const auto& [theta_r, theta_s, a, beta] = law;
    numbers(theta_r, theta_s, a, beta);
  }
  void add(const fem::HaverkampLogRetention& law) {
    const auto& [theta_r, theta_s, a, beta, entry] = law;
    numbers(theta_r, theta_s, a, beta, entry);
  }
  void add(const fem::BroadbridgeWhiteRetention& law) {
    const auto& [theta_r, theta_s, c, lambda] = law;
    numbers(theta_r, theta_s, c, lambda);
  }
  void add(const fem::TabulatedRetention& law) {
    const auto& [head, content] = law;
    numbers(head, content);
  }
  void add(const fem::MualemConductivity&) {}
  void add(const fem::ConstantConductivity&) {}
  void add(const fem::BroadbridgeWhiteConductivity&) {}
  void add(const fem::ExponentialConductivity& law) {
    const auto& [alpha] = law;
    numbers(alpha);
  }
  void add(const fem::HaverkampConductivity& law) {
    const auto& [a, gamma] = law;
    numbers(a, gamma);
  }
  void add(const fem::TabulatedConductivity& law) {
    const auto& [head, relative] = law;
    numbers(head, relative);
  }

  void add(const meshes::RainRecord& rain) {
    const auto& [start, intensity] = rain;
    numbers(start, intensity);
  }
  void add(const fem::TimeRecord& record) {
    const auto& [time, value] = record;
    numbers(time, value);
  }
  void add(const fem::RainSide& condition) {
    const auto& [side, rain, evaporation, minimum_head] = condition;
    numbers(std::string_view(side), minimum_head);
    add(rain);
    add(evaporation);
  }
  void add(const fem::FluxSide& condition) {
    const auto& [side, inflow, minimum_head] = condition;
    numbers(std::string_view(side), minimum_head);
    add(inflow);
  }
  void add(const fem::HeadSide& condition) {
    const auto& [side, head, record, total, initial, varying] = condition;
    numbers(std::string_view(side), head, total, initial);
    add(record);
    readable_ = readable_ && !varying;
  }
  void add(const fem::WaterLevelSide& condition) {
    const auto& [side, level, rain] = condition;
    numbers(std::string_view(side));
    add(level);
    add(rain);
  }
  void add(const fem::PeriodicSides& condition) {
    const auto& [side, partner] = condition;
    numbers(std::string_view(side), std::string_view(partner));
  }
  void add(const fem::FreeDrainageSide& condition) {
    const auto& [side] = condition;
    numbers(std::string_view(side));
  }

  ContentHash hash_;
  bool readable_ = true;
};

}  // namespace

std::optional<std::string> problem_hash(const fem_reference::RichardsProblem& problem) {
  ProblemHash hash;
  hash.add(problem);
  return hash.text();
}

}  // namespace wetfront::verification
