#include "render/resources/tf_pieces_buffer.h"

#include <cstdint>
#include <glm/vec4.hpp>

#include "render/gl/errors.h"
#include "render/reference/levels.h"

namespace crest {
namespace {

using Levels = reference::Levels<double>;

struct TfPiecesKey {
  TransferFunction tf;
  std::vector<Peak> surfaces;
  double smallest_spacing;
  bool operator==(const TfPiecesKey&) const = default;
};

/// The std430 layout of the shader's TfPiece.
struct GpuPiece {
  glm::vec4 low, rise;
  float base, least, most, inverse_width;
  float low_value, high_value;
  std::uint32_t first_surface, past_surface;
};

static_assert(sizeof(GpuPiece) == bytes_of_tf_piece);

constexpr float none = 3e38F;

glm::vec4 material(const reference::Vec3<double>& color, double opacity) {
  return {glm::vec3(color), float(opacity)};
}

GpuPiece gpu_piece(const Levels& levels, std::size_t index) {
  const auto& piece = levels.pieces[index];
  const auto* below = index > 0 ? &levels.levels[index - 1] : nullptr;
  const auto* above = index < levels.levels.size() ? &levels.levels[index] : nullptr;
  GpuPiece gpu;
  gpu.low = material(piece.color_low, piece.opacity_low);
  gpu.rise = material(piece.color_high - piece.color_low, piece.opacity_high - piece.opacity_low);
  gpu.low_value = below ? float(below->value.hi) : -none;
  gpu.high_value = above ? float(above->value.hi) : none;
  gpu.base = below ? gpu.low_value : above ? gpu.high_value : 0;
  gpu.least = below ? 0 : -none;
  gpu.most = !above ? none : below ? float(above->value - below->value) : 0;
  gpu.inverse_width = above && below ? float(1 / (above->value - below->value)) : 0;
  gpu.first_surface = above ? std::uint32_t(above->first_surface) : 0;
  gpu.past_surface = above ? std::uint32_t(above->past_surface) : 0;
  return gpu;
}

TfPieces upload(const TfPiecesKey& key) {
  const Levels levels = reference::make_levels<double>(key.tf, key.surfaces, key.smallest_spacing);
  std::vector<GpuPiece> pieces;
  for (std::size_t i = 0; i < levels.pieces.size(); ++i) pieces.push_back(gpu_piece(levels, i));
  GLuint id = 0;
  glCreateBuffers(1, &id);
  TfPieces result{gl::BufferHandle(id), int(pieces.size()), float(levels.extinction_scale)};
  glNamedBufferStorage(id, GLsizeiptr(pieces.size() * sizeof(GpuPiece)), pieces.data(), 0);
  gl::require_no_error("making room for the transfer function");
  return result;
}

}  // namespace

const TfPieces& tf_pieces(KeyedCache& held, const TransferFunction& tf, const std::vector<Peak>& surfaces,
                          double smallest_spacing) {
  const TfPiecesKey key{tf, surfaces, smallest_spacing};
  const std::size_t most_pieces = 3 * tf.points.size() + surfaces.size() + 1;
  return held.get(key, most_pieces * sizeof(GpuPiece), [&] { return upload(key); });
}

}  // namespace crest
