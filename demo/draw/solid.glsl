// The head that hair grows on, opaque to light.

uniform mat4 u_to_solid; // world to the space where the head is the unit sphere; 0: no head

// The neck in that space: centre and one over the half axes in x and z, y of its ends; 0: none.
uniform vec4 u_neck;
uniform vec2 u_neck_span;

// An upright elliptic cylinder. As with the sphere, a way that leads out of it is free.
float neck_blocked(vec3 p, vec3 d)
{
    vec2 q = (p.xz - u_neck.xy) * u_neck.zw, e = d.xz * u_neck.zw;
    float size = dot(e, e), along = dot(q, e);
    if (size <= 1e-12 || along >= 0.0) {
        return 0.0;
    }
    float y = p.y - along / size * d.y;
    float inside = step(u_neck_span.x, y) * step(y, u_neck_span.y);
    return inside * (1.0 - smoothstep(0.96, 1.04, dot(q, q) - along * along / size));
}

// Share of the way from `position` to the light that the head blocks: none or all, but for the rim.
// A sphere bulges, so that hair on its surface is in its shadow only where the way leads into it.
float blocked(vec3 position, vec3 l)
{
    vec3 p = (u_to_solid * vec4(position, 1.0)).xyz;
    vec3 d = mat3(u_to_solid) * l;
    float size = dot(d, d);
    if (size <= 0.0) {
        return 0.0;
    }
    float along = dot(p, d);
    float nearest = dot(p, p) - along * along / size;
    float head = along < 0.0 ? 1.0 - smoothstep(0.98, 1.02, nearest) : 0.0;
    return max(head, neck_blocked(p, d));
}
