#include "fem_reference/time/integrator.h"
#include "fem_reference/time/sundials.h"

#include <idas/idas.h>
#include <nvector/nvector_parallel.h>
#include <nvector/nvector_serial.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <span>
#include <utility>

namespace wetfront::fem_reference {
namespace {

N_Vector make_vector(sunindextype length, const Ranks& ranks, SUNContext context) {
  if (ranks.count() == 1) return N_VNew_Serial(length, context);
  const auto all = static_cast<sunindextype>(ranks.sum(static_cast<double>(length)));
  return N_VNew_Parallel(MPI_COMM_WORLD, length, all, context);
}

/// Variable-order, variable-step BDF of SUNDIALS IDAS on y = (W, psi), the stage kernel being its nonlinear
/// solver; the ledger rides along as IDAS quadratures with the same BDF, so that stored - inflow + outflow is
/// conserved to the Newton tolerance.
class Bdf : public TimeIntegrator {
 public:
  Bdf(StageKernel& kernel, Tolerances tolerances)
      : kernel_(kernel), n_(kernel.flow().space().dof_count), tolerances_(tolerances) {
    const Ranks& ranks = kernel.flow().space().ranks;
    MPI_Comm comm = MPI_COMM_WORLD;
    check(SUNContext_Create(ranks.count() > 1 ? &comm : nullptr, &context_), "SUNContext_Create");
    y_ = make_vector(2 * n_, ranks, context_);
    yp_ = make_vector(2 * n_, ranks, context_);
    totals_ = make_vector(static_cast<sunindextype>(std::max<std::size_t>(1, kernel.ledger_size())), ranks, context_);
    N_VConst(0, totals_);
    newton_ = make_stage_solver(this, solve_stage, context_);
  }

  ~Bdf() override {
    IDAFree(&ida_);
    SUNNonlinSolFreeEmpty(newton_);
    for (N_Vector v : {y_, yp_, totals_}) N_VDestroy(v);
    SUNContext_Free(&context_);
  }
  Bdf(const Bdf&) = delete;
  Bdf& operator=(const Bdf&) = delete;

  void start(const State& state) override {
    kernel_.set_time(state.time);
    const std::vector<double> water_rates = kernel_.rates(state.head);
    const std::vector<double> rates = head_rates(kernel_.flow(), water_rates);
    std::copy(state.water.begin(), state.water.end(), view(y_).begin());
    std::copy(state.head.begin(), state.head.end(), view(y_).begin() + n_);
    std::copy(water_rates.begin(), water_rates.end(), view(yp_).begin());
    std::copy(rates.begin(), rates.end(), view(yp_).begin() + n_);
    std::copy(state.totals.begin(), state.totals.end(), view(totals_).begin());
    if (ida_ == nullptr) {
      create(state.time);
    } else {
      keep_counters();
      check(IDAReInit(ida_, state.time, y_, yp_), "IDAReInit");
      check(IDAQuadReInit(ida_, totals_), "IDAQuadReInit");
    }
    stuck_ = 0;
    state_time_ = state.time;
  }

  void step(State& state, double stop) override {
    for (;;) {
      check(IDASetStopTime(ida_, stop), "IDASetStopTime");
      double time = state.time;
      const int flag = IDASolve(ida_, stop, &time, y_, yp_, IDA_ONE_STEP);
      if (callback_error_) std::rethrow_exception(std::exchange(callback_error_, nullptr));
      if (flag >= 0 && time > state.time) {
        const double taken = time - state.time;
        accept(state, flag == IDA_TSTOP_RETURN ? stop : time);
        stuck_ = 0;
        if (creeps(taken, stop)) leap(state, stop);
        return;
      }
      // A kink (ponding, saturation) can exhaust the retries of a high-order history; without the history it
      // goes on. Twice from the same state means that it does not.
      if (++stuck_ > 1) {
        leap(state, stop);
        return;
      }
      ++restarts_;
      const int stuck = stuck_;
      start(state);
      stuck_ = stuck;
    }
  }

  std::string name() const override { return "IDA BDF"; }

