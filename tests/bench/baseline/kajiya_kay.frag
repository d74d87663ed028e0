#version 450
// Kajiya-Kay: sine diffuse and a highlight on the cone of reflection, one exponent.
//
// Source: Kajiya and Kay 1989, section 3.
layout(location = 0) in vec3 t;
layout(location = 1) in vec3 l;
layout(location = 2) in vec3 v;
layout(location = 3) in vec3 sigma_a;
layout(std140, set = 0, binding = 0) uniform fibre_block
{
    vec4 specular; // rgb colour, a exponent
};
layout(location = 0) out vec4 radiance;

void main()
{
    float cos_l = dot(t, l), cos_v = dot(t, v);
    float sin_l = sqrt(max(1.0 - cos_l * cos_l, 0.0));
    float sin_v = sqrt(max(1.0 - cos_v * cos_v, 0.0));
    // Cosine between the viewer and the mirror cone of the light.
    float cone = max(sin_l * sin_v - cos_l * cos_v, 0.0);
    radiance = vec4(exp2(-sigma_a) * sin_l + specular.rgb * pow(cone, specular.a), 1.0);
}
