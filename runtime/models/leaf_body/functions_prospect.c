#include "models/leaf_body/functions_prospect.h"

#include "models/values.h"
#include "optics/prospect.h"

const tsu_value_info tsu_i_leaf_prospect_inputs[LEAF_PROSPECT_INPUTS] = {
    TSU_I_FRAGMENT("N", "1", "structure: plates with air between them", 1, 10, 1.5),
    TSU_I_FRAGMENT("Cab", "ug/cm2", "chlorophyll", 0, 1e6, 40),
    TSU_I_FRAGMENT("Car", "ug/cm2", "carotenoids", 0, 1e6, 8),
    TSU_I_FRAGMENT("Ant", "ug/cm2", "anthocyanins", 0, 1e6, 1),
    TSU_I_FRAGMENT("Cbrown", "1", "brown pigments", 0, 1e6, 0),
    TSU_I_FRAGMENT("Cw", "cm", "water", 0, 1e6, 0.01),
    TSU_I_FRAGMENT("Cm", "g/cm2", "dry matter", 0, 1e6, 0.008),
    TSU_I_FRAGMENT("lambda_nm", "nm", "wavelength", 400, 780, 550)};

const tsu_value_info tsu_i_leaf_prospect_outputs[LEAF_PROSPECT_OUTPUTS] = {
    TSU_I_OUTPUT("R_leaf", "1", "directional-hemispherical reflectance, the surface's included"),
    TSU_I_OUTPUT("T_leaf", "1", "directional-hemispherical transmittance")};

void tsu_i_leaf_prospect(const double *in, double *out)
{
    const struct tsu_i_prospect leaf = {.N = in[0],
                                        .chlorophyll = in[1],
                                        .carotenoids = in[2],
                                        .anthocyanins = in[3],
                                        .brown = in[4],
                                        .water = in[5],
                                        .dry_matter = in[6]};
    tsu_i_prospect_leaf(&leaf, in[7], out, out + 1);
}

void tsu_i_leaf_prospect_params(const double *in, void *params)
{
    (void)in;
    (void)params;
}
