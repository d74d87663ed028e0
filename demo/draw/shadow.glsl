// Hair's shadow on a fibre from one light: from its map when it has one, else from the grid.

const int MAPS = 8;

uniform int u_maps;                      // the first lights have maps
uniform int u_fixed_layers;              // 1: opacity shadow maps
uniform vec4 u_shadow[12 * MAPS];        // records
uniform highp sampler2D u_map_front;
uniform highp sampler2D u_map_layers;
uniform highp sampler2D u_map_deeper;
uniform mat4 u_to_solid;  // world to the space where the head is the unit sphere; 0: no head
uniform float u_opacity;  // share of light that a fibre takes, mean of u_loss

// Fibres that the head counts as.
const float OPAQUE = 64.0;

tsu_hair_shadow map_shadow(int light, vec3 position)
{
    vec4 record[12];
    for (int j = 0; j < 12; j++) {
        record[j] = u_shadow[12 * light + j];
    }
    return u_fixed_layers == 1
               ? tsu_opacity_shadow_read8(u_map_layers, u_map_deeper, record, position)
               : tsu_deep_opacity_read8(u_map_front, u_map_layers, u_map_deeper, record, position);
}

// Share of the way to the light that the head blocks, softly at its rim.
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
    return along < 0.0 ? 1.0 - smoothstep(0.9, 1.1, nearest) : 0.0;
}

//   front, behind   fibres by the grid
tsu_hair_shadow shadow_of(int light, vec3 position, vec3 l, float front, float behind)
{
    if (light >= u_maps) {
        tsu_hair_shadow shadow = tsu_hair_shadow_count(front, behind);
        shadow.transmittance = exp(-u_opacity * front);
        return shadow;
    }
    tsu_hair_shadow shadow = map_shadow(light, position);
    float head = blocked(position, l);
    shadow.front += OPAQUE * head;
    shadow.direct *= 1.0 - head;
    shadow.transmittance *= 1.0 - head;
    return shadow;
}

// What a model without multiple scattering is multiplied by: a fibre takes u_loss, not u_opacity.
vec3 passed(tsu_hair_shadow shadow)
{
    return pow(vec3(max(shadow.transmittance, 1e-30)), u_loss / u_opacity);
}
