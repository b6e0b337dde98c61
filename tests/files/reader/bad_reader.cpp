// A reader that fails, as its query says: bad_reader FORM MEMORY asks|decides PATH do=WHAT. It answers for a
// volume of 2x2x2.

#include <fcntl.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "render/reader/confine.h"
#include "render/reader/limits.h"

namespace {

std::string volume(const std::string& dims = "[2,2,2]", const std::string& values = "8",
                   const std::string& spacing = "[1,1,1]") {
  return R"({"volume":{"dims":)" + dims + R"(,"spacing":)" + spacing +
         R"(,"origin":[0,0,0],"type":0,"in_patient":false,"note":"","direction":[[1,0,0],[0,1,0],[0,0,1]]},"values":)" +
         values + "}\n";
}

std::string with_note(const std::string& note) {
  std::string text = volume();
  return text.insert(text.find(R"("note":")") + 8, note);
}

/// With values that stay as they are stored.
std::string with_stored(const std::string& stored) {
  std::string text = volume();
  return text.insert(text.rfind('}'), R"(,"stored":)" + stored);
}

std::string with_part(const std::string& full, const std::string& stride) {
  std::string text = volume();
  return text.insert(text.find(R"(,"type")"), R"(,"part":{"full":)" + full + R"(,"first":[0,0,0],"end":)" +
                                                  full + R"(,"stride":)" + stride + "}");
}

std::string with_frame(const std::string& frame) {
  std::string text = volume();
  return text.insert(text.find(R"("note":)"), R"("frame":)" + frame + ",");
}

/// Never silent, and never done.
[[noreturn]] void drip() {
  while (true) {
    std::cout << 'x' << std::flush;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}
/// How much it has read, each share on a line.
std::string told(const std::vector<std::string>& shares) {
  std::string text;
  for (const std::string& share : shares) text += R"({"read":)" + share + "}\n";
  return text;
}
[[noreturn]] void repeat() {
  while (true) {
    std::cout << R"({"expects":1000,"seconds":1000})" << std::endl;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

/// Takes more and more memory, all of it used.
[[noreturn]] void allocate() {
  std::vector<std::vector<char>> taken;
  while (true) taken.emplace_back(std::size_t(16) << 20, 'x');
}

/// What it can do to other processes, here the one that started it, and to what others share.
void try_others(const std::string& path, std::string& open_doors) {
  const pid_t parent = ::getppid();
  cpu_set_t cpus;
  rlimit limits;
  if (::getsid(0) != ::getpid()) open_doors += " session";
  if (::syscall(SYS_tgkill, parent, parent, 0) == 0) open_doors += " signals";
  if (::setpriority(PRIO_PROCESS, id_t(parent), ::getpriority(PRIO_PROCESS, id_t(parent))) == 0)
    open_doors += " priority";
  if (::prlimit(parent, RLIMIT_CORE, nullptr, &limits) == 0) open_doors += " limits";
  if (::getrlimit(RLIMIT_CORE, &limits) != 0) open_doors += " no limits of its own";
  if (::sched_getaffinity(parent, sizeof cpus, &cpus) == 0 &&
      ::sched_setaffinity(parent, sizeof cpus, &cpus) == 0)
    open_doors += " affinity";
  if (::ioctl(STDIN_FILENO, TIOCSTI, "x") == 0 || errno != EPERM) open_doors += " typing";
  if (::ioctl(STDIN_FILENO, FIONREAD, &limits) != 0 && errno == EPERM) open_doors += " no ioctl";
  if (::removexattr(path.c_str(), "user.none") == 0 || errno != EPERM) open_doors += " attributes";
  if (::shmat(-1, nullptr, 0) != nullptr && errno != EPERM) open_doors += " shared memory";
  if (::syscall(SYS_mq_open, "crest", O_RDONLY, 0, nullptr) >= 0 || errno != EPERM) open_doors += " queues";
}

/// What the system still does for it, as an error for the test to read.
void try_doors(const std::string& path) {
  std::string open_doors;
  if (::open(path.c_str(), O_RDONLY) < 0) open_doors += " no reading";
  if (::open((path + ".new").c_str(), O_WRONLY | O_CREAT, 0600) >= 0) open_doors += " creating";
  if (::open(path.c_str(), O_RDWR) >= 0) open_doors += " writing";
  if (::unlink(path.c_str()) == 0) open_doors += " removing";
  if (::socket(AF_INET, SOCK_STREAM, 0) >= 0) open_doors += " network";
  if (::fork() >= 0) open_doors += " fork";
  try_others(path, open_doors);
  ::execl("/bin/true", "true", nullptr);
  std::cout << R"({"error":"doors:)" << open_doors << "\"}\n" << std::flush;
}

}  // namespace

#ifdef __SANITIZE_ADDRESS__
// It would look for leaks at the end from a process of its own, which a confined reader may not start.
extern "C" __attribute__((visibility("default"))) const char* __asan_default_options() {
  return "detect_leaks=0";
}
#endif

int main(int argc, char** argv) {
  if (argc < 6) return 2;
  const std::string path = argv[4], what = std::string(argv[5]).substr(3);
  crest::confine();
  crest::Limits().allow(1000);
  const std::string voxels(8 * sizeof(float), '\0');
  if (what == "well") std::cout << volume() << voxels;
  if (what == "told") std::cout << told({"0", "0.25", "0.5", "0.125", "1"}) << volume() << voxels;
  if (what == "told beyond") std::cout << told({"0.5", "1.5"}) << volume() << voxels;
  if (what == "told below") std::cout << told({"-0.5"}) << volume() << voxels;
  if (what == "told a word") std::cout << told({R"("0.5")"}) << volume() << voxels;
  if (what == "told nothing") std::cout << told({"null"}) << volume() << voxels;
  if (what == "told too often")
    std::cout << told(std::vector<std::string>(2000, "0.5")) << volume() << voxels;
  if (what == "abort") std::abort();
  if (what == "crash") std::raise(SIGSEGV);
  if (what == "loop") {
    std::cout << R"({"expects":1000,"seconds":1})" << std::endl;
    for (volatile bool more = true; more;) continue;
  }
  if (what == "sleep") ::pause();
  if (what == "stop") {
    std::cout << R"({"expects":1e9,"seconds":1000})" << std::endl;
    std::raise(SIGSTOP);
  }
  if (what == "allocate") allocate();
  if (what == "leave") return 7;
  if (what == "short") std::cout << volume() << voxels.substr(1);
  if (what == "unfinished") std::cout << volume().substr(0, 20);
  if (what == "garbage")
    std::cout << "\x7f"
              << "ELF garbage\n";
  if (what == "deep") std::cout << R"({"volume":)" << std::string(1 << 20, '[') << "\n";
  if (what == "endless") {
    while (std::cout << std::string(1 << 16, 'x')) continue;
  }
  if (what == "huge") std::cout << volume("[100000,100000,100000]", "1000000000000000");
  if (what == "count") std::cout << volume("[2,2,2]", "9") << voxels << "more";
  if (what == "negative") std::cout << volume("[2,2,2]", "-8") << voxels;
  if (what == "flat") std::cout << volume("[2,2,1]", "4") << voxels;
  if (what == "spacing") std::cout << volume("[2,2,2]", "8", "[1,0,1]") << voxels;
  if (what == "other")
    std::cout << R"({"volume":7,"values":8})"
              << "\n";
  if (what == "stored") std::cout << with_stored(R"({"type":0,"slope":2,"intercept":-1})") << "abcdefgh";
  if (what == "half stored") std::cout << with_stored(R"({"type":2,"slope":1,"intercept":0})") << "abcdefgh";
  if (what == "doubles")
    std::cout << with_stored(R"({"type":9,"slope":1,"intercept":0})") << voxels << voxels;
  if (what == "no slope") std::cout << with_stored(R"({"type":0,"slope":null,"intercept":0})") << "abcdefgh";
  if (what == "part") std::cout << with_part("[4,4,4]", "[2,2,2]") << voxels;
  if (what == "other part") std::cout << with_part("[6,4,4]", "[2,2,2]") << voxels;
  if (what == "no stride") std::cout << with_part("[4,4,4]", "[2,0,2]") << voxels;
  if (what == "control")
    std::cout << R"({"error":"a\u001b[31m\nb"})"
              << "\n";
  if (what == "doors") try_doors(path);
  if (what == "drip") drip();
  if (what == "repeat") repeat();
  if (what == "wide") std::cout << volume("[4294967298,2,2]", "8") << voxels;
  if (what == "frame") std::cout << with_frame("[3,3]") << voxels;
  if (what == "frames") std::cout << with_frame("[0,4294967298]") << voxels;
  if (what == "note") std::cout << with_note("a\\u001b[31m" + std::string(100000, 'x')) << voxels;
  if (what == "choice" || what == "raw")
    std::cout << R"({"error":"choose","choice":{"kind":)" << (what == "raw" ? 0 : 2)
              << R"(,"path":"/elsewhere","query":{"a":"b"},"count":1,"options":[["0","a\u001b[31mb"]]}})"
              << "\n";
  std::cout.flush();
  return 0;
}
