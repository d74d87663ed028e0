// A vertex of a plant: a leaf's in its place, or wood as it stands.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;
layout(location = 4) in vec3 a_albedo;
layout(location = 5) in mat4 a_place;
layout(location = 9) in vec4 a_factors; // pigment, thickness
uniform mat4 u_model;
uniform mat4 u_view_projection;
uniform vec3 u_crown;      // centre, before u_model
uniform vec3 u_crown_half; // half axes; 0: no crown
out vec3 v_position;
out vec3 v_normal;
out vec4 v_tangent;
out vec2 v_uv;
out vec3 v_albedo;
out vec2 v_factors;
out vec3 v_crown; // out of the crown; 0: no crown

void main()
{
    vec4 place = a_place * vec4(a_position, 1.0);
    mat3 turn = mat3(u_model) * mat3(a_place);
    v_position = (u_model * place).xyz;
    v_normal = turn * a_normal;
    v_tangent = vec4(turn * a_tangent.xyz, a_tangent.w);
    v_uv = a_uv;
    v_albedo = a_albedo;
    v_factors = a_factors.xy;
    v_crown = u_crown_half.x > 0.0
                  ? mat3(u_model) * normalize((place.xyz - u_crown) / (u_crown_half * u_crown_half))
                  : vec3(0.0);
    gl_Position = u_view_projection * vec4(v_position, 1.0);
}
