#include "reports/gnuplot.h"

#include "reports/whole_file.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace wetfront::reports {

namespace {

/// What is handed to the child: standard streams away from the terminal, errors into a file.
class SpawnActions {
 public:
  SpawnActions(const std::string& folder, const std::string& errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
  }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

[[noreturn]] void not_started(int error) {
  throw std::runtime_error(std::string("gnuplot: cannot be started (") + std::strerror(error) +
                           "; the report's figures are drawn by it). Install the package gnuplot-nox or put gnuplot "
                           "into PATH; result.json is complete, `wetfront report` renders it then.");
}

}  // namespace

void run_gnuplot(const std::vector<std::filesystem::path>& scripts, const std::filesystem::path& folder) {
  const std::filesystem::path errors = std::filesystem::absolute(folder) / "gnuplot.err";
  std::vector<std::string> words = {"gnuplot"};
  for (const auto& script : scripts) words.push_back(script.string());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  pid_t child = 0;
  const SpawnActions actions(folder.string(), errors.string());
  const int error = ::posix_spawnp(&child, "gnuplot", actions.get(), nullptr, arguments.data(), environ);
  if (error != 0) not_started(error);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) not_started(errno);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) not_started(ENOENT);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error("gnuplot: failed on the report's figures. It said:\n" + read_whole(errors));
}

}  // namespace wetfront::reports
