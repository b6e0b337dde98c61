// A slice through the volume: a grey of the value, the TF's colours over it, and a line where it meets a surface.

#include "statistics.glsl"
#include "field.glsl"
#include "compositing.glsl"
#include "surfaces.glsl"
#include "tf_pieces.glsl"

layout(location = 0) out vec4 out_color;

uniform vec3 slice_corner, slice_right, slice_down;  // of the first pixel's corner; from pixel to pixel
uniform vec2 grey_min_scale;                         // grey is (value - x) * y
uniform int surface_count;
uniform float line_width;  // in pixels

#if EMPTY_CELLS
uniform usampler3D empty_cells;  // 1 = this cell is empty
bool is_empty(vec3 position) {
  ivec3 cell = clamp(ivec3(position / cell_size), ivec3(0), textureSize(empty_cells, 0) - 1);
  return texelFetch(empty_cells, cell, 0).r != 0u;
}
#endif

// Opacities are of a length, a slice has none: their cube root, so that faint ones are seen.
vec3 filling(float value) {
  TfPiece piece = tf_piece(piece_at(value));
  vec4 material = piece.low + piece.rise * fraction_of(piece, offsets_in(piece, value).above_low);
  float grey = 0.7 * clamp((value - grey_min_scale.x) * grey_min_scale.y, 0.0, 1.0);
  return mix(vec3(grey), material.rgb, pow(material.a, 1.0 / 3.0));
}

// Of the surfaces the one whose value is nearest, which is the nearest in the slice: they share one gradient.
int nearest_surface(float value) {
  int first = 0, last = surface_count;  // the first one above the value
  while (first < last) {
    int middle = (first + last) / 2;
    if (peaks[middle].value > value)
      last = middle;
    else
      first = middle + 1;
  }
  if (first == surface_count) return first - 1;
  return first > 0 && value - peaks[first - 1].value < peaks[first].value - value ? first - 1 : first;
}

// How far a line is, in pixels: the difference of the values by how much the field changes from pixel to pixel.
float distance_to(float difference, vec3 position) {
  vec2 slope = vec2(field(position + 0.5 * slice_right) - field(position - 0.5 * slice_right),
                    field(position + 0.5 * slice_down) - field(position - 0.5 * slice_down));
  return abs(difference) / max(length(slope), 1.0e-37);
}

void main() {
  vec3 position = slice_corner + gl_FragCoord.x * slice_right + gl_FragCoord.y * slice_down;
#if EMPTY_CELLS
  if (is_empty(position)) {
    out_color = vec4(0.0, 0.0, 0.0, 1.0);
    return;
  }
#endif
  float value = field(position);
  vec3 color = filling(DVR_VALUE(value, position));
  if (surface_count > 0) {
    Peak surface = peaks[nearest_surface(value)];
    float pixels = distance_to(value - surface.value, position), reach = 0.5 * line_width + 0.5;
    color = mix(color, vec3(0.0), 0.7 * clamp(reach + 1.0 - pixels, 0.0, 1.0));  // its rim
    color = mix(color, surface.color_opacity.rgb, clamp(reach - pixels, 0.0, 1.0));
  }
  out_color = vec4(color, 1.0);
}