  void report(std::map<std::string, double>& counters) const override {
    long steps = 0, failed = 0;
    if (ida_ != nullptr) {
      IDAGetNumSteps(ida_, &steps);
      IDAGetNumErrTestFails(ida_, &failed);
    }
    counters["steps"] = static_cast<double>(steps_ + steps);
    counters["rejected steps"] = static_cast<double>(rejected_ + failed + kernel_.failed_solves);
    counters["integrator restarts after a failure"] = static_cast<double>(restarts_);
    counters["steps without error control"] = static_cast<double>(all_leaps_);
  }

 private:
  void create(double time) {
    ida_ = IDACreate(context_);
    // IDA insists on a residual function; with its nonlinear solver replaced, nothing calls it.
    check(IDAInit(
              ida_, [](double, N_Vector, N_Vector, N_Vector, void*) { return -1; }, time, y_, yp_),
          "IDAInit");
    check(IDASetUserData(ida_, this), "IDASetUserData");
    check(IDAWFtolerances(ida_, error_weights), "IDAWFtolerances");
    check(IDASetNonlinearSolver(ida_, newton_), "IDASetNonlinearSolver");
    check(IDASetMaxConvFails(ida_, 20), "IDASetMaxConvFails");
    check(IDASetMaxErrTestFails(ida_, 20), "IDASetMaxErrTestFails");
    check(IDASetErrHandlerFn(
              ida_, [](int, const char*, const char*, char*, void*) {}, nullptr),
          "IDASetErrHandlerFn");
    check(IDAQuadInit(ida_, ledger_rates, totals_), "IDAQuadInit");
    check(IDASetQuadErrCon(ida_, SUNFALSE), "IDASetQuadErrCon");
  }

  // BDF: y' = y'_pred + c_j (y - y_pred), so m W' = R is the stage problem with tau = 1/c_j and
  // target = W_pred - W'_pred / c_j. Exceptions stop here: C code is above.
  static int solve_stage(SUNNonlinearSolver solver, N_Vector, N_Vector correction, N_Vector, double, int,
                         void* ida_mem) {
    Bdf& self = *static_cast<Bdf*>(solver->content);
    try {
      double time = 0, cj = 0;
      N_Vector y_pred = nullptr, yp_pred = nullptr, y = nullptr, yp = nullptr, residual = nullptr;
      void* user = nullptr;
      IDAGetNonlinearSystemData(ida_mem, &time, &y_pred, &yp_pred, &y, &yp, &residual, &cj, &user);
      self.kernel_.set_time(time);
      return self.solve_stage(view(y_pred), view(yp_pred), cj, view(correction));
    } catch (...) {
      self.callback_error_ = std::current_exception();
      return SUN_NLS_EXT_FAIL;
    }
  }

  int solve_stage(std::span<const double> y_pred, std::span<const double> yp_pred, double cj,
                  std::span<double> correction) {
    target_.resize(n_);
    for (int i = 0; i < n_; ++i) target_[i] = y_pred[i] - yp_pred[i] / cj;
    stage_head_.assign(y_pred.begin() + n_, y_pred.end());
    last_try_ = 1 / cj;
    if (!kernel_.solve(target_, 1 / cj, stage_head_)) return SUN_NLS_CONV_RECVR;
    for (int i = 0; i < n_; ++i) {
      correction[i] = kernel_.flow().water()[i] - y_pred[i];
      correction[n_ + i] = stage_head_[i] - y_pred[n_ + i];
    }
    return SUN_NLS_SUCCESS;
  }

  // Just below saturation W is flat (C -> 0 like |psi|^{n-1}), so W to Newton's tolerance says little about psi: on
  // top of the asked tolerance psi is allowed what that leaves open. Without it a tolerance of 1e-8 m cannot pass the
  // instant at which the last node of a column fills, whatever the step: 1e-16 in W is 4e-7 m there.
  static int error_weights(N_Vector y, N_Vector weights, void* user) {
    const Bdf& self = *static_cast<Bdf*>(user);
    const auto value = view(y), weight = view(weights);
    for (int i = 0; i < self.n_; ++i) {
      const double head = value[self.n_ + i];
      const double open = self.kernel_.open_head(i, head);
      const double water = self.tolerances_.relative * std::abs(value[i]) + self.tolerances_.water;
      const double dry = self.kernel_.open_dry_head(i, head, water);
      weight[i] = 1 / water;
      weight[self.n_ + i] =
          1 / (std::max(self.tolerances_.relative * std::abs(head) + self.tolerances_.head, dry) + open);
    }
    return 0;
  }

