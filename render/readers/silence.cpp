#include "render/readers/silence.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace crest {
namespace {

/// stderr is the process's, so there is one turn for all.
std::mutex& turns() {
  static std::mutex mutex;
  return mutex;
}

void flush() {
  std::cerr.flush();
  std::fflush(stderr);
}

}  // namespace

Silence::Silence() : turn_(turns()), kept_(dup(STDERR_FILENO)) {
  flush();
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  if (nowhere >= 0) close(nowhere);
}

Silence::~Silence() {
  flush();
  if (kept_ < 0) return;
  dup2(kept_, STDERR_FILENO);
  close(kept_);
}

}  // namespace crest
