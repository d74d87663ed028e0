#version 450
// Lambert under one isotropic GGX lobe: what an ordinary surface material costs.
//
// Source: Walter et al. 2007, eq. 33 (distribution); Heitz 2014, eq. 99 (correlated masking);
//         Schlick 1994 (Fresnel).
layout(location = 0) in vec3 t; // here the normal
layout(location = 1) in vec3 l;
layout(location = 2) in vec3 v;
layout(location = 3) in vec3 sigma_a;
layout(std140, set = 0, binding = 0) uniform surface_block
{
    vec4 surface; // rgb reflectance at normal incidence, a roughness alpha
};
layout(location = 0) out vec4 radiance;

void main()
{
    const float pi = 3.14159265, inverse_pi = 0.31830989;
    vec3 h = normalize(l + v);
    float n_l = clamp(dot(t, l), 0.0, 1.0), n_v = abs(dot(t, v)) + 1e-5;
    float n_h = clamp(dot(t, h), 0.0, 1.0), l_h = clamp(dot(l, h), 0.0, 1.0);
    float alpha2 = surface.a * surface.a;

    float root = (n_h * alpha2 - n_h) * n_h + 1.0;
    float distribution = alpha2 / (pi * root * root);
    float masking = 0.5 / (n_l * sqrt((n_v - n_v * alpha2) * n_v + alpha2) +
                           n_v * sqrt((n_l - n_l * alpha2) * n_l + alpha2));
    float grazing = 1.0 - l_h, grazing2 = grazing * grazing;
    vec3 fresnel = surface.rgb + (1.0 - surface.rgb) * (grazing2 * grazing2 * grazing);

    radiance = vec4((exp2(-sigma_a) * inverse_pi + distribution * masking * fresnel) * n_l, 1.0);
}
