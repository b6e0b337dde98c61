// The function that is exported as GLSL source, compiled and evaluated by a driver.
#include <random>
#include <string>

#include "presets/exchange/exporters.h"
#include "tests/presets/random_tf.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

GLuint compiled(GLenum type, const std::string& source) {
  const GLuint shader = glCreateShader(type);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (!good) {
    char log[2000];
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    ADD_FAILURE() << log << '\n' << source;
  }
  return shader;
}

gl::ProgramHandle program_of(const std::string& fragment) {
  gl::ProgramHandle program(glCreateProgram());
  const std::string vertex =
      "#version 330\nvoid main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, "
      "0.0, 1.0); }";
  for (const gl::ShaderHandle& shader : {gl::ShaderHandle(compiled(GL_VERTEX_SHADER, vertex)),
                                         gl::ShaderHandle(compiled(GL_FRAGMENT_SHADER, fragment))})
    glAttachShader(program.id(), shader.id());
  glLinkProgram(program.id());
  return program;
}

using GlslExport = RaycasterTest;

TEST_F(GlslExport, IsTheFunctionAndItsPeaks) {
  constexpr int count = 1000;
  std::mt19937 random(31);
  for (int trial = 0; trial < 10; ++trial) {
    ExportInput input;
    input.name = "random\n#error a name is no code";
    TransferFunction& tf = input.preset.transfer_function;
    tf = random_tf(random, 60);
    for (ControlPoint& point : tf.points) point.value = double(float(point.value));
    const std::string source = find_exporter("glsl").write(input).files[0].content;
    const auto peaks = shown_peaks(find_peaks(tf));
    const auto program = program_of(
        "#version 330\n" + source +
        "uniform float low, high; out vec4 color;\n"
        "void main() {\n"
        "  int i = int(gl_FragCoord.x);\n"
        "  color = gl_FragCoord.y < 1.0 ? transfer_function(low + (high - low) * (float(i) / 999.0))\n"
        "        : i < tf_peak_count ? vec4(tf_peaks[i].value, tf_peaks[i].color_opacity.gba) : vec4(-1.0);\n"
        "}");
    const auto low = float(tf.range().min - 0.1 * tf.range().width()),
               high = float(tf.range().max + 0.1 * tf.range().width());
    glProgramUniform1f(program.id(), glGetUniformLocation(program.id(), "low"), low);
    glProgramUniform1f(program.id(), glGetUniformLocation(program.id(), "high"), high);
    gl::RenderTarget target({count, 2}, false);
    GLuint vertices = 0;
    glCreateVertexArrays(1, &vertices);
    const gl::VertexArrayHandle vertex_array(vertices);
    glBindVertexArray(vertices);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, count, 2);
    glDisable(GL_BLEND);
    glUseProgram(program.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const Image image = target.read_color();
    // Beside a point the float value may lie on its other side
    const double rounding = 4e-7 * std::max(std::abs(low), std::abs(high));
    for (int i = 0; i < count; ++i) {
      const double value = double(low + (high - low) * (float(i) / 999.0f));
      const glm::vec4 found = image.at(i, 0);
      EXPECT_TRUE(has_near(tf, value, {glm::dvec3(found), found.a}, rounding, 2e-6)) << value;
    }
    for (std::size_t i = 0; i < peaks.size(); ++i) {
      EXPECT_EQ(image.at(int(i), 1).r, float(peaks[i].value));
      EXPECT_EQ(image.at(int(i), 1).a, float(peaks[i].opacity));
    }
    if (peaks.size() < std::size_t(count)) {
      EXPECT_EQ(image.at(int(peaks.size()), 1).r, -1);
    }
  }
}

}  // namespace
}  // namespace crest::testing
