// write_only_in FOLDER PROGRAM ARGUMENTS...: the program, which can then make, change and remove files in
// that folder and in /dev alone, and whatever it starts too. Exit code 77 where the system has no such rules
// (Landlock, Linux 5.19).
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

constexpr int no_rules = 77;

constexpr std::uint64_t changes_a_file = LANDLOCK_ACCESS_FS_WRITE_FILE;
constexpr std::uint64_t changes_a_folder = LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
                                           LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                           LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK |
                                           LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
                                           LANDLOCK_ACCESS_FS_MAKE_SYM | LANDLOCK_ACCESS_FS_REFER;

int give_up(const char* what, int code) {
  std::fprintf(stderr, "write_only_in: %s: %s\n", what, std::strerror(errno));
  return code;
}

bool allow(int rules, const char* folder, std::uint64_t access) {
  landlock_path_beneath_attr rule{};
  rule.allowed_access = access;
  rule.parent_fd = ::open(folder, O_PATH | O_CLOEXEC);
  return rule.parent_fd >= 0 &&
         ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) return std::fprintf(stderr, "write_only_in FOLDER PROGRAM ARGUMENTS...\n"), 2;
  landlock_ruleset_attr attributes{};
  attributes.handled_access_fs = changes_a_file | changes_a_folder;
  const int rules = int(::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
  if (rules < 0) return give_up("no Landlock", no_rules);
  if (!allow(rules, words[1], changes_a_file | changes_a_folder)) return give_up(words[1], 1);
  if (!allow(rules, "/dev", changes_a_file)) return give_up("/dev", 1);
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (::syscall(SYS_landlock_restrict_self, rules, 0) != 0) return give_up("no Landlock", no_rules);
  ::execvp(words[2], words + 2);
  return give_up(words[2], 127);
}
