#include "mpm/plan/team.h"

namespace wetfront::mpm {

namespace {

// About 20 us: the serial pieces between two loops of a step of some 1e5 points.
constexpr int spins = 20000;

}  // namespace

Team::Team(int threads) {
  for (int k = 1; k < threads; ++k) workers_.emplace_back([this] { wait_for_loops(); });
}

Team::~Team() {
  over_ = true;
  ++loops_;
  loops_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void Team::share(const Loop& loop) {
  loop_ = loop;
  next_ = 0;
  busy_ = static_cast<int>(workers_.size());
  ++loops_;
  loops_.notify_all();
  work();
  while (busy_.load(std::memory_order_acquire) > 0) std::this_thread::yield();
}

void Team::work() {
  for (std::size_t k = next_++; k < loop_.count; k = next_++) loop_.call(loop_.body, k);
}

void Team::wait_for_loops() {
  for (unsigned seen = 0;;) {
    for (int spin = 0; spin < spins && loops_.load(std::memory_order_acquire) == seen; ++spin) {
    }
    loops_.wait(seen, std::memory_order_acquire);
    ++seen;
    if (over_) return;
    work();
    busy_.fetch_sub(1, std::memory_order_release);
  }
}

}  // namespace wetfront::mpm
