#include "render/volume/builtin.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

#include "presets/error.h"
#include "presets/nearest_word.h"
#include "render/volume/builtin_fields.h"
#include "render/volume/query.h"
#include "render/volume/take_part.h"

namespace crest {
namespace {

using std::numbers::pi;

/// A built-in's own part of the query.
struct Parameters {
  std::string name;
  Query query;

  double number(std::string_view key, double fallback, double min, double max) const {
    return number_in(name, query, key, fallback, min, max);
  }
  int integer(std::string_view key, int fallback, int min, int max) const {
    return int(integer_in(name, query, key, fallback, min, max));
  }
  std::uint64_t seed() const {
    return std::uint64_t(integer_in(name, query, "seed", 1, 0, std::int64_t(1) << 62));
  }
};

/// Marschner and Lobb 1994.
FormulaField marschner_lobb(const Parameters& q) {
  const double alpha = q.number("alpha", 0.25, 0, 100), frequency = q.number("frequency", 6, 0, 1000);
  return field_of([=](const auto& p) {
    const auto r = sqrt(p.x * p.x + p.y * p.y);
    const auto rho = cos(cos(r * (pi / 2)) * (2 * pi * frequency));
    return (1.0 - sin(p.z * (pi / 2)) + (rho + 1.0) * alpha) / (2 * (1 + alpha));
  });
}

FormulaField sphere(const Parameters& q) {
  const double radius = q.number("radius", 1, 0, 10);
  return field_of([=](const auto& p) { return radius - sqrt(p.x * p.x + p.y * p.y + p.z * p.z); });
}

FormulaField linear(const Parameters& q) {
  const double a = q.number("a", 1, -1e6, 1e6), b = q.number("b", 0.5, -1e6, 1e6),
               c = q.number("c", 0.25, -1e6, 1e6);
  return field_of([=](const auto& p) { return p.x * a + p.y * b + p.z * c; });
}

FormulaField trilinear(const Parameters&) {
  return field_of([](const auto& p) {
    return 0.125 + p.x * 0.5 - p.y * 0.25 + p.z * 0.75 + p.x * p.y * 0.5 - p.y * p.z * 0.75 +
           p.z * p.x * 0.25 + p.x * p.y * p.z;
  });
}

FormulaField gyroid(const Parameters& q) {
  const double k = pi * q.number("periods", 2, 0, 1000);
  return field_of([=](const auto& p) {
    return sin(p.x * k) * cos(p.y * k) + sin(p.y * k) * cos(p.z * k) + sin(p.z * k) * cos(p.x * k);
  });
}

FormulaField plume(const Parameters& q) {
  return plume_field({q.number("decades", 5, 0.1, 30), q.number("turbulence", 1, 0, 4)}, q.seed());
}

FormulaField vessels(const Parameters& q) {
  return vessel_field({q.number("radius", 0.09, 0.001, 0.5), q.integer("generations", 6, 1, 10)}, q.seed());
}

FormulaField noise(const Parameters& q) {
  const double low = q.number("low", 1, 0, 1000);
  return noise_field({low, q.number("high", std::max(low, 4.0), low, 1000)}, q.seed());
}

struct Entry {
  Builtin builtin;
  std::string_view keys;
  int points;  ///< on an axis, unless ?n= says another number
  FormulaField (*field)(const Parameters&);
};

constexpr Entry entries[] = {
    {{"marschner-lobb", "Marschner and Lobb's test signal: ripples of growing frequency",
      "n=64 alpha=0.25 frequency=6"},
     "n,alpha,frequency",
     64,
     marschner_lobb},
    {{"sphere", "radius less the distance from the centre: the sphere of radius R is at radius - R",
      "n=64 radius=1"},
     "n,radius",
     64,
     sphere},
    {{"linear", "a x + b y + c z, exact in float32 at n=65", "n=65 a=1 b=0.5 c=0.25"}, "n,a,b,c", 65, linear},
    {{"trilinear", "1/8 + x/2 - y/4 + 3z/4 + xy/2 - 3yz/4 + zx/4 + xyz: exact between its points at n=65",
      "n=65"},
     "n",
     65,
     trilinear},
    {{"gyroid", "sin kx cos ky + sin ky cos kz + sin kz cos kx, `periods` in the cube", "n=64 periods=2"},
     "n,periods",
     64,
     gyroid},
    {{"plume", "a turbulent plume that rises along z, over five decades of value",
      "n=128 seed=1 decades=5 turbulence=1"},
     "n,seed,decades,turbulence",
     128,
     plume},
    {{"vessels", "a tree of thin bright tubes with an aneurism, in empty space",
      "n=128 seed=1 radius=0.09 generations=6"},
     "n,seed,radius,generations",
     128,
     vessels},
    {{"noise", "band-limited noise: waves of all directions, `low` to `high` cycles a unit",
      "n=64 seed=1 low=1 high=4"},
     "n,seed,low,high",
     64,
     noise},
};

std::pair<const Entry*, Parameters> parse(std::string_view name_and_query) {
  const std::size_t mark = name_and_query.find('?');
  const std::string_view name = name_and_query.substr(0, mark);
  for (const Entry& entry : entries) {
    if (entry.builtin.name != name) continue;
    const std::string source = fmt::format("builtin:{}", name);
    Query query = parse_query(source, mark == std::string_view::npos ? "" : name_and_query.substr(mark + 1));
    require_known_keys(source, query, std::string(entry.keys) + std::string(part_keys));
    return {&entry, {source, std::move(query)}};
  }
  std::vector<std::string_view> known;
  for (const Entry& entry : entries) known.push_back(entry.builtin.name);
  throw Error(fmt::format("builtin:{}: there is no such volume; there are {}{}", name, fmt::join(known, ", "),
                          did_you_mean(name, known)));
}

}  // namespace

std::vector<Builtin> builtins() {
  std::vector<Builtin> all;
  for (const Entry& entry : entries) all.push_back(entry.builtin);
  return all;
}

FormulaField builtin_field(std::string_view name_and_query) {
  const auto [entry, parameters] = parse(name_and_query);
  return entry->field(parameters);
}

Volume make_builtin(std::string_view name_and_query, std::uint64_t memory) {
  const auto [entry, parameters] = parse(name_and_query);
  const int n = parameters.integer("n", entry->points, 2, 1 << 20);
  const GridPart part = part_from_query(parameters.name, parameters.query, glm::u64vec3(std::uint64_t(n)));
  require_memory(parameters.name, {part, sizeof(float)}, memory);
  const FormulaField field = entry->field(parameters);

  Volume volume;
  volume.name = entry->builtin.name;
  volume.grid = {glm::ivec3(n), glm::dvec3(2.0 / (n - 1)), glm::dvec3(-1)};
  take_part(volume, part);
  std::vector<float>& values = volume.values.floats();
  values.resize(volume.grid.point_count());
  // As of the whole grid, so that a part has its values to the bit
  const glm::dvec3 step(2.0 / (n - 1));
  const auto place = [&](glm::u64vec3 p) { return -1.0 + step * glm::dvec3(part.first + part.stride * p); };
  const glm::u64vec3 dims = part.dims();
  tbb::parallel_for(std::uint64_t(0), dims.z, [&](std::uint64_t k) {
    float* out = values.data() + k * dims.x * dims.y;
    for (std::uint64_t j = 0; j < dims.y; ++j) {
      for (std::uint64_t i = 0; i < dims.x; ++i) *out++ = float(field.value(place({i, j, k})));
    }
  });
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return volume;
}

}  // namespace crest
