#version 450
// Lambert: the least that a lit fragment costs. Every figure is read beside this one.
//
// The frame that all baselines and candidates share: these varyings, one light, one RGBA output,
// absorption taken as an optical depth in powers of two.
layout(location = 0) in vec3 t;       // unit tangent of hair, unit normal of leaf
layout(location = 1) in vec3 l;       // unit, to the light
layout(location = 2) in vec3 v;       // unit, to the viewer
layout(location = 3) in vec3 sigma_a; // absorption, linear RGB, >= 0
layout(location = 0) out vec4 radiance;

void main()
{
    const float inverse_pi = 0.31830989;
    vec3 albedo = exp2(-sigma_a);
    radiance = vec4(albedo * max(dot(t, l), 0.0) * inverse_pi, 1.0);
}
