// SPDX-License-Identifier: MIT
// From one tier of shading to another without a pop: which of two a pixel or a strand takes while
// `weight` goes from 0 (all `from`) to 1 (all `to`).
//
//   threshold = tsu_fade_pixel(gl_FragCoord.xy);   or tsu_fade_strand(id)
//   color = tsu_fade_takes(threshold, weight) ? tsu_fade_gain(gain) * <to> : <from>;
//
// One tier is evaluated a pixel. What has switched does not switch back while the weight grows, and
// the mean over N thresholds is the mix within 1/sqrt(N). `gain` is tsu_choose_match()'s factor that
// keeps the mean luminance, or 1. A weight outside [0, 1] is the nearest end, no number is 0.

// Threshold of a pixel in [0, 1): still on the screen, even over every few pixels, so that a filter
// over time or a blur takes it for the mix. Pixels side by side differ, and a GPU that runs them
// together pays for both tiers.
//   pixel  gl_FragCoord.xy; add a whole number of pixels a frame where frames are averaged
// Source: Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare"
// (interleaved gradient noise).
float tsu_fade_pixel(vec2 pixel)
{
    return fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715))));
}

// Threshold of a strand (or leaf) in [0, 1): still on the strand, the same as the C function
// tsu_fade_strand().
float tsu_fade_strand(uint strand)
{
    uint x = strand * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28u) + 4u)) ^ x) * 277803737u;
    x = (x >> 22u) ^ x;
    return float(x >> 8u) * (1.0 / 16777216.0);
}

bool tsu_fade_takes(float threshold, float weight)
{
    return threshold < weight;
}

// A factor to multiply by: 1 for what is none.
float tsu_fade_gain(float gain)
{
    return gain > 0.0 && gain < 1e6 ? gain : 1.0;
}

// The mix, for hosts that have both: weights 0 and 1 give exactly one of them.
vec3 tsu_fade(vec3 from, vec3 to, float weight, float gain)
{
    to *= tsu_fade_gain(gain);
    if (!(weight > 0.0))
        return from;
    return weight < 1.0 ? from + (to - from) * weight : to;
}
