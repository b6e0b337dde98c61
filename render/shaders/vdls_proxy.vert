// A part of the screen that is drawn: its corners are in pixels, row 0 at the top.

layout(location = 0) in vec2 corner;
uniform vec2 picture_size;

void main() { gl_Position = vec4(2.0 * corner / picture_size - 1.0, 0.0, 1.0); }
