// Hair's shadow on a fibre from one light: from its map when it has one, else from the grid.

const int MAPS = 8;

uniform int u_maps;                      // the first lights have maps
uniform int u_fixed_layers;              // 1: opacity shadow maps
uniform vec4 u_shadow[12 * MAPS];        // records
uniform highp sampler2D u_map_front;
uniform highp sampler2D u_map_layers;
uniform highp sampler2D u_map_deeper;
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

// Hair of which the head blocks a share of the light.
tsu_hair_shadow past_head(tsu_hair_shadow shadow, float head)
{
    shadow.front += OPAQUE * head;
    shadow.direct *= 1.0 - head;
    shadow.transmittance *= 1.0 - head;
    return shadow;
}

//   front, behind   fibres by the grid
tsu_hair_shadow shadow_of(int light, vec3 position, vec3 l, float front, float behind)
{
    if (light < u_maps) {
        return past_head(map_shadow(light, position), blocked(position, l));
    }
    tsu_hair_shadow shadow = tsu_hair_shadow_count(front, behind);
    shadow.transmittance = exp(-u_opacity * front);
    return past_head(shadow, blocked(position, l));
}

// What a model without multiple scattering is multiplied by: a fibre takes u_loss, not u_opacity.
vec3 passed(tsu_hair_shadow shadow)
{
    return pow(vec3(max(shadow.transmittance, 1e-30)), u_loss / u_opacity);
}
