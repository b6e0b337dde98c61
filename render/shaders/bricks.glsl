// A volume of which only the bricks that show are held, side by side in a texture (resources/brick_atlas.h). Another one
// is met where a march begins or ends in it, and shows nothing: one of its values stands for all, on the same side of
// each surface.

uniform usampler3D brick_table;  // a brick's place in the texture, counted in bricks; or that it is not held, and a texel
uniform ivec3 grid_points;
const int brick_cells = 32, brick_points = brick_cells + 1;

ivec3 volume_points() { return grid_points; }

const uint not_held = 0xffffffffu;

struct Brick {
  ivec3 to_texture;  // from a point of the grid to its texel
  bool is_held;
  float texel;  // where it is not
};

Brick brick_of(ivec3 point) {
  ivec3 brick = min(point, grid_points - 2) / brick_cells;
  uvec4 entry = texelFetch(brick_table, brick, 0);
  return Brick(ivec3(entry.xyz) * brick_points - brick * brick_cells, entry.x != not_held, uintBitsToFloat(entry.w));
}

float texel_at(ivec3 point) {
  Brick brick = brick_of(point);
  return brick.is_held ? texelFetch(volume, point + brick.to_texture, 0).r : brick.texel;
}

// `place` is from 0 to 1, with a point in the middle of its texel, as in a texture of the whole volume.
float texel_between(vec3 place) {
  vec3 point = clamp(place * vec3(grid_points) - 0.5, vec3(0.0), vec3(grid_points - 1));
  Brick brick = brick_of(ivec3(point));
  vec3 texel = point + vec3(brick.to_texture) + 0.5;
  return brick.is_held ? textureLod(volume, texel / vec3(textureSize(volume, 0)), 0.0).r : brick.texel;
}
