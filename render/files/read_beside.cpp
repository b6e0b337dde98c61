#include "render/files/read_beside.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <stop_token>
#include <vector>

#include "presets/error.h"
#include "presets/printable.h"
#include "render/files/reader_answer.h"
#include "render/files/reader_process.h"
#include "render/volume/voxel_store.h"

namespace crest {
namespace {

using Clock = std::chrono::steady_clock;

/// The library that reads such a file, where it is none of ours; or nothing.
std::string_view library_of(FileForm form) {
  if (form == FileForm::dicom_file || form == FileForm::dicom_series) return "GDCM";
  return form >= FileForm::picture ? "OpenImageIO" : "";
}

/// A reader at work, and what it has told.
class Reader {
 public:
  Reader(FileForm form, const FileRequest& request)
      : request_(request),
        library_(library_of(form)),
        process_(request.reading.reader, words(form, request)) {}

  /// The last line, which holds `key`; after it come the values. Throws Error.
  Json head(std::string_view key) {
    while (true) {
      const Json line = parse(next_line());
      if (line.contains("error")) fail_as_told(line);
      if (line.contains(key)) return line;
      if (line.contains("read"))
        take_share(line.at("read"));
      else if (line.contains("expects"))
        expect(line);
      else
        fail_unclear();
    }
  }

  /// Fills `values` with those behind the head, which tells how many there are; there is memory for them.
  template <class T>
  void read_values(const Json& head, std::vector<T>& values) {
    const auto told = head.find("values");
    if (told == head.end() || !told->is_number_unsigned()) fail_unclear();
    const auto count = told->get<std::size_t>();
    if (count > request_.reading.memory / sizeof(T)) fail_unclear();
    values.reserve(count);  // it is filled block by block: a reader lets go of what it has sent
    std::vector<T> block(std::min(count, (std::size_t(1) << 18) / sizeof(T)));
    while (values.size() < count) {
      const std::size_t size = std::min(block.size(), count - values.size());
      take(reinterpret_cast<char*>(block.data()), size * sizeof(T));
      values.insert(values.end(), block.begin(), block.begin() + std::ptrdiff_t(size));
      tell(request_.reading.progress, until_sent + (1 - until_sent) * double(values.size()) / double(count));
    }
  }

  [[noreturn]] void fail_unclear() { fail("its answer makes no sense"); }

 private:
  static std::vector<std::string> words(FileForm form, const FileRequest& request) {
    std::vector<std::string> words{std::string(file_form_names[std::size_t(form)]),
                                   std::to_string(request.reading.memory),
                                   request.reading.asks ? "asks" : "decides", request.name()};
    for (const auto& [key, value] : request.query) words.push_back(key + "=" + value);
    return words;
  }

  /// Of what a person waits for; the rest are the values on their way.
  static constexpr double until_sent = 0.8;

  /// How much is read. What goes backward is not shown: it may begin with another part.
  void take_share(const Json& share) {
    const double read = share.is_number() ? share.get<double>() : -1;
    if (!(read >= 0 && read <= 1) || ++told_ > most_told) fail_unclear();
    read_ = std::max(read_, read);
    tell(request_.reading.progress, until_sent * read_);
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw Error(fmt::format("{}: its reader failed ({})", request_.name(), why));
  }

  [[noreturn]] void fail_ended() {
    process_.kill();  // where it has closed its output and lives on
    const int status = process_.wait();
    if (!WIFSIGNALED(status)) {
      fail(WEXITSTATUS(status) != 0 ? fmt::format("exit code {}", WEXITSTATUS(status))
                                    : "it ended before its answer did");
    }
    const int signal = WTERMSIG(status);
    if (signal == SIGPROF || signal == SIGXCPU)
      fail(fmt::format("it took longer than {:.0f} s of processor time", seconds_));
    if (signal == SIGKILL) fail("it was killed, maybe for want of memory");
    const std::string what = fmt::format("signal {}, {}", signal, sigdescr_np(signal));
    if (library_.empty()) fail(what);
    fail(fmt::format("{0} ended: {1}; the file is damaged, or of a kind that {0} cannot read", library_,
                     what));
  }

  Json parse(const std::string& line) {
    try {
      Json json = parse_json(line);
      if (json.is_object()) return json;
    } catch (const Error&) {
    }
    fail_unclear();
  }

  std::string text_of(const Json& line) {
    const Json& text = line.at("error");
    if (!text.is_string()) fail_unclear();
    return printable(text.get<std::string>());
  }

  [[noreturn]] void fail_as_told(const Json& line) {
    const std::string text = text_of(line);
    if (const auto choice = line.find("choice"); choice != line.end()) {
      std::optional<OpenChoice> what;
      try {
        what = choice_from_json(*choice);
        what->path = request_.name();  // not as told: what is opened next
        what->query = request_.query;
        what->memory = request_.reading.memory;
      } catch (const std::exception&) {
        fail_unclear();
      }
      throw ChoiceNeeded(text, *what);
    }
    throw Error(text);
  }

  /// What a file, and a volume that fits in memory, take at most.
  double most_bytes() const {
    std::error_code ignored;
    const auto size = std::filesystem::is_regular_file(request_.path, ignored)
                          ? std::filesystem::file_size(request_.path, ignored)
                          : 0;
    constexpr double most = 1e15;
    return std::min(double(size) + double(request_.reading.memory), most);
  }

