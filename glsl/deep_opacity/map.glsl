// SPDX-License-Identifier: MIT
// Deep opacity maps: layers of hair behind the first fibre of each texel.
//
// Source: Yuksel and Keyser 2008, "Deep Opacity Maps". A layer holds its own fibres alone, where
// the paper adds a fragment to all layers behind it: the same sums, of smaller numbers.

// Outputs of the pass "layers": what this fragment adds to the targets layers and deeper.
//   front     the map of the pass before
//   texel     the fragment's place in the target, gl_FragCoord.xy
//   position  the fragment's, world
//   amount    share of the texel that the fibre covers
void tsu_deep_opacity_write(sampler2D front, vec4 record[12], vec2 texel, vec3 position,
                            float amount, out vec4 layers, out vec4 deeper)
{
    float depth = tsu_hair_shadow_place(record, position).z -
                  tsu_hair_shadow_stored(record, texelFetch(front, ivec2(texel), 0).x);
    tsu_hair_shadow_add(record, position, depth, amount, layers, deeper);
}

// Shadow at a point, from maps of up to four layers: eight fetches.
//   position  to shade, world; outside of the map there is no shadow
tsu_hair_shadow tsu_deep_opacity_read(sampler2D front, sampler2D layers, vec4 record[12],
                                      vec3 position)
{
    vec3 at = tsu_hair_shadow_place(record, position);
    ivec4 c = tsu_hair_shadow_texels(record, at.xy);
    vec4 w = tsu_hair_shadow_weights(at.xy);
    tsu_hair_shadow sum = tsu_hair_shadow(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; i++) {
        ivec2 texel = ivec2(i % 2 == 0 ? c.x : c.z, i < 2 ? c.y : c.w);
        float first = tsu_hair_shadow_stored(record, texelFetch(front, texel, 0).x);
        tsu_hair_shadow_tap(record, at.z - first, texelFetch(layers, texel, 0),
                            vec4(0.0), w[i], sum);
    }
    return tsu_hair_shadow_sum(record, sum);
}

// Shadow at a point, from maps of up to eight layers: twelve fetches.
//   position  to shade, world; outside of the map there is no shadow
tsu_hair_shadow tsu_deep_opacity_read8(sampler2D front, sampler2D layers, sampler2D deeper,
                                       vec4 record[12], vec3 position)
{
    vec3 at = tsu_hair_shadow_place(record, position);
    ivec4 c = tsu_hair_shadow_texels(record, at.xy);
    vec4 w = tsu_hair_shadow_weights(at.xy);
    tsu_hair_shadow sum = tsu_hair_shadow(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; i++) {
        ivec2 texel = ivec2(i % 2 == 0 ? c.x : c.z, i < 2 ? c.y : c.w);
        float first = tsu_hair_shadow_stored(record, texelFetch(front, texel, 0).x);
        tsu_hair_shadow_tap(record, at.z - first, texelFetch(layers, texel, 0),
                            texelFetch(deeper, texel, 0), w[i], sum);
    }
    return tsu_hair_shadow_sum(record, sum);
}
