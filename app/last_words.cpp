#include "app/last_words.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

namespace crest {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_sanitizer = true;  // which tells more of a crash
#else
constexpr bool has_sanitizer = false;
#endif

/// A signal's handler knows no object that this could belong to.
volatile std::sig_atomic_t is_told = 0;

bool is_limited(__rlimit_resource resource) {
  rlimit limits{};
  return ::getrlimit(resource, &limits) == 0 && limits.rlim_cur != RLIM_INFINITY;
}

/// All that it calls may be called from a signal's handler.
void tell(std::string_view what, bool may_lack_memory = false) {
  if (is_told) return;
  std::array<char, 512> line{};
  std::size_t length = 0;
  const auto add = [&](std::string_view text) {
    const std::size_t size = std::min(text.size(), line.size() - length);
    std::memcpy(line.data() + length, text.data(), size);
    length += size;
  };
  add("crest: ");
  add(what);
  if (may_lack_memory && is_limited(RLIMIT_AS)) add("; maybe for want of memory: ulimit -v allows more");
  add("\n");
  if (::write(STDERR_FILENO, line.data(), length) < 0) ::_exit(1);
}

std::string_view words_of(int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return "it, or a driver or library that it uses, crashed: a wrong memory access";
    case SIGFPE:
      return "it, or a driver or library that it uses, crashed: a wrong division";
    case SIGILL:
      return "it, or a driver or library that it uses, crashed: an instruction that this processor lacks";
    case SIGXCPU:
      return "it took more processor time than ulimit -t allows";
    default:
      return "a driver or library that it uses gave up";
  }
}

extern "C" void end_crashed(int signal) {
  tell(words_of(signal), signal == SIGSEGV || signal == SIGBUS || signal == SIGABRT);
  if (signal == SIGXCPU || is_limited(RLIMIT_AS)) ::_exit(1);
  ::raise(
      signal);  // when this has returned, as if it had not been here: a debugger, or a core dump, tells more
}

[[noreturn]] void end_with(std::string_view what) {
  tell(what);
  ::_exit(1);
}

/// Of an exception that nobody caught, as in a library's thread.
[[noreturn]] void end_uncaught() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    end_with("out of memory");
  } catch (const std::exception& error) {
    end_with(error.what());
  } catch (...) {
  }
  end_with("a driver or library that it uses gave up");
}

}  // namespace

void end_crashes_silently() { is_told = 1; }

void end_crashes_with_a_line() {
  if (has_sanitizer) return;
  static std::array<std::byte, 1 << 16> own_stack;  // that of the thread may be what ran out
  const stack_t stack{own_stack.data(), 0, own_stack.size()};
  ::sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = end_crashed;
  action.sa_flags = SA_ONSTACK | SA_RESETHAND;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU})
    ::sigaction(signal, &action, nullptr);
  std::set_terminate(end_uncaught);
}

}  // namespace crest
