#pragma once

#include <functional>

#include "render/gl/handle.h"

namespace crest::gl {

inline void delete_query(GLuint id) { glDeleteQueries(1, &id); }
using QueryHandle = Handle<delete_query>;

/// Asks for the time that the graphics device itself spends on `work` (GL_TIME_ELAPSED), and does not wait
/// for it. Such measurements do not nest.
inline QueryHandle time_on_device(const std::function<void()>& work) {
  GLuint id = 0;
  glCreateQueries(GL_TIME_ELAPSED, 1, &id);
  QueryHandle query(id);
  struct Measurement {
    explicit Measurement(GLuint id) { glBeginQuery(GL_TIME_ELAPSED, id); }
    ~Measurement() { glEndQuery(GL_TIME_ELAPSED); }  // also where the work throws
  } const measurement(id);
  work();
  return query;
}

/// Whether what was measured is over. Does not wait.
inline bool is_over(const QueryHandle& query) {
  GLint over = GL_FALSE;
  glGetQueryObjectiv(query.id(), GL_QUERY_RESULT_AVAILABLE, &over);
  return over == GL_TRUE;
}

/// The milliseconds of what was measured. Waits until it is over.
inline double measured_ms(const QueryHandle& query) {
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query.id(), GL_QUERY_RESULT, &nanoseconds);
  return 1e-6 * double(nanoseconds);
}

/// Milliseconds that the graphics device itself spends on what `work` asks of it. Waits until they are over.
inline double device_ms(const std::function<void()>& work) { return measured_ms(time_on_device(work)); }

}  // namespace crest::gl
