// SPDX-License-Identifier: MIT
#include "cli/interruption.h"

#include <csignal>

#include "cli/error.h"

namespace arete::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void note_interruption(int) { interrupted = 1; }

}  // namespace

void catch_interruptions() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, note_interruption);
}

bool is_interrupted() { return interrupted != 0; }

void stop_if_interrupted() {
  if (is_interrupted()) throw Interrupted();
}

}  // namespace arete::cli