  /// What it takes longer to read may take longer, but no longer than what fits in memory does.
  void expect(const Json& line) {
    constexpr double slowest = 1e6;  // bytes a second
    if (!line.at("expects").is_number() || !line.contains("seconds") || !line.at("seconds").is_number())
      fail_unclear();
    seconds_ = line.at("seconds").get<double>();
    const double bytes = std::clamp(line.at("expects").get<double>(), 0.0, most_bytes());
    deadline_ = std::max(
        deadline_, begin_ + request_.reading.patience + std::chrono::seconds(std::int64_t(bytes / slowest)));
  }

  /// One that a signal has stopped may be continued, but is not waited for as long as one that works.
  void look_whether_it_stopped() {
    if (!process_.is_stopped())
      stopped_.reset();
    else if (!stopped_)
      stopped_ = Clock::now();
    else if (Clock::now() - *stopped_ >= request_.reading.patience)
      fail("it was stopped by a signal");
  }

  /// Waits for some bytes; 0 at the end.
  std::size_t read_some(char* out, std::size_t size) {
    constexpr int stop_is_seen_within = 50;  // ms
    while (true) {
      if (request_.reading.stop.stop_requested()) throw Error(request_.name() + ": reading it was stopped");
      pollfd ready{process_.output(), POLLIN, 0};
      const int found = ::poll(&ready, 1, stop_is_seen_within);
      if (found < 0 && errno != EINTR) fail(std::strerror(errno));
      if (Clock::now() >= deadline_) {
        fail(fmt::format("it took longer than {} s",
                         std::chrono::duration_cast<std::chrono::seconds>(deadline_ - begin_).count()));
      }
      if (found == 0) look_whether_it_stopped();
      if (found <= 0) continue;
      const ssize_t got = ::read(process_.output(), out, size);
      if (got >= 0) return std::size_t(got);
      if (errno != EINTR) fail(std::strerror(errno));
    }
  }

  std::string next_line() {
    std::size_t end = 0, seen = 0;
    while ((end = held_.find('\n', seen)) == std::string::npos) {
      seen = held_.size();
      if (seen > longest_answer_line) fail_unclear();
      char block[1 << 12];
      const std::size_t got = read_some(block, sizeof block);
      if (got == 0) fail_ended();
      held_.append(block, got);
    }
    std::string line = held_.substr(0, end);
    held_.erase(0, end + 1);
    return line;
  }

  /// All of `size` bytes.
  void take(char* out, std::size_t size) {
    const std::size_t held = std::min(held_.size(), size);
    std::memcpy(out, held_.data(), held);
    held_.erase(0, held);
    for (std::size_t done = held; done < size;) {
      const std::size_t got = read_some(out + done, size - done);
      if (got == 0) fail_ended();
      done += got;
    }
  }

  const FileRequest& request_;
  std::string_view library_;
  ReaderProcess process_;
  Clock::time_point begin_ = Clock::now(), deadline_ = begin_ + request_.reading.patience;
  std::optional<Clock::time_point> stopped_;  ///< since when it is
  double read_ = 0;                           ///< of the file, as it told
  int told_ = 0;                              ///< how often
  double seconds_ = 0;                        ///< of processor time, which it may take
  std::string held_;                          ///< read, and not yet taken
};

/// `read`, where what does not fit together in an answer is said of the reader.
template <class Read>
auto checked(Reader& reader, Read read) {
  try {
    return read();
  } catch (const std::exception&) {
    reader.fail_unclear();
  }
}

}  // namespace

Volume read_beside(FileForm form, const FileRequest& request) {
  Reader reader(form, request);
  const Json head = reader.head("volume");
  Volume volume = checked(reader, [&] { return volume_from_json(head.at("volume")); });
  const StoredValues told = checked(reader, [&] { return stored_from_json(head); });
  require_memory(request.name(), {whole_grid(glm::u64vec3(volume.grid.dims)), held_size_of(told.type)},
                 request.reading.memory);
  Voxels::Stored stored = make_stored(told.type, 0);
  std::visit([&](auto& values) { reader.read_values(head, values); }, stored);
  volume.values = Voxels(std::move(stored), told.map);
  if (volume.values.size() != volume.grid.point_count()) reader.fail_unclear();
  return volume;
}

Image read_picture_beside(const FileRequest& request) {
  Reader reader(FileForm::picture, request);
  const Json head = reader.head("picture");
  std::vector<float> values;
  reader.read_values(head, values);
  return checked(reader, [&] {
    const Json& size = head.at("picture");
    Image image{{size.at(0).get<int>(), size.at(1).get<int>()}, {}};
    if (image.size.x < 1 || image.size.y < 1 ||
        values.size() != std::size_t(image.size.x) * std::size_t(image.size.y) * 4)
      reader.fail_unclear();
    image.pixels.resize(values.size() / 4);
    std::memcpy(image.pixels.data(), values.data(), values.size() * sizeof(float));
    return image;
  });
}

std::string read_preset_beside(const FileRequest& request) {
  Reader reader(FileForm::picture_preset, request);
  const Json head = reader.head("preset");
  return checked(reader, [&] { return head.at("preset").get<std::string>(); });
}

}  // namespace crest
