// SPDX-License-Identifier: MIT
#pragma once

#ifdef ARETE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace arete {

#ifdef ARETE_THREAD_SANITIZER

// Tells ThreadSanitizer that branches begin after a fork is made, and have ended when it is gone.
// oneTBB sees to it that they do, but as it is shipped it is not built to say so.
class Fork {
 public:
  Fork() { __tsan_release(&begun_); }
  ~Fork() { __tsan_acquire(&ended_); }
  Fork(const Fork&) = delete;
  Fork& operator=(const Fork&) = delete;

  class Branch {
   public:
    explicit Branch(Fork& fork) : fork_(fork) { __tsan_acquire(&fork_.begun_); }
    ~Branch() { __tsan_release(&fork_.ended_); }
    Branch(const Branch&) = delete;
    Branch& operator=(const Branch&) = delete;

   private:
    Fork& fork_;
  };

 private:
  char begun_ = 0;
  char ended_ = 0;
};

#else

struct Fork {
  Fork() {}
  struct Branch {
    explicit Branch(Fork&) {}
  };
};

#endif

}  // namespace arete
