// SPDX-License-Identifier: MIT
// Self-shadow of hair: one struct, whoever fills it.
//
// A model with the extra inputs front, behind and direct takes them as they are. Any other model is
// multiplied by the transmittance.

// Fibres beyond a point when nobody knows: hair there is thick.
#define TSU_HAIR_SHADOW_UNKNOWN 1000.0

struct tsu_hair_shadow {
    float front;         // mean number of fibres between the point and the light
    float behind;        // mean number further along the same line, away from the light
    float direct;        // share of the direct light that arrives, mean of exp(-front) over taps
    float transmittance; // mean of exp(-opacity front), for models without multiple scattering
};

// No shadow is known: all direct light arrives. What other hair sends cannot be told without it, so
// models with multiple scattering fall back to their single fibre: to them no diffuse light is left
// of what came past so much hair. (dual_scattering's variant zinke keeps its local back scattering.)
tsu_hair_shadow tsu_hair_shadow_none()
{
    return tsu_hair_shadow(TSU_HAIR_SHADOW_UNKNOWN, 0.0, 1.0, 1.0);
}

// From counts of the host's own: a voxel grid, traced rays, data baked into vertices.
//   front, behind   fibres, >= 0; behind TSU_HAIR_SHADOW_UNKNOWN when it is not known
// The opacity of a fibre is 1: raise the transmittance to the power of another one. What is no
// number counts as 0.
tsu_hair_shadow tsu_hair_shadow_count(float front, float behind)
{
    float n = front > 0.0 ? min(front, TSU_HAIR_SHADOW_UNKNOWN) : 0.0;
    float through = exp(-n);
    return tsu_hair_shadow(n, behind > 0.0 ? min(behind, TSU_HAIR_SHADOW_UNKNOWN) : 0.0, through,
                           through);
}

// From a transmittance of the host's own, [0, 1]: front = -log(t), behind unknown.
tsu_hair_shadow tsu_hair_shadow_transmittance(float t)
{
    float through = t < 1.0 ? max(t, 0.0) : 1.0;
    // 1e-30: a float's logarithm is -infinity at 0; exp(-69) is no light either.
    return tsu_hair_shadow(-log(max(through, 1e-30)), TSU_HAIR_SHADOW_UNKNOWN, through, through);
}
