// SPDX-License-Identifier: MIT
// Marschner's fibre: R, TT, TRT and the residual of all longer paths.
//
// Record of a material (a, b, c as in longitudinal.glsl):
//   0  a, b, c of R, origin.x of the table in the texture
//   1  a, b, c of TT, origin.y
//   2  a, b, c of TRT, origin.z
//   3  size of the table (x, y, z as in azimuthal.glsl), eta
//   4  sigma_a of the material (linear RGB)
//   5  a, b of the residual, for TSU_SHADER_FINE; its c is TRT's

struct tsu_marschner_lobes {
    float r;   // surface reflection, no colour
    vec3 tt;   // straight through
    vec3 trt;  // one internal reflection; 0 where it is dropped
    vec3 res;  // two and more; 0 where they are dropped
};

// Scattering of a fibre, lobe by lobe: S cos(theta_i) in 1/sr. Multiply by radiance and solid angle
// of the light; no further cosine.
//   material   index in the bound page
//   t          unit tangent, root to tip
//   l, v       unit, towards light and viewer, same space as t
//   sigma_a    absorption per fibre radius, linear RGB, >= 0; tsu_marschner_sigma_a() is the
//              material's own
// The shift of a lobe rotates the view's inclination, N is taken at the view's inclination: with
// sigma_a = 0 the integral over all l is 1 for every v. Not reciprocal where lobes are shifted.
// Error: against the double-precision model in the header tsuya/models/marschner.h.
tsu_marschner_lobes tsu_marschner_eval(int material, vec3 t, vec3 l, vec3 v, vec3 sigma_a)
{
    vec4 r = TSU_RECORD(material, 0);
    vec4 tt = TSU_RECORD(material, 1);
    vec4 trt = TSU_RECORD(material, 2);
    vec4 size = TSU_RECORD(material, 3);

    float sin_i = dot(t, l);
    float sin_r = dot(t, v);
    // The 5e-7 is what rounding may take off: along the fibre a cosine that is too small would throw
    // phi to its ends, which makes energy. abs: rounding may carry a sine past 1.
    float cos_i = sqrt(abs(1.0000005 - sin_i * sin_i));
    float cos_r = sqrt(abs(1.0000005 - sin_r * sin_r));
    // 1e-12 keeps the division below finite for light or view along the fibre, where phi means
    // nothing; within half a degree of the axis the dot products of 32 bits blur phi by degrees.
    vec4 products =
        vec4(cos_i * cos_r + 1e-12, cos_i * sin_r, sin_i * sin_r, sin_i * cos_r);

    // cos(phi) = (l.v - sin_i sin_r) / (cos_i cos_r); cos^2(phi/2) = (1 + cos(phi)) / 2
    float cos2_half = clamp((dot(l, v) - products.z) * (0.5 / products.x) + 0.5, 0.0, 1.0);
    vec4 n, path;
    tsu_marschner_azimuthal(vec3(r.w, tt.w, trt.w), size.xyz, cos_r, cos2_half, n, path);

    tsu_marschner_lobes lobes;
    float exponent, factor;
    tsu_marschner_longitudinal(products, r.x, r.y, r.z, exponent, factor);
    lobes.r = n.x * factor * exp2(exponent);
    tsu_marschner_longitudinal(products, tt.x, tt.y, tt.z, exponent, factor);
    lobes.tt = n.y * factor * exp2(tsu_marschner_absorb_tt(path, sigma_a, exponent));
#ifdef TSU_DROP_TRT
    lobes.trt = vec3(0.0);
#else
    tsu_marschner_longitudinal(products, trt.x, trt.y, trt.z, exponent, factor);
    lobes.trt = n.z * factor * exp2(tsu_marschner_absorb(path.z, sigma_a, exponent));
#endif
#ifdef TSU_DROP_RESIDUAL
    lobes.res = vec3(0.0);
#else
#ifdef TSU_FINE
    // The residual's own shift.
    vec4 res = TSU_RECORD(material, 5);
    tsu_marschner_longitudinal(products, res.x, res.y, trt.z, exponent, factor);
#else
    // The residual shares TRT's lobe, which saves ten instructions.
#ifdef TSU_DROP_TRT
    tsu_marschner_longitudinal(products, trt.x, trt.y, trt.z, exponent, factor);
#endif
#endif
    lobes.res = n.w * factor * exp2(tsu_marschner_absorb(path.w, sigma_a, exponent));
#endif
    return lobes;
}

vec3 tsu_marschner_sum(tsu_marschner_lobes lobes)
{
    vec3 sum = lobes.r + lobes.tt;
#ifndef TSU_DROP_TRT
    sum += lobes.trt;
#endif
#ifndef TSU_DROP_RESIDUAL
    sum += lobes.res;
#endif
    return sum;
}

// The material's own absorption, for hosts without a colour per fragment.
vec3 tsu_marschner_sigma_a(int material)
{
    return TSU_RECORD(material, 4).xyz;
}
