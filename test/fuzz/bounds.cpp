#include "test/fuzz/bounds.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>

namespace shell_origami {
namespace {

constexpr rlim_t kMostMemory = rlim_t{2} << 30;
constexpr time_t kMostTime = 2;  // [s]

volatile std::sig_atomic_t current_input = -1;

void report(int signal) {
  // Nothing but write() is safe here.
  char text[80];
  const char* what = signal == SIGVTALRM ? "takes more than 2 s" : "crashes";
  const int length =
      std::snprintf(text, sizeof text, "input %d %s\n", static_cast<int>(current_input), what);
  if (write(STDOUT_FILENO, text, static_cast<std::size_t>(length)) < 0) _exit(3);
  _exit(1);
}

void setTimer(time_t seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

}  // namespace

void limitProgram() {
#if !defined(__SANITIZE_ADDRESS__)  // whose shadow takes terabytes of addresses
  const rlimit memory{kMostMemory, kMostMemory};
  setrlimit(RLIMIT_AS, &memory);
#endif
  // A stack of its own, for the one that overflowed.
  static char stack[1 << 16];
  stack_t alternate{};
  alternate.ss_sp = stack;
  alternate.ss_size = sizeof stack;
  sigaltstack(&alternate, nullptr);
  struct sigaction action;
  std::memset(&action, 0, sizeof action);
  action.sa_handler = report;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGVTALRM, SIGSEGV, SIGBUS, SIGFPE, SIGABRT}) {
    sigaction(signal, &action, nullptr);
  }
}

InputTimer::InputTimer(int number) {
  current_input = number;
  setTimer(kMostTime);
}

InputTimer::~InputTimer() { setTimer(0); }

}  // namespace shell_origami
