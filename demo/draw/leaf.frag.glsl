// A leaf's radiance towards the camera: both sides, with the maps' relief.

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;
in vec2 v_factors;
in vec3 v_crown;
uniform vec3 u_eye;
uniform highp sampler2D u_maps; // pigment, thickness, slopes of the relief
uniform float u_roundness;      // how far normals bend towards the crown's, [0, 1]
out vec4 o_color;               // alpha: share of the pixel that leaves cover

// The shading normal of the upper side: the mesh's, tilted by the relief, then bent towards the
// crown's on its own side. Nothing here decides which side is lit: that is the geometric normal's.
vec3 shading_normal(vec2 slope)
{
    vec3 n = normalize(v_normal);
    // Tangents that cancel between vertices leave no frame, and the mesh's normal.
    vec3 t = v_tangent.xyz - n * dot(n, v_tangent.xyz);
    float size = dot(t, t);
    t = size > 1e-8 ? t * inversesqrt(size) : vec3(0.0);
    vec3 b = v_tangent.w * cross(n, t);
    n = normalize(n - t * slope.x - b * slope.y);
    vec3 crown = dot(v_crown, n) < 0.0 ? -v_crown : v_crown;
    return normalize(mix(n, crown, u_roundness));
}

void main()
{
    vec4 map = texture(u_maps, v_uv);
    float pigment = map.x * v_factors.x, thickness = map.y * v_factors.y;
    vec3 v = normalize(u_eye - v_position);
    // Of the triangle, on the upper side.
    vec3 face = normalize(cross(dFdx(v_position), dFdy(v_position)));
    bool above = gl_FrontFacing;
    face = (dot(face, v) < 0.0) == above ? -face : face;
    vec3 n = shading_normal(map.zw);

    vec3 side = above ? n : -n;
    // A normal that is bent past the horizon of the view would show the other side.
    float past = dot(side, v);
    vec3 seen = past < 0.05 ? normalize(side + v * (0.05 - past)) : side;
    vec3 sum = leaf_sky_light(seen, above, v, pigment, thickness, sky_mean(v_position, side),
                              sky_mean(v_position, -side));
    for (int i = 0; i < u_lights; i++) {
        vec3 share = light_share(i, v_position, face, u_light_direction[i]);
        if (max(share.r, max(share.g, share.b)) <= 0.0) {
            continue;
        }
        for (int k = 0; k < light_samples(i); k++) {
            vec3 l;
            vec3 color = light_sample(i, k, v_position, l);
            sum += share * color * leaf_light(n, face, l, v, pigment, thickness);
        }
    }
    o_color = vec4(sum, 1.0);
}
