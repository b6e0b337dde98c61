// Where a walk through a grid says that the ray meets the cells' faces.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "render/gl/program.h"
#include "render/gl/uniforms.h"
#include "render/shader_inputs/view_uniforms.h"
#include "tests/changed_shaders.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

/// Walks through all cells, and tells how far a face is off at most, in units of the slack that covers it,
/// and how many there are. The face's exact place is that of the ray as the shader has it.
constexpr const char* faces_fragment = R"(
#include "macrocells.glsl"
layout(location = 0) out vec4 out_color;
void main() {
  Ray ray = pixel_ray();
  Span box;
  out_color = vec4(0.0);
  if (!hit_box(ray, box.enter, box.exit)) return;
  float slack = slack_of(ray, box), worst = 0.0, faces = 0.0;
  Walk walk = begin_walk(ray, box, ivec3(round(box_size / cell_size)), cell_size);
  for (ivec3 from = walk.cell; advance(walk); from = walk.cell) {
    ivec3 face = max(from, walk.cell);
    dvec3 exact = (dvec3(face) * dvec3(cell_size) - dvec3(ray.origin)) / dvec3(ray.direction);
    double at = walk.cell.x != from.x ? exact.x : walk.cell.y != from.y ? exact.y : exact.z;
    worst = max(worst, float(abs(double(walk.t) - at)));
    faces += 1.0;
  }
  out_color = vec4(worst / slack, worst, faces, 1.0);
}
)";

/// Rays that run through the whole length of the box along z, and through it on the other axes, too.
Camera along_the_volume(const Grid& grid) {
  const glm::dvec3 size = grid.box_size();
  Camera camera;
  camera.target = grid.origin + 0.5 * size;
  camera.eye = camera.target - size * glm::dvec3(0.4, 0.3, 0.6);
  camera.fov_y_degrees = glm::degrees(2 * std::atan(0.5 * size.y / (0.6 * size.z)));
  return camera;
}

class Walks : public RaycasterTest {
 protected:
  /// What the shader tells of each pixel.
  Image faces(const Scene& scene, const Camera& camera, glm::ivec2 size) {
    const ChangedShaders shaders("spans.glsl", "", "");
    std::ofstream(shaders.folder() / "walk_faces.frag") << faces_fragment;
    Features features;
    features.skipping = true;
    const auto program =
        gl::build_fullscreen_program("walk_faces.frag", shader_defines(features), shaders.folder());
    set_view(program.id(), scene, camera, size);
    const gl::RenderTarget target(size, false);
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    const gl::VertexArrayHandle vertex_array(id);
    glBindVertexArray(id);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_BLEND);
    glUseProgram(program.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return target.read_color();
  }
};

// A sum of the distances from face to face is off by many times as much at the far end of a long ray.
TEST_F(Walks, FacesAreWhereTheirIndicesSay) {
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 100), glm::dvec3(3, 1, 7)}) {
    Volume volume;  // its values are not looked at
    volume.grid = {glm::ivec3(256), spacing, glm::dvec3(0)};
    volume.values = std::vector<float>{0, 1};
    Scene scene;
    scene.volume = std::make_shared<const Volume>(std::move(volume));
    const Camera camera = along_the_volume(scene.volume->grid);
    double worst = 0, most = 0;
    for (const glm::vec4& pixel : faces(scene, camera, {64, 64}).pixels) {
      worst = std::max(worst, double(pixel.x));
      most = std::max(most, double(pixel.z));
    }
    EXPECT_LT(worst, 0.5) << spacing.x << ':' << spacing.y << ':' << spacing.z;
    EXPECT_GT(most, 255);
  }
}

}  // namespace
}  // namespace crest::testing
