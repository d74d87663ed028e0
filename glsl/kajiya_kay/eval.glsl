// SPDX-License-Identifier: MIT
// Kajiya and Kay's fibre with Marschner's energy: no fetch, half of Marschner's price.
//
// Record of a material:
//   0  cos(alpha_R), sin(alpha_R), exponent n, log2(1/pi^2)
//   1  k_R = x + y exp2(z cos_r), z < 0
//   2  path of the body log2(e) (x cos_r + y); integral of the highlight z |cos_r'| + w
//   3  sigma_a of the material (linear RGB), eta

struct tsu_kajiya_kay_lobes {
    vec3 diffuse;   // body
    float specular; // highlight, no colour
};

// Scattering of a fibre: S cos(theta_i) in 1/sr. Multiply by radiance and solid angle of the light.
//   material   index in the bound page
//   t          unit tangent, root to tip
//   l, v       unit, towards light and viewer, same space as t
//   sigma_a    absorption per fibre radius, linear RGB, >= 0
// Source: Kajiya and Kay 1989, eqs. 14 and 16; how energy and angles map is in the header
// tsuya/models/kajiya_kay.h, with the errors.
tsu_kajiya_kay_lobes tsu_kajiya_kay_eval(int material, vec3 t, vec3 l, vec3 v, vec3 sigma_a)
{
    vec4 highlight = TSU_RECORD(material, 0);
    vec4 surface = TSU_RECORD(material, 1);
    vec4 body = TSU_RECORD(material, 2);

    float sin_i = dot(t, l);
    float sin_r = dot(t, v);
    float cos_i = sqrt(clamp(1.0 - sin_i * sin_i, 0.0, 1.0));
    float cos_r = sqrt(clamp(1.0 - sin_r * sin_r, 0.0, 1.0));

    // The view's inclination is turned by the shift; past a pole it comes back on the other side.
    float sin_s = highlight.x * sin_r - highlight.y * cos_r;
    float cos_s = highlight.x * cos_r + highlight.y * sin_r;
    float cone = clamp(cos_i * abs(cos_s) - sin_i * sin_s, 0.0, 1.0);
    float reflected = surface.y * exp2(surface.z * cos_r) + surface.x;

    tsu_kajiya_kay_lobes lobes;
    // Outside of the cone log2 gives -infinity and exp2 of it 0.
    lobes.specular = exp2(highlight.z * log2(cone)) * (reflected / (body.z * abs(cos_s) + body.w));
    lobes.diffuse = (cos_i - cos_i * reflected) *
                    exp2(highlight.w - sigma_a * (body.x * cos_r + body.y));
    return lobes;
}

vec3 tsu_kajiya_kay_sum(tsu_kajiya_kay_lobes lobes)
{
    return lobes.diffuse + lobes.specular;
}

// The material's own absorption, for hosts without a colour per fragment.
vec3 tsu_kajiya_kay_sigma_a(int material)
{
    return TSU_RECORD(material, 3).xyz;
}
