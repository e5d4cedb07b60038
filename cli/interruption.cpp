// SPDX-License-Identifier: MIT
#include "cli/interruption.h"

#include <unistd.h>

#include <csignal>

#include "cli/error.h"
#include "cli/output_file.h"

namespace arete::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void note_interruption(int signal) {
  if (interrupted != 0) {
    remove_unfinished_outputs();
    _exit(128 + signal);
  }
  interrupted = 1;
}

// Libraries abort where they have no memory to say more.
void end_in_order(int) {
  remove_unfinished_outputs();
  constexpr char words[] =
      "arete: a library ended the program, what it said stands above; no output was written\n";
  [[maybe_unused]] const auto told = write(STDERR_FILENO, words, sizeof words - 1);
  _exit(1);
}

}  // namespace

void catch_interruptions() {
  std::signal(SIGABRT, end_in_order);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, note_interruption);
}

bool is_interrupted() { return interrupted != 0; }

void stop_if_interrupted() {
  if (is_interrupted()) throw Interrupted();
}

}  // namespace arete::cli
