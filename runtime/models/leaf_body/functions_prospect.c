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

const tsu_value_info tsu_i_leaf_layers_inputs[LEAF_LAYERS_INPUTS] = {
    TSU_I_FRAGMENT("R_top", "1", "reflectance lit from above, at normal incidence", 0, 1, 0.13),
    TSU_I_FRAGMENT("R_bottom", "1", "reflectance lit from below", 0, 1, 0.182),
    TSU_I_FRAGMENT("T", "1", "transmittance", 0, 1, 0.127),
    TSU_I_FRAGMENT("n", "1", "refractive index", 1.2, 1.8, 1.45)};

const tsu_value_info tsu_i_leaf_layers_outputs[LEAF_LAYERS_OUTPUTS] = {
    TSU_I_OUTPUT("scatter_top", "1", "reduced scattering depth of the upper layer"),
    TSU_I_OUTPUT("absorption_top", "1", "absorption depth of the upper layer"),
    TSU_I_OUTPUT("scatter_bottom", "1", "reduced scattering depth of the lower layer"),
    TSU_I_OUTPUT("absorption_bottom", "1", "absorption depth of the lower layer"),
    TSU_I_OUTPUT("residual", "1", "largest difference to what was asked")};

tsu_status tsu_i_leaf_layers(const tsu_context *context, const double *in, void *scratch,
                             double *out)
{
    const struct tsu_i_leaf_question question = {
        .n = in[3], .g = LEAF_G, .faces = {in[0], in[1], in[2]}};
    struct tsu_i_leaf_inverse found;
    const tsu_status status = tsu_i_leaf_find(context, &question, scratch, &found);
    if (status != TSU_OK)
        return status;
    out[0] = found.layers.scatter_top;
    out[1] = found.layers.absorption_top;
    out[2] = found.layers.scatter_bottom;
    out[3] = found.layers.absorption_bottom;
    out[4] = found.residual;
    return TSU_OK;
}

void tsu_i_leaf_no_params(const double *in, void *params)
{
    (void)in;
    (void)params;
}
