// SPDX-License-Identifier: MIT
// Function "longitudinal": theta_i, theta_r, beta -> M. The R lobe of an unshifted material.

void tsu_probe(int material, float x[16], out float y[8])
{
    float sin_i = sin(x[0]), cos_i = cos(x[0]), sin_r = sin(x[1]), cos_r = cos(x[1]);
    vec4 products = vec4(cos_i * cos_r, cos_i * sin_r, sin_i * sin_r, sin_i * cos_r);
    vec4 lobe = TSU_RECORD(material, 0);
    float exponent, factor;
    tsu_marschner_longitudinal(products, lobe.x, lobe.y, lobe.z, exponent, factor);
    y[0] = factor * exp2(exponent);
}
