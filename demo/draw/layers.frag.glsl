// Fibres of a light's map, added up layer by layer. Hair in the head's shadow is left out: it gets no
// light and must not count as hair behind what is in front of the head.

in vec3 v_position;
uniform vec4 u_record[12];
uniform highp sampler2D u_map_front;
uniform vec4 u_light; // towards it, or with w = 1 its place
layout(location = 0) out vec4 o_layers;
layout(location = 1) out vec4 o_deeper;

void main()
{
    vec3 l = normalize(u_light.xyz - u_light.w * v_position);
    float cover = coverage() * (1.0 - blocked(v_position, l));
    if (cover <= 0.0) {
        discard;
    }
#ifdef FROM_FRONT
    tsu_deep_opacity_write(u_map_front, u_record, gl_FragCoord.xy, v_position, cover, o_layers,
                           o_deeper);
#else
    tsu_opacity_shadow_write(u_record, v_position, cover, o_layers, o_deeper);
#endif
}
