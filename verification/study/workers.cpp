#include "verification/study/workers.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <map>
#include <stdexcept>

namespace wetfront::verification {
namespace {

pid_t start(const Work& work) {
  std::vector<char*> arguments;
  for (const std::string& word : work.command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  std::filesystem::create_directories(work.log.parent_path());
  const int log = open(work.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (log < 0) throw std::runtime_error(work.log.string() + ": cannot write");
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw std::runtime_error("cannot start another process");
  if (child > 0) {
    close(log);
    return child;
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it had ended before that
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execv(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

void run_side_by_side(const std::vector<Work>& work, int jobs, const std::function<void(std::size_t, int)>& done) {
  std::map<pid_t, std::size_t> running;
  std::size_t next = 0;
  while (next < work.size() || !running.empty()) {
    while (next < work.size() && running.size() < static_cast<std::size_t>(jobs)) {
      const pid_t child = start(work[next]);
      running[child] = next++;
    }
    int status = 0;
    const pid_t ended = waitpid(-1, &status, 0);
    if (ended < 0 && errno != EINTR)
      throw std::runtime_error(std::string("the processes of the points cannot be waited for: ") +
                               std::strerror(errno));
    const auto found = running.find(ended);
    if (found == running.end()) continue;
    const std::size_t index = found->second;
    running.erase(found);
    done(index, status);
  }
}

int processors() {
  cpu_set_t set;
  return sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

std::filesystem::path this_program() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

}  // namespace wetfront::verification