  // IDAS calls this right after the stage it belongs to (and once at the start), so the kernel still holds it.
  static int ledger_rates(double, N_Vector, N_Vector, N_Vector rates, void* user) {
    const StageKernel& kernel = static_cast<Bdf*>(user)->kernel_;
    N_VConst(0, rates);
    kernel.ledger_rates(view(rates).first(kernel.ledger_size()));
    return 0;
  }

  void accept(State& state, double time) {
    double at = 0;
    check(IDAGetQuad(ida_, &at, totals_), "IDAGetQuad");
    state.time = state_time_ = time;
    const auto y = view(y_);
    state.water.assign(y.begin(), y.begin() + n_);
    state.head.assign(y.begin() + n_, y.end());
    const auto totals = view(totals_);
    std::copy_n(totals.begin(), state.totals.size(), state.totals.begin());
  }

  // Heads of saturated zones without storage may contradict the start, and Newton may go in circles at a kink, so that
  // only steps come through in which nothing happens.
  bool creeps(double taken, double stop) {
    constexpr double crawl = 1e-10;  // of the time ahead
    constexpr int patience = 30;
    creeping_ = taken < crawl * (stop - state_time_) ? creeping_ + 1 : 0;
    if (creeping_ == 0 && taken > 1e-4 * (stop - state_time_)) leaps_ = 0;
    return creeping_ >= patience;
  }

  // One backward Euler step past it: balanced, but its error is not controlled, so it is told in the counters. Longer
  // each time that it did not help.
  void leap(State& state, double stop) {
    constexpr int most = 6;
    creeping_ = 0;
    if (++leaps_ > most) throw StepFailure(describe_failure(kernel_, state.time, last_try_, "the steps only creep"));
    ++all_leaps_;
    const double least = 1e-12 * (stop - state.time);
    bool taken = false;
    for (double step = 1e-9 * std::pow(10, leaps_) * (stop - state.time); step > least && !taken; step *= 0.25) {
      std::vector<double> head = state.head;
      kernel_.set_time(state.time + step);
      last_try_ = step;
      taken = kernel_.solve(state.water, step, head);
      if (!taken) continue;
      std::vector<double> rates(state.totals.size());
      kernel_.ledger_rates(rates);
      for (std::size_t k = 0; k < rates.size(); ++k) state.totals[k] += step * rates[k];
      state.head = std::move(head);
      state.water = kernel_.flow().water();
      state.time += step;
    }
    if (!taken) throw StepFailure(describe_failure(kernel_, state.time, last_try_));
    start(state);
  }

  void keep_counters() {
    long steps = 0, failed = 0;
    IDAGetNumSteps(ida_, &steps);
    IDAGetNumErrTestFails(ida_, &failed);
    steps_ += steps;
    rejected_ += failed;
  }

  StageKernel& kernel_;
  int n_;
  Tolerances tolerances_;
  SUNContext context_ = nullptr;
  void* ida_ = nullptr;
  SUNNonlinearSolver newton_ = nullptr;
  N_Vector y_ = nullptr, yp_ = nullptr, totals_ = nullptr;
  std::vector<double> target_, stage_head_;
  std::exception_ptr callback_error_;
  double last_try_ = 0;
  double state_time_ = 0;
  int stuck_ = 0, creeping_ = 0, leaps_ = 0;
  long steps_ = 0, rejected_ = 0, restarts_ = 0, all_leaps_ = 0;
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_bdf(StageKernel& kernel, Tolerances tolerances) {
  return std::make_unique<Bdf>(kernel, tolerances);
}

}  // namespace wetfront::fem_reference
