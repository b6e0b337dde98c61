#include "app/report/page.h"

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <chrono>

#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/json.h"
#include "web_files_embedded.h"

namespace crest {
namespace {

constexpr std::size_t largest_picture = std::size_t(1) << 30;

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) html += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return html;
}

/// JSON that no HTML parser takes for the end of its script.
std::string script_text(const Json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace))
    text += c == '<' ? "\\u003c" : std::string(1, c);
  return text;
}

std::string base64(std::string bytes) {
  using namespace boost::archive::iterators;
  using Digits = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0');
  std::string text(Digits(bytes.cbegin()), Digits(bytes.cend()));
  return text.replace(text.size() - padding, padding, padding, '=');
}

std::string address_of(std::string png) { return "data:image/png;base64," + base64(std::move(png)); }

}  // namespace

std::string utc_now() {
  using namespace std::chrono;
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", time_point_cast<seconds>(system_clock::now()));
}

std::string_view web_file(std::string_view name) {
  const auto files = web_files::embedded_files();
  const auto found =
      std::ranges::find(files, fmt::format("report/web/{}", name), &web_files::EmbeddedFile::name);
  if (found == files.end()) throw Error(fmt::format("{}: not among the program's web files", name));
  return found->text;
}

void write_page(const std::filesystem::path& path, std::string_view title, std::string_view body,
                std::string_view script, const Json& data) {
  const std::pair<std::string_view, std::string> parts[] = {{"{{title}}", escaped(title)},
                                                            {"{{style}}", std::string(web_file("page.css"))},
                                                            {"{{body}}", std::string(body)},
                                                            {"{{data}}", script_text(data)},
                                                            {"{{chart}}", std::string(web_file("chart.js"))},
                                                            {"{{script}}", std::string(script)}};
  std::string_view rest = web_file("page.html");
  std::string page;
  for (const auto& [mark, text] : parts) {  // in the order in which the page has them
    const std::size_t at = rest.find(mark);
    page += rest.substr(0, at);
    page += text;
    rest.remove_prefix(at + mark.size());
  }
  page += rest;
  write_file_atomically(path, page);
}

std::string data_address(const std::filesystem::path& png) {
  return address_of(read_file(png, largest_picture));
}

std::string data_address(const Image& image, glm::vec3 background) {
  return address_of(png_of(image, background));
}

}  // namespace crest
