// SPDX-License-Identifier: MIT
// Opacity shadow maps: layers of hair at fixed distances from the light.
//
// Source: Kim and Neumann 2001, "Opacity Shadow Maps", with layers as colour channels.

// Outputs of the pass "layers": what this fragment adds to the targets layers and deeper.
//   position  the fragment's, world
//   amount    share of the texel that the fibre covers
void tsu_opacity_shadow_write(vec4 record[12], vec3 position, float amount, out vec4 layers,
                              out vec4 deeper)
{
    float depth = tsu_hair_shadow_place(record, position).z;
    tsu_hair_shadow_add(record, position, depth, amount, layers, deeper);
}

// Shadow at a point, from maps of up to four layers: four fetches.
//   position  to shade, world; outside of the map there is no shadow
tsu_hair_shadow tsu_opacity_shadow_read(sampler2D layers, vec4 record[12], vec3 position)
{
    vec3 at = tsu_hair_shadow_place(record, position);
    ivec4 c = tsu_hair_shadow_texels(record, at.xy);
    vec4 w = tsu_hair_shadow_weights(at.xy);
    tsu_hair_shadow sum = tsu_hair_shadow(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; i++) {
        ivec2 texel = ivec2(i % 2 == 0 ? c.x : c.z, i < 2 ? c.y : c.w);
        tsu_hair_shadow_tap(record, at.z, texelFetch(layers, texel, 0),
                            vec4(0.0), w[i], sum);
    }
    return tsu_hair_shadow_sum(record, sum);
}

// Shadow at a point, from maps of up to eight layers: eight fetches.
//   position  to shade, world; outside of the map there is no shadow
tsu_hair_shadow tsu_opacity_shadow_read8(sampler2D layers, sampler2D deeper, vec4 record[12],
                                         vec3 position)
{
    vec3 at = tsu_hair_shadow_place(record, position);
    ivec4 c = tsu_hair_shadow_texels(record, at.xy);
    vec4 w = tsu_hair_shadow_weights(at.xy);
    tsu_hair_shadow sum = tsu_hair_shadow(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; i++) {
        ivec2 texel = ivec2(i % 2 == 0 ? c.x : c.z, i < 2 ? c.y : c.w);
        tsu_hair_shadow_tap(record, at.z, texelFetch(layers, texel, 0),
                            texelFetch(deeper, texel, 0), w[i], sum);
    }
    return tsu_hair_shadow_sum(record, sum);
}
