/// \file
/// Bounds of time and memory within which random inputs are read.
#pragma once

#include <string>

namespace shell_origami {

/// Limits the memory of the program from now on, and reports in which input it crashes.
void limitProgram();

/// The input that is being read, which may take two seconds of processor time: a longer one ends
/// the program with a message that names it.
class InputTimer {
 public:
  explicit InputTimer(int number);
  ~InputTimer();
  InputTimer(const InputTimer&) = delete;
  InputTimer& operator=(const InputTimer&) = delete;
};

}  // namespace shell_origami
