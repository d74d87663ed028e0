// Fibres of a light's map, added up layer by layer.

in vec3 v_position;
uniform vec4 u_record[12];
uniform highp sampler2D u_map_front;
layout(location = 0) out vec4 o_layers;
layout(location = 1) out vec4 o_deeper;

void main()
{
    float cover = coverage();
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
