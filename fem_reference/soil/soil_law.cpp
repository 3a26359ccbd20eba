#include "fem_reference/soil/soil_law.h"

#include <cmath>
#include <limits>

namespace wetfront::fem_reference {
namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

}  // namespace

SoilLaw::SoilLaw(const Soil& soil, double unit_weight) : soil_(soil), conductivity_scale_(soil.saturated_conductivity) {
  std::visit(Overloaded{[&](const TabulatedRetention& table) {
                          theta_r_ = table.content.front();
                          theta_s_ = table.content.back();
                          content_table_ = MonotoneCubic(table.head, table.content);
                          // Equal contents at the wet end: the soil stays full down to the driest of them.
                          for (std::size_t i = table.head.size(); i-- > 0 && table.content[i] == theta_s_;) {
                            air_entry_ = -table.head[i];
                          }
                        },
                        [&](const auto& law) {
                          theta_r_ = law.theta_r;
                          theta_s_ = law.theta_s;
                        }},
             soil_.retention);
  content_scale_ = theta_s_ - theta_r_;
  porosity_ = soil.porosity > 0 ? soil.porosity : theta_s_;
  if (const auto* law = std::get_if<VanGenuchten>(&soil_.retention); law != nullptr && law->air_entry > 0) {
    air_entry_ = law->air_entry;
    content_scale_ /= effective_saturation(*law, -air_entry_).value;
    if (std::holds_alternative<MualemConductivity>(soil_.conductivity)) {
      conductivity_entry_ = air_entry_;
      conductivity_scale_ /= mualem(*law, -air_entry_).value;
    }
  }
  if (const auto* law = std::get_if<HaverkampLogRetention>(&soil_.retention)) air_entry_ = law->entry;
  if (const auto* table = std::get_if<TabulatedConductivity>(&soil_.conductivity)) {
    std::vector<double> logarithm;
    for (double k : table->relative) logarithm.push_back(std::log(k));
    log_conductivity_table_ = MonotoneCubic(table->head, logarithm);
  }
  // Mualem's K of van Genuchten's curve with n < 2 falls from Ks with a vertical tangent (by half within 1e-6 m where
  // n = 1.1), which no Newton passes: a cubic within the first tenth of a millimetre.
  if (const auto* law = std::get_if<VanGenuchten>(&soil_.retention);
      law != nullptr && law->n < 2 && conductivity_entry_ == 0 &&
      std::holds_alternative<MualemConductivity>(soil_.conductivity)) {
    constexpr double top = 1e-4;  // m
    at_top_ = conductivity(-top);
    smooth_top_ = top;
  }
  conductivity_integral_ = ConductivityIntegral([&](double head) { return conductivity(head).value; });
  if (soil.oedometer_modulus > 0) {
    skeleton_.emplace(
        -air_entry_, [&](double head) { return skeleton_rate(head, unit_weight); },
        [&](double head) { return water_content(head).slope; });
  }
}

double SoilLaw::skeleton_rate(double head, double unit_weight) const {
  const ValueAndSlope theta = water_content(head);
  const bool effective = soil_.bishop == Soil::Bishop::effective_saturation;
  const double dry = effective ? theta_r_ : 0, range = effective ? theta_s_ - theta_r_ : porosity_;
  const double chi = (theta.value - dry) / range, chi_slope = theta.slope / range;
  return theta.value / porosity_ * (chi + head * chi_slope) * unit_weight / soil_.oedometer_modulus;
}

double SoilLaw::skeleton_limit() const {
  if (!skeleton_ || skeleton_->limit() <= SkeletonStorage::driest_head) {
    return -std::numeric_limits<double>::infinity();
  }
  return skeleton_->limit();
}

ValueAndSlope SoilLaw::water_content(double head) const {
  if (head >= -air_entry_) return {theta_s_, 0};
  return std::visit(Overloaded{[&](const TabulatedRetention&) -> ValueAndSlope { return content_table_(head); },
                               [&](const auto& law) -> ValueAndSlope {
                                 const ValueAndSlope se = effective_saturation(law, head);
                                 return {theta_r_ + content_scale_ * se.value, content_scale_ * se.slope};
                               }},
                    soil_.retention);
}

ValueAndSlope SoilLaw::storage(double head) const {
  ValueAndSlope theta = water_content(head);
  if (head > -air_entry_) {
    theta.value += soil_.specific_storage * (head + air_entry_);
    theta.slope += soil_.specific_storage;
  }
  if (skeleton_) {
    const ValueAndSlope more = (*skeleton_)(head);
    theta.value += more.value;
    theta.slope += more.slope;
  }
  return theta;
}

ValueAndSlope SoilLaw::conductivity(double head) const {
  if (head >= -conductivity_entry_) return {soil_.saturated_conductivity, 0};
  if (head > -smooth_top_) return conductivity_near_saturation(head);
  const ValueAndSlope kr = relative_conductivity(head);
  return {conductivity_scale_ * kr.value, conductivity_scale_ * kr.slope};
}

ValueAndSlope SoilLaw::conductivity_near_saturation(double head) const {
  const double t = -head / smooth_top_;  // 0 at saturation, where K is flat
  const double drop = soil_.saturated_conductivity - at_top_.value, slope = smooth_top_ * at_top_.slope;
  const double c2 = 3 * drop - slope, c3 = slope - 2 * drop;
  return {soil_.saturated_conductivity - t * t * (c2 + t * c3), t * (2 * c2 + 3 * t * c3) / smooth_top_};
}

ValueAndSlope SoilLaw::relative_conductivity(double head) const {
  return std::visit(
      Overloaded{[&](const MualemConductivity&) { return mualem(std::get<VanGenuchten>(soil_.retention), head); },
                 [&](const ExponentialConductivity& law) -> ValueAndSlope {
                   const double value = std::exp(law.alpha * head);
                   return {value, law.alpha * value};
                 },
                 [](const ConstantConductivity&) -> ValueAndSlope {
                   return {1, 0};
                 },
                 [&](const HaverkampConductivity& law) { return fem_reference::relative_conductivity(law, head); },
                 [&](const BroadbridgeWhiteConductivity&) {
                   return broadbridge_white(std::get<BroadbridgeWhiteRetention>(soil_.retention), head);
                 },
                 [&](const TabulatedConductivity&) -> ValueAndSlope {
                   const ValueAndSlope log_k = log_conductivity_table_(head);
                   const double value = std::exp(log_k.value);
                   return {value, value * log_k.slope};
                 }},
      soil_.conductivity);
}

}  // namespace wetfront::fem_reference
