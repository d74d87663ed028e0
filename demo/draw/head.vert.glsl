// The head under the hair, a little smaller, so that hair that lies on it stays in sight.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
uniform mat4 u_model;
uniform mat4 u_view_projection;
out vec3 v_position;
out vec3 v_normal;

void main()
{
    vec3 position = a_position - 0.0015 * a_normal;
    v_position = (u_model * vec4(position, 1.0)).xyz;
    v_normal = mat3(u_model) * a_normal;
    gl_Position = u_view_projection * vec4(v_position, 1.0);
}
