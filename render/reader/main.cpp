// crest-reader FORM MEMORY asks|decides PATH [KEY=VALUE ...]: reads one file for Crest and answers on its
// standard output (files/reader_answer.h). What the libraries do that it loads stays within its limits.

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <span>
#include <string_view>

#include "presets/error.h"
#include "presets/printable.h"
#include "render/files/file_modules.h"
#include "render/files/geometry.h"
#include "render/files/kinds.h"
#include "render/files/reader_answer.h"
#include "render/reader/confine.h"
#include "render/reader/limits.h"
#include "render/readers/readers.h"

namespace crest {
namespace {

/// The answer's pipe; what libraries print goes nowhere.
class Answer {
 public:
  Answer() : file_(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)) {
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
  }

  void line(const Json& json) const {
    write_all(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  }

  /// Lets go of the memory of what is sent: the other side gathers it meanwhile.
  void values(std::span<const std::byte> bytes) const {
    constexpr std::size_t block = std::size_t(4) << 20;
    for (std::span<const std::byte> rest = bytes; !rest.empty();) {
      const auto part = rest.first(std::min(block, rest.size()));
      write_all({reinterpret_cast<const char*>(part.data()), part.size()});
      rest = rest.subspan(part.size());
      let_go(part);
    }
  }

 private:
  void write_all(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(file_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) ::_exit(1);  // nobody reads it
      bytes.remove_prefix(std::size_t(written));
    }
  }

  /// Of the whole pages in it.
  static void let_go(std::span<const std::byte> part) {
    const auto page = std::uintptr_t(::sysconf(_SC_PAGESIZE));
    const auto begin = (reinterpret_cast<std::uintptr_t>(part.data()) + page - 1) & ~(page - 1);
    const auto end = reinterpret_cast<std::uintptr_t>(part.data() + part.size()) & ~(page - 1);
    if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
  }

  int file_;
};

/// Tells how much is read: at most ten times a second, and a hundred times in all.
TellShare tell_by(const Answer& answer) {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds between{100};
  static constexpr double step = 0.01;
  return [&answer, next = Clock::now() + between, least = step](double share) mutable {
    const Clock::time_point now = Clock::now();
    if (now < next || share < least) return;
    next = now + between;
    least = share + step;
    answer.line({{"read", share}});
  };
}

struct Task {
  FileForm form;
  FileRequest request;
};

Task task_of(std::span<char*> words) {
  if (words.size() < 5) throw Error("crest-reader FORM MEMORY asks|decides PATH [KEY=VALUE ...]");
  const std::string_view form = words[1], memory = words[2];
  const auto known = std::ranges::find(file_form_names, form);
  if (known == file_form_names.end()) throw Error(fmt::format("\"{}\" is no form of files", form));
  Task task{FileForm(known - file_form_names.begin()), {words[4]}};
  std::from_chars(memory.data(), memory.data() + memory.size(), task.request.reading.memory);
  task.request.reading.asks = words[3] == std::string_view("asks");
  for (const std::string_view pair : words.subspan(5)) {
    const std::size_t equals = pair.find('=');
    if (equals != pair.npos) task.request.query.emplace(pair.substr(0, equals), pair.substr(equals + 1));
  }
  return task;
}

bool is_dicom_form(FileForm form) { return form == FileForm::dicom_file || form == FileForm::dicom_series; }
bool is_page_form(FileForm form) { return form == FileForm::image_pages || form == FileForm::image_folder; }

/// Whether OpenImageIO reads the file, or one of the folder's.
bool needs_openimageio(const Task& task) {
  if (task.form > FileForm::image_folder) return true;
  if (task.form == FileForm::image_pages) return !is_plain_image(task.request.path);
  if (task.form != FileForm::image_folder) return false;
  const std::filesystem::directory_iterator entries(task.request.path);
  return std::any_of(begin(entries), end(entries), [](const auto& entry) {
    return is_image(entry.path()) && !is_plain_image(entry.path());
  });
}

void answer_volume(const Answer& answer, Volume volume) {
  repair_geometry(volume);
  volume.note = printable(volume.note);
  const Voxels& values = volume.values;
  answer.line(
      {{"volume", volume_to_json(volume)}, {"values", values.size()}, {"stored", stored_to_json(values)}});
  answer.values({static_cast<const std::byte*>(values.data()), values.byte_count()});
}

void answer_task(const Answer& answer, const Task& task) {
  const auto& path = task.request.path;
  if (task.form == FileForm::picture) {
    const Image image = image_module().read_image(path);
    answer.line({{"picture", {image.size.x, image.size.y}}, {"values", image.pixels.size() * 4}});
    answer.values(std::as_bytes(std::span(image.pixels)));
  } else if (task.form == FileForm::picture_preset) {
    answer.line({{"preset", image_module().preset_in_picture(path)}});
  } else if (is_page_form(task.form)) {
    answer_volume(answer, page_module().read(task.form, task.request));
  } else if (is_dicom_form(task.form)) {
    answer_volume(answer, dicom_module().read(task.form, task.request));
  } else {
    answer_volume(answer, read_voxel_file(task.form, task.request));
  }
}

void run(const Answer& answer, std::span<char*> words) {
  Task task = task_of(words);
  // With the libraries in memory, what they take from here on is the file's.
  if (is_page_form(task.form)) page_module();
  if (needs_openimageio(task)) image_module();
  if (is_dicom_form(task.form)) dicom_module();
  const Limits limits;
  const auto expect = [&](std::uint64_t bytes) {
    answer.line({{"expects", bytes}, {"seconds", limits.allow(bytes)}});
  };
  const std::uint64_t held = bytes_held(task.request.path);
  expect(held);
  task.request.expect = [&](std::uint64_t bytes) { expect(held + bytes); };
  task.request.reading.progress = tell_by(answer);
  try {
    answer_task(answer, task);
  } catch (const TooLarge& fault) {
    throw part_needed(fault, task.request.name(), task.request.query);
  }
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::confine();
  const crest::Answer answer;
  try {
    crest::run(answer, {argv, std::size_t(argc)});
  } catch (const std::bad_alloc&) {
    answer.line(
        {{"error", std::string(argc > 4 ? argv[4] : "") + ": reading it takes more memory than there is"}});
  } catch (const crest::ChoiceNeeded& needed) {
    answer.line({{"error", needed.what()}, {"choice", crest::choice_to_json(needed.choice)}});
  } catch (const std::filesystem::filesystem_error& fault) {
    answer.line({{"error", fault.path1().string() + ": " + fault.code().message()}});
  } catch (const std::exception& fault) {
    answer.line({{"error", crest::printable(fault.what())}});  // JSON holds no other bytes
  }
  ::_exit(0);  // what the libraries would do at the end is not worth a wait, or a crash
}
