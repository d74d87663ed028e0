// The head that hair grows on, opaque to light.

uniform mat4 u_to_solid; // world to the space where the head is the unit sphere; 0: no head

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
    return along < 0.0 ? 1.0 - smoothstep(0.98, 1.02, nearest) : 0.0;
}
