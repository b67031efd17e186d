#version 330 core
// One triangle that covers the whole view.

out vec2 place; // -1 to 1

void main()
{
    place = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
    gl_Position = vec4(place, 0, 1);
}
