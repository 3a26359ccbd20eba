#include "fem_reference/time/integrator.h"
#include "fem_reference/time/sundials.h"

#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <span>
#include <utility>

namespace wetfront::fem_reference {
namespace {

/// Diagonally implicit Runge-Kutta of SUNDIALS ARKStep (SDIRK_5_3_4: order 4, embedded 3, L-stable, stiffly accurate)
/// on y = (W, ledger), the stage kernel being its nonlinear solver. psi is not part of y: the kernel finds it with each
/// stage, and as the last stage is the step, so do saturated zones without storage, where W says nothing about psi. The
/// ledger takes the same weights as W, so stored - inflow + outflow is conserved to the Newton tolerance.
class Dirk : public TimeIntegrator {
 public:
  Dirk(StageKernel& kernel, Tolerances tolerances)
      : kernel_(kernel), n_(kernel.flow().space().dof_count), tolerances_(tolerances) {
    if (kernel.flow().space().ranks.count() > 1) {
      throw std::invalid_argument("integrator: DIRK runs on one rank only (BDF on any number)");
    }
    check(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
    y_ = N_VNew_Serial(static_cast<sunindextype>(n_ + kernel.ledger_size()), context_);
    rate_.resize(n_ + kernel.ledger_size());
    newton_ = make_stage_solver(this, solve_stage, context_);
  }

  ~Dirk() override {
    ARKStepFree(&ark_);
    SUNNonlinSolFreeEmpty(newton_);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }
  Dirk(const Dirk&) = delete;
  Dirk& operator=(const Dirk&) = delete;

  void start(const State& state) override {
    kernel_.set_time(state.time);
    const std::vector<double> water_rates = kernel_.rates(state.head);
    std::copy(water_rates.begin(), water_rates.end(), rate_.begin());
    kernel_.ledger_rates(std::span(rate_).subspan(n_));
    std::copy(state.water.begin(), state.water.end(), view(y_).begin());
    std::copy(state.totals.begin(), state.totals.end(), view(y_).begin() + n_);
    head_ = stage_head_ = state.head;
    if (ark_ == nullptr) {
      create(state.time);
    } else {
      keep_counters();
      check(ARKStepReInit(ark_, nullptr, right_side, state.time, y_), "ARKStepReInit");
    }
    check(ARKStepSetInitStep(ark_, first_step(state)), "ARKStepSetInitStep");
    stuck_ = 0;
  }

  void step(State& state, double stop) override {
    for (;;) {
      check(ARKStepSetStopTime(ark_, stop), "ARKStepSetStopTime");
      double time = state.time;
      const int flag = ARKStepEvolve(ark_, stop, y_, &time, ARK_ONE_STEP);
      if (callback_error_) std::rethrow_exception(std::exchange(callback_error_, nullptr));
      if (flag >= 0 && time > state.time) {
        accept(state, flag == ARK_TSTOP_RETURN ? stop : time);
        stuck_ = 0;
        return;
      }
      if (++stuck_ > 1) throw StepFailure(describe_failure(kernel_, state.time, last_try_));
      ++restarts_;
      const int stuck = stuck_;
      start(state);
      stuck_ = stuck;
    }
  }

  std::string name() const override { return "ARKStep SDIRK(5,3,4)"; }

  void report(std::map<std::string, double>& counters) const override {
    long steps = 0, failed = 0;
    if (ark_ != nullptr) {
      ARKStepGetNumSteps(ark_, &steps);
      ARKStepGetNumErrTestFails(ark_, &failed);
    }
    counters["steps"] = static_cast<double>(steps_ + steps);
    counters["rejected steps"] = static_cast<double>(rejected_ + failed + kernel_.failed_solves);
    counters["integrator restarts after a failure"] = static_cast<double>(restarts_);
  }

 private:
  void create(double time) {
    ark_ = ARKStepCreate(nullptr, right_side, time, y_, context_);
    check(ARKStepSetUserData(ark_, this), "ARKStepSetUserData");
    check(ARKStepWFtolerances(ark_, error_weights), "ARKStepWFtolerances");
    check(ARKStepSetTableNum(ark_, ARKODE_SDIRK_5_3_4, ARKODE_ERK_NONE), "ARKStepSetTableNum");
    check(ARKStepSetNonlinearSolver(ark_, newton_), "ARKStepSetNonlinearSolver");
    check(ARKStepSetDeduceImplicitRhs(ark_, SUNTRUE), "ARKStepSetDeduceImplicitRhs");
    // Dense output would ask for the right side at the end of every step; nothing needs it.
    check(ARKStepSetInterpolantType(ark_, ARK_INTERP_LAGRANGE), "ARKStepSetInterpolantType");
    check(ARKStepSetPredictorMethod(ark_, 0), "ARKStepSetPredictorMethod");
    check(ARKStepSetMaxConvFails(ark_, 20), "ARKStepSetMaxConvFails");
    check(ARKStepSetMaxErrTestFails(ark_, 20), "ARKStepSetMaxErrTestFails");
    check(ARKStepSetErrHandlerFn(
              ark_, [](int, const char*, const char*, char*, void*) {}, nullptr),
          "ARKStepSetErrHandlerFn");
  }

  // The first step changes no W by more than its tolerance.
  double first_step(const State& state) const {
    double fastest = 0;
    for (int i = 0; i < n_; ++i) {
      fastest =
          std::max(fastest, std::abs(rate_[i]) / (tolerances_.relative * std::abs(state.water[i]) + tolerances_.water));
    }
    return 1 / std::max(fastest, 1e-300);
  }

  // Stage i: W = predicted + correction with W - gamma F(W) = predicted + data: the stage problem with tau = gamma.
  static int solve_stage(SUNNonlinearSolver solver, N_Vector, N_Vector correction, N_Vector, double, int,
                         void* memory) {
    Dirk& self = *static_cast<Dirk*>(solver->content);
    try {
      double time = 0, gamma = 0;
      N_Vector predicted = nullptr, z = nullptr, rate = nullptr, data = nullptr;
      void* user = nullptr;
      ARKStepGetNonlinearSystemData(memory, &time, &predicted, &z, &rate, &gamma, &data, &user);
      self.kernel_.set_time(time);
      return self.solve_stage(view(predicted), view(data), gamma, view(correction));
    } catch (...) {
      self.callback_error_ = std::current_exception();
      return SUN_NLS_EXT_FAIL;
    }
  }

  int solve_stage(std::span<const double> predicted, std::span<const double> data, double gamma,
                  std::span<double> correction) {
    target_.resize(n_);
    for (int i = 0; i < n_; ++i) target_[i] = predicted[i] + data[i];
    last_try_ = gamma;
    if (!kernel_.solve(target_, gamma, stage_head_)) {
      stage_head_ = head_;
      return SUN_NLS_CONV_RECVR;
    }
    for (int i = 0; i < n_; ++i) correction[i] = kernel_.flow().water()[i] - predicted[i];
    ledger_.resize(predicted.size() - n_);
    kernel_.ledger_rates(ledger_);
    for (std::size_t k = 0; k < ledger_.size(); ++k) correction[n_ + k] = data[n_ + k] + gamma * ledger_[k];
    return SUN_NLS_SUCCESS;
  }

  // Called once at the start, for which start() has it; the stages deduce theirs from the kernel's solution.
  static int right_side(double, N_Vector, N_Vector rate, void* user) {
    const Dirk& self = *static_cast<Dirk*>(user);
    std::copy(self.rate_.begin(), self.rate_.end(), view(rate).begin());
    return 0;
  }

  static int error_weights(N_Vector y, N_Vector weights, void* user) {
    const Dirk& self = *static_cast<Dirk*>(user);
    constexpr double none = 1e-20;  // the ledger goes with W
    const auto value = view(y), weight = view(weights);
    std::fill(weight.begin(), weight.end(), none);
    for (int i = 0; i < self.n_; ++i) {
      weight[i] = 1 / (self.tolerances_.relative * std::abs(value[i]) + self.tolerances_.water);
    }
    return 0;
  }

  void accept(State& state, double time) {
    state.time = time;
    state.head = head_ = stage_head_;
    const auto y = view(y_);
    state.water.assign(y.begin(), y.begin() + n_);
    state.totals.assign(y.begin() + n_, y.end());
  }

  void keep_counters() {
    long steps = 0, failed = 0;
    ARKStepGetNumSteps(ark_, &steps);
    ARKStepGetNumErrTestFails(ark_, &failed);
    steps_ += steps;
    rejected_ += failed;
  }

  StageKernel& kernel_;
  int n_;
  Tolerances tolerances_;
  SUNContext context_ = nullptr;
  void* ark_ = nullptr;
  SUNNonlinearSolver newton_ = nullptr;
  N_Vector y_ = nullptr;
  std::vector<double> rate_, target_, ledger_, head_, stage_head_;
  std::exception_ptr callback_error_;
  double last_try_ = 0;
  int stuck_ = 0;
  long steps_ = 0, rejected_ = 0, restarts_ = 0;
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_dirk(StageKernel& kernel, Tolerances tolerances) {
  return std::make_unique<Dirk>(kernel, tolerances);
}

}  // namespace wetfront::fem_reference
