#pragma once

namespace crest {

/// The key that counts where one is pressed, as GLFW numbers keys: the one whose letter stands on its cap.
///
/// `key` is where it would be on a US keyboard, which is what GLFW tells; `name` what it types without Shift
/// in the present layout, in UTF-8, or null (glfwGetKeyName). A letter or a digit on the cap counts; so
/// Ctrl+Z is where Z stands. A key without a Latin letter on it keeps its place, as on Greek or Cyrillic
/// keyboards, and so do the digits where they need Shift, as on French ones. A key in the place of a letter
/// that types something else counts as that, or as none (-1).
int key_on_cap(int key, const char* name);

}  // namespace crest
