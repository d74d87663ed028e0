// Lights with a place or a size on a surface, as points: too dim where one is many times wider than
// far away.

uniform int u_areas;        // the first lights may have a place or a size
uniform vec4 u_area[4 * 8]; // records of tsu_light_pack(); kind 0: a direction

// Number of samples of light i, and sample k: direction towards it and irradiance of a surface that
// faces that direction. A rectangle or a disk is 16 points of equal area.
int light_samples(int i)
{
    float kind = i < u_areas ? u_area[4 * i].w : 0.0;
    return kind > 1.5 && kind < 3.5 ? 16 : 1;
}

vec3 light_sample(int i, int k, vec3 position, out vec3 l)
{
    l = u_light_direction[i];
    float kind = i < u_areas ? u_area[4 * i].w : 0.0;
    if (kind < 0.5 || kind > 3.5) {
        return u_light_color[i];
    }
    vec4 color = u_area[4 * i + 3];
    vec3 to = u_area[4 * i].xyz - position;
    if (kind < 1.5) {
        float far = max(length(to), color.w);
        l = to / max(length(to), 1e-9);
        return color.rgb / (far * far);
    }
    vec3 x = u_area[4 * i + 1].xyz, y = u_area[4 * i + 2].xyz;
    vec2 at = (vec2(k % 4, k / 4) + 0.5) / 4.0;
    float area = 4.0 * length(x) * length(y);
    if (kind > 2.5) {
        float turn = 6.28318531 * at.y, r = sqrt(at.x);
        at = vec2(cos(turn), sin(turn)) * r;
        area *= 0.785398163;
    } else {
        at = 2.0 * at - 1.0;
    }
    to += x * at.x + y * at.y;
    float far = length(to);
    l = to / max(far, 1e-9);
    float facing = -dot(l, normalize(cross(x, y)));
    facing = u_area[4 * i + 2].w > 0.5 ? abs(facing) : max(facing, 0.0);
    area *= facing / 16.0;
    // A disk of this area, right in front of it: never more than it gives.
    return color.rgb * (area / max(far * far + area / 3.14159265, 1e-9));
}
