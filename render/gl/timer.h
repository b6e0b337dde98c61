#pragma once

#include <functional>

#include "render/gl/handle.h"

namespace crest::gl {

inline void delete_query(GLuint id) { glDeleteQueries(1, &id); }
using QueryHandle = Handle<delete_query>;

/// Milliseconds that the graphics device itself spends on what `work` asks of it (GL_TIME_ELAPSED). Waits
/// until they are over. Such measurements do not nest.
inline double device_ms(const std::function<void()>& work) {
  GLuint id = 0;
  glCreateQueries(GL_TIME_ELAPSED, 1, &id);
  const QueryHandle query(id);
  glBeginQuery(GL_TIME_ELAPSED, id);
  work();
  glEndQuery(GL_TIME_ELAPSED);
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(id, GL_QUERY_RESULT, &nanoseconds);
  return 1e-6 * double(nanoseconds);
}

}  // namespace crest::gl
