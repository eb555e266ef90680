#include "batch_probe.hpp"

#include <csignal>
#include <cstring>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "batch/memory_gate.hpp"
#include "batch_pair.hpp"

namespace quadmatch::cli {

std::optional<std::string> probe_job(const Job& job, const JobList& list, std::uint64_t memory) {
  const ::pid_t child = ::fork();
  if (child < 0) return std::nullopt;  // no room for a process: done like the others
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it holds the lock of the folder, so it must not outlive us
    MemoryGate gate(memory);
    static_cast<void>(do_job(job, list, gate));
    ::_exit(0);
  }
  int status = 0;
  if (::waitpid(child, &status, 0) != child || !WIFSIGNALED(status)) return std::nullopt;
  const int signal = WTERMSIG(status);
  // Who ends a group of processes may have come to this one only now: then it is not the job's fault.
  ::sleep(1);
  return fmt::format(
      "the program is ended by signal {} ({}) whenever it does this pair; if that is for its memory give less to "
      "--memory, else please report it",
      signal, ::strsignal(signal));
}

}  // namespace quadmatch::cli
