// SPDX-License-Identifier: MIT
// Where a fibre is bright: the density by which lights and environments choose directions.
//
// A lobe is narrow in the inclination theta of the light and lies near the mirror cone, theta_i =
// -theta_r. Directions follow a Cauchy density in theta around a shifted mirror cone; its centre
// and width go over from one pair of numbers in front of the fibre to another behind it, where
// light shines straight through in a lobe half as wide. In the azimuth the density is that of a
// stretched half angle, twice the mean behind the fibre and half of it in front. The numbers were
// fitted to the error that tests/light measures.

struct tsu_light_fiber {
    vec2 front; // centre from the mirror cone and width, radians, of light on the viewer's side
    vec2 back;  // the same of light that comes through the fibre
};

// For marschner, dual_scattering and others made of R, TT and TRT.
//   alpha_R, beta_R   the material's shift and deviation, radians
tsu_light_fiber tsu_light_lobes(float alpha_R, float beta_R)
{
    return tsu_light_fiber(vec2(-0.23 * alpha_R, 1.53 * beta_R),
                           vec2(-0.5 * alpha_R, 0.55 * beta_R));
}

// For kajiya_kay: one lobe on the whole cone, over a wide one.
tsu_light_fiber tsu_light_cone(float alpha_R, float beta_R)
{
    return tsu_light_fiber(vec2(alpha_R, 2.5 * beta_R), vec2(alpha_R, 2.5 * beta_R));
}

// Centre and width at an azimuth x from the one straight behind the fibre.
vec2 tsu_light_lobe(tsu_light_fiber fiber, float mirror, float x)
{
    float behind = 0.5 + 0.5 * cos(x);
    vec2 lobe = mix(fiber.front, fiber.back, behind * behind);
    return vec2(mirror + lobe.x, max(lobe.y, 0.005));
}

// Inclination of the mirror cone.
float tsu_light_mirror(vec3 t, vec3 v)
{
    return -asin(clamp(dot(t, v), -1.0, 1.0));
}

// Component of `a` normal to the unit vector t, unit; any normal of t where there is none.
vec3 tsu_light_across(vec3 t, vec3 a)
{
    vec3 p = a - t * dot(t, a);
    vec3 other = cross(t, abs(t.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
    // Written so that what is no number takes the second way.
    return dot(p, p) > 1e-12 ? normalize(p) : normalize(other);
}

// Place of sample i in the inclination, [0, 1): with equal steps in the azimuth a lattice that
// leaves no gap at any number of samples, and is best at 5, 8, 13, 21.
float tsu_light_level(int i)
{
    return fract(0.5 + float(i) * 0.61803399);
}
