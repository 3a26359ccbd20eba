#include "verification/exact/srivastava_yeh_two_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "tests/exact/derivative.h"
#include "tests/exact/printed.h"
#include "verification/exact/quadrature.h"
#include "verification/exact/srivastava_yeh.h"

namespace wetfront::verification::exact {
namespace {

// cm and h
SrivastavaYehTwoLayer problem(double ks1, double ks2, double l1 = 100, double l2 = 100) {
  return {0.1, {ks1, 0.06, 0.40, l1}, {ks2, 0.06, 0.40, l2}, 0.1, 0.9};
}

double conductivity(const SrivastavaYehTwoLayer& p, double z) {
  return z < 0 ? p.lower.conductivity : p.upper.conductivity;
}

/// Largest failure of theta_t = d/dz [K (psi_z + 1)] over both layers, of the printed flux, and of continuity at z = 0.
struct Residuals {
  double richards = 0, flux = 0, head_jump = 0, flux_jump = 0, surface = 0;
};

Residuals residuals(const SrivastavaYehTwoLayer& p, const SrivastavaYehTwoLayerSolution& s, double t) {
  Residuals r;
  const double l1 = p.lower.thickness, l2 = p.upper.thickness;
  for (double z : {-0.7 * l1, -0.3 * l1, 0.3 * l2, 0.7 * l2}) {
    const double step = 0.04 * std::min(l1, l2), ks = conductivity(p, z);
    const auto head = [&](double at) { return s.head(at, t); };
    const double slope = derivative(head, z, step), k = ks * std::exp(p.alpha * head(z));
    const double advective = p.alpha * k * slope * (slope + 1), diffusive = k * derivative(head, z, step, 2);
    r.flux = std::max(r.flux, std::abs(k * (slope + 1) - s.flux(z, t)) / 0.9);
    if (std::abs(s.content(z, t) - s.content(z, 0)) < 1e-4) continue;
    const double rate = derivative([&](double at) { return s.content(z, at); }, t, 0.2 * t);
    r.richards = std::max(
        r.richards, relative_residual(rate, advective + diffusive, std::max(std::abs(advective), std::abs(diffusive))));
  }
  const double sliver = 1e-9 * std::min(l1, l2);  // just below: the branch of the lower layer
  r.head_jump = std::abs(s.head(0, t) - s.head(-sliver, t));
  r.flux_jump = std::abs(s.flux(0, t) - s.flux(-sliver, t));
  r.surface = std::abs(s.flux(l2, t) - p.flux_after);
  return r;
}

TEST(SrivastavaYehTwoLayers, PrintedNumbers) {
  const SrivastavaYehTwoLayerSolution s(problem(10, 1));
  const double interface[][2] = {
      {0, -46.006857}, {10, -45.749626}, {20, -36.852090}, {50, -24.905179}, {100, -24.082766}};
  for (const auto& row : interface) expect_printed(s.head(0, row[0]), row[1], 6, "z = 0");
  const double middle[][2] = {{10, -14.469684}, {20, -5.544640}, {50, -1.356714}};
  for (const auto& row : middle) expect_printed(s.head(50, row[0]), row[1], 6, "z = 50");
}

TEST(SrivastavaYehTwoLayers, SatisfiesRichardsInBothLayersAndAcross) {
  // beta > 1, < 1, far contrasts, thin over thick, thick over thin, and unequal content ranges
  std::vector<SrivastavaYehTwoLayer> cases = {problem(10, 1),           problem(1, 10),
                                              problem(100, 1, 40, 100), problem(1, 100, 100, 40),
                                              problem(1, 1, 60, 130),   problem(3, 1, 20, 5)};
  cases.push_back({0.05, {2, 0.05, 0.30, 80}, {5, 0.1, 0.5, 30}, 1.5, 0.2, -10});
  Residuals worst;
  for (const SrivastavaYehTwoLayer& p : cases) {
    const SrivastavaYehTwoLayerSolution s(p);
    for (double t : {10.0, 20.0, 50.0}) {
      const Residuals r = residuals(p, s, t);
      worst.richards = std::max(worst.richards, r.richards), worst.flux = std::max(worst.flux, r.flux);
      worst.head_jump = std::max(worst.head_jump, r.head_jump),
      worst.flux_jump = std::max(worst.flux_jump, r.flux_jump);
      worst.surface = std::max(worst.surface, r.surface);
    }
  }
  expect_residual(worst.richards, 1e-6, "two_layer");             // second differences of a head with 12 digits
  expect_residual(worst.flux, 1e-8, "two_layer_flux");            // first differences
  expect_residual(worst.head_jump, 1e-6, "two_layer_head_jump");  // |psi_z| <= 10 over a sliver of 1e-7 cm
  expect_residual(worst.flux_jump, 1e-6, "two_layer_flux_jump");
  expect_residual(worst.surface, 1e-12, "two_layer_surface_flux");
}

TEST(SrivastavaYehTwoLayers, MassCloses) {
  for (const auto& p : {problem(10, 1), problem(1, 10, 100, 40)}) {
    const SrivastavaYehTwoLayerSolution s(p);
    const double l1 = p.lower.thickness, l2 = p.upper.thickness;
    for (double t : {5.0, 20.0, 60.0}) {
      // stored since a first instant t0 (the series needs t > 0), against the fluxes at both ends
      const double t0 = 0.05;
      const auto storage = [&](double at) {
        const auto content = [&](double z) { return s.content(z, at); };
        return integrate(content, -l1, -1e-13, 1e-10) + integrate(content, 0, l2, 1e-10);
      };
      const double stored = storage(t) - storage(t0);
      const double drained = integrate([&](double at) { return s.flux(-l1, at); }, t0, t, 1e-9);
      EXPECT_NEAR(stored, 0.9 * (t - t0) - drained, 2e-8) << t;  // 1e-10 of 50 cm stored, 1e-9 of what drained
    }
  }
}

TEST(SrivastavaYehTwoLayers, OfOneSoilIsOneLayer) {
  const SrivastavaYehTwoLayerSolution two(problem(1, 1, 30, 70));
  const SrivastavaYehSolution one({0.1, 1, 0.06, 0.40, 100, 0.1, 0.9});
  for (double t : {1.0, 10.0, 50.0})
    for (double z : {10.0, 30.0, 50.0, 100.0}) EXPECT_NEAR(two.head(z - 30, t), one.head(z, t), 1e-9) << z << " " << t;
}

TEST(SrivastavaYehTwoLayers, StartsAndEndsSteady) {
  const SrivastavaYehTwoLayer p = problem(10, 1, 100, 40);
  const SrivastavaYehTwoLayerSolution s(p);
  for (double z : {-100.0, -50.0, 0.0, 20.0}) EXPECT_NEAR(s.head(z, 0.02), s.head(z, 0), 1e-6) << z;
  EXPECT_NEAR(s.flux(-60, 3000), 0.9, 1e-12);
  EXPECT_NEAR(s.head(-100, 3000), 0, 1e-12);
  const double below = 0.09 - (0.09 - 1) * std::exp(-10.0);
  EXPECT_NEAR(s.head(40, 3000), std::log(0.9 - (0.9 - below) * std::exp(-4.0)) / 0.1, 1e-9);
}

// Every Lambda is a root of F; none is missing: between neighbours F has no further sign change, and the count below a
// bound is Weyl's within one or two.
TEST(TwoLayerModes, NoRootIsMissedAndNoneInvented) {
  for (double contrast : {1e-4, 1e-2, 0.3, 1.0, 7.0, 1e2, 1e4})
    for (double ratio_of_lengths : {0.05, 1.0, 20.0})
      for (double beta : {contrast, 3 * contrast}) {
        const TwoLayerMedium m{3, 3 * ratio_of_lengths, beta, contrast};
        const auto modes = two_layer_modes(m, 60);
        double previous = 0;
        int scanned = 0;
        for (std::size_t n = 0; n < modes.size(); ++n) {
          const double here = modes[n].eigenvalue;
          ASSERT_GT(here, previous);
          // At large L2 the angle turns by pi within an ulp of Lambda, at small L2 it barely moves: bracket the root.
          const double target = std::numbers::pi * (n + 1) - std::atan(2.0);
          EXPECT_LT(pruefer_angle(m, here * (1 - 1e-11)), target);
          EXPECT_GT(pruefer_angle(m, here * (1 + 1e-11)), target);
          // F changes sign once on the way from each midpoint to the next
          const double next = n + 1 < modes.size() ? modes[n + 1].eigenvalue : here * 1.0001;
          const double before = 0.5 * (previous + here), after = 0.5 * (here + next);
          bool sign = characteristic(m, before) > 0;
          int changes = 0;
          for (int i = 1; i <= 400; ++i) {
            const bool now = characteristic(m, before + (after - before) * i / 400) > 0;
            changes += now != sign, sign = now;
          }
          EXPECT_EQ(changes, 1) << "contrast " << contrast << " lengths " << ratio_of_lengths << " mode " << n;
          scanned += changes, previous = here;
        }
        EXPECT_EQ(scanned, 60);
      }
}

TEST(TwoLayerModes, AreOrthogonalWithThePrintedNorm) {
  for (const TwoLayerMedium& m :
       {TwoLayerMedium{10, 10, 10, 10}, {10, 4, 0.1, 0.1}, {3, 8, 0.02, 0.05}, {2, 1, 40, 10}}) {
    const auto modes = two_layer_modes(m, 8);
    const auto lower = [&](const TwoLayerMode& u, double z) { return sine_over(u.lambda_squared, z + m.length1); };
    const auto upper = [&](const TwoLayerMode& u, double z) {
      const double x = m.length2 - z;
      return u.amplitude * (sine_over(u.mu_squared, x) + 2 * cosine(u.mu_squared, x));
    };
    for (const TwoLayerMode& a : modes)
      for (const TwoLayerMode& b : modes) {
        const double product = m.ratio * integrate([&](double z) { return lower(a, z) * lower(b, z); }, -m.length1, 0) +
                               m.beta * integrate([&](double z) { return upper(a, z) * upper(b, z); }, 0, m.length2);
        const double expected = &a == &b ? a.norm : 0;
        EXPECT_NEAR(product, expected, 1e-9 * std::sqrt(a.norm * b.norm));
      }
  }
}

// The trap of benchmarks.md 1.2: a public transcription puts L2/2 where the norm of the lower layer has L1/2. Unseen
// for equal thicknesses; for unequal ones the initial state is lost.
TEST(SrivastavaYehTwoLayers, TheTranscriptionWithL2InTheLowerNormFails) {
  const auto head_with = [](const SrivastavaYehTwoLayer& p, bool wrong, double z, double t) {
    const SrivastavaYehTwoLayerSolution s(p);
    const TwoLayerMedium& m = s.medium();
    const double rate = p.alpha * p.lower.conductivity / 0.34;
    double sum = 0;
    for (const TwoLayerMode& u : s.modes()) {
      const double swap = wrong ? m.ratio * (m.length2 - m.length1) / (2 * u.lambda_squared) : 0;
      const double x = m.length2 - p.alpha * z;
      const double shape = z < 0 ? sine_over(u.lambda_squared, m.length1 + p.alpha * z)
                                 : u.amplitude * (sine_over(u.mu_squared, x) + 2 * cosine(u.mu_squared, x));
      sum += 2 * u.amplitude * shape * std::exp(-u.eigenvalue * rate * t) / (u.eigenvalue * (u.norm + swap));
    }
    const double late = s.head(z, 1e5);
    return std::log(std::exp(p.alpha * late) -
                    0.8 / p.upper.conductivity * std::exp((m.length2 - p.alpha * z) / 2) * sum) /
           p.alpha;
  };
  const SrivastavaYehTwoLayer equal = problem(10, 1), unequal = problem(1, 10, 40, 100);
  double worst = 0;
  for (double z : {-35.0, -20.0, -5.0, 10.0, 30.0}) {
    EXPECT_NEAR(head_with(equal, true, z, 20), SrivastavaYehTwoLayerSolution(equal).head(z, 20), 1e-7) << z;
    const double right = SrivastavaYehTwoLayerSolution(unequal).head(z, 20);
    EXPECT_NEAR(head_with(unequal, false, z, 20), right, 1e-7) << z;
    worst = std::max(worst, std::abs(std::expm1(0.1 * (head_with(unequal, true, z, 20) - right))));
  }
  std::printf("[ trap ] error in K %.2g\n", worst);
  EXPECT_FALSE(worst < 0.05);
}

TEST(SrivastavaYehTwoLayers, RefusesWhatItCannotGive) {
  EXPECT_THROW(SrivastavaYehTwoLayerSolution(problem(10, 1), 3).head(50, 1), std::domain_error);
  const SrivastavaYehTwoLayerSolution s(problem(10, 1), 50);
  EXPECT_THROW(s.head(50, 1e-4), std::domain_error);
  EXPECT_THROW(s.head(-101, 1), std::domain_error);
  EXPECT_THROW(s.flux(0, -1), std::domain_error);
  EXPECT_THROW(SrivastavaYehTwoLayerSolution(problem(10, 0.5), 5), std::invalid_argument);  // 0.9 > Ks2
}

}  // namespace
}  // namespace wetfront::verification::exact
