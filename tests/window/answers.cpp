// answers WINDOW PROCESS SECONDS: asks a window again and again whether it is alive, as a window manager does
// (_NET_WM_PING), until its process ends: exit code 0. Where it once takes longer than that to answer: exit
// code 1.
//
// Counted is the time in which the process could have answered: that for which its main thread, and the
// threads of the software renderer that it waits for, were ready to run and got no processor is left out,
// since it says nothing of the program. Each time that is the longest so far is a line.
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// For how long each thread was ready to run without running, since it began, in seconds.
using Waits = std::map<std::string, double>;

double waited_s(const fs::path& thread) {
  double ran_ns = 0, waited_ns = 0;
  std::ifstream(thread / "schedstat") >> ran_ns >> waited_ns;
  return waited_ns * 1e-9;
}

/// Of the main thread and the renderer's.
Waits waits_of(pid_t process) {
  const fs::path threads = fs::path("/proc") / std::to_string(process) / "task";
  Waits waits;
  std::error_code gone;
  for (fs::directory_iterator thread(threads, gone), end; !gone && thread != end; thread.increment(gone)) {
    const std::string id = thread->path().filename();
    std::string name;
    std::ifstream(thread->path() / "comm") >> name;
    if (name.starts_with("llvmpipe") || id == std::to_string(process)) waits[id] = waited_s(thread->path());
  }
  return waits;
}

/// Between two looks: the main thread's, and that of the renderer's thread that waited most, since they work
/// side by side.
double waited_between_s(const Waits& before, const Waits& after, pid_t process) {
  double main = 0, renderer = 0;
  for (const auto& [id, waited] : after) {
    const auto earlier = before.find(id);
    const double s = earlier == before.end() ? waited : waited - earlier->second;
    double& longest = id == std::to_string(process) ? main : renderer;
    longest = std::max(longest, s);
  }
  return main + renderer;
}

struct Asked {
  Display* display;
  Window window;
  Atom protocols, ping;
};

void ask(const Asked& asked, long number) {
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = asked.window;
  event.xclient.message_type = asked.protocols;
  event.xclient.format = 32;
  event.xclient.data.l[0] = long(asked.ping);
  event.xclient.data.l[1] = number;
  event.xclient.data.l[2] = long(asked.window);
  XSendEvent(asked.display, asked.window, False, NoEventMask, &event);
  XFlush(asked.display);
}

bool has_answered(const Asked& asked, long number) {
  bool answered = false;
  while (XPending(asked.display) > 0) {
    XEvent event;
    XNextEvent(asked.display, &event);
    answered |= event.type == ClientMessage && event.xclient.message_type == asked.protocols &&
                Atom(event.xclient.data.l[0]) == asked.ping && event.xclient.data.l[1] == number;
  }
  return answered;
}

/// What has ended has no program any more, also where nobody has taken notice yet.
bool is_there(pid_t process) {
  std::error_code gone;
  return !fs::read_symlink(fs::path("/proc") / std::to_string(process) / "exe", gone).empty();
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return std::fprintf(stderr, "answers WINDOW PROCESS SECONDS\n"), 2;
  Display* const display = XOpenDisplay(nullptr);
  if (!display) return std::fprintf(stderr, "answers: no display\n"), 2;
  XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });  // the window is gone: its process will be
  const Asked asked{display, std::strtoul(words[1], nullptr, 10), XInternAtom(display, "WM_PROTOCOLS", False),
                    XInternAtom(display, "_NET_WM_PING", False)};
  const pid_t process = pid_t(std::atol(words[2]));
  const double limit = std::atof(words[3]);
  XSelectInput(display, DefaultRootWindow(display), SubstructureNotifyMask);

  double longest = 0;
  for (long number = 1; is_there(process); ++number) {
    const auto begin = Clock::now();
    const Waits before = waits_of(process);
    ask(asked, number);
    while (true) {
      const bool answered = has_answered(asked, number);
      const double passed = Seconds(Clock::now() - begin).count();
      const double waited = waited_between_s(before, waits_of(process), process);
      if (!is_there(process)) return 0;
      if (const double own = passed - waited; answered ? own > longest : own > limit) {
        longest = own;
        std::printf("%.2f s without an answer, and %.2f s without a processor\n", own, waited);
        std::fflush(stdout);
      }
      if (longest > limit) return 1;
      if (answered) break;
      std::this_thread::sleep_for(Seconds(0.01));
    }
    std::this_thread::sleep_for(Seconds(0.1));
  }
  return 0;
}
