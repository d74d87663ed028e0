// The ground under a tree: a square around its foot.

uniform mat4 u_view_projection;
uniform vec4 u_ground; // middle, half side; world
out vec3 v_position;

void main()
{
    vec2 corner = vec2(gl_VertexID % 2 == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
    v_position = u_ground.xyz + u_ground.w * vec3(corner.x, 0.0, corner.y);
    gl_Position = u_view_projection * vec4(v_position, 1.0);
}
