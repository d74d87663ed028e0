// The shader that asks: a fragment of text, between the library's and nothing.
#ifndef TESTS_LIGHT_QUESTION_H
#define TESTS_LIGHT_QUESTION_H

// HAIR(t, l, v, sigma_a), FIBER and the library's text stand before this.
const char fragment[] = R"(
uniform int u_question, u_grid, u_white, u_fault, u_seed, u_disk;
uniform vec4 u_record[4], u_environment[9];
uniform vec3 u_position, u_centre, u_x, u_y, u_color;
uniform vec3 u_axis[3], u_shape[3]; // amplitude, sharpness
uniform float u_constant;
layout(location = 0) out vec4 o;

const vec3 Y = vec3(0.2126, 0.7152, 0.0722);
uint state;

float chance()
{
    state = state * 747796405u + 2891336453u;
    uint x = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float((x >> 22u) ^ x) / 4294967296.0;
}

vec3 direction()
{
    float z = 2.0 * chance() - 1.0, turn = 6.28318531 * chance();
    return vec3(sqrt(max(1.0 - z * z, 0.0)) * vec2(cos(turn), sin(turn)), z);
}

float radiance(vec3 d)
{
    float sum = u_constant;
    for (int k = 0; k < 3; k++) {
        sum += u_shape[k].x * exp(u_shape[k].y * (dot(d, u_axis[k]) - 1.0));
    }
    return sum;
}

vec3 t, v, sigma_a;
float front, behind, direct;

// Radiance by the snippet.
vec3 lit(vec3 position, out vec4 report)
{
    tsu_light light = tsu_light_begin(u_record, FIBER, position, t, v);
    vec3 sum = vec3(0.0);
    report = vec4(0.0, 0.0, 0.0, float(light.count));
    for (int i = 0; i < light.count; i++) {
        vec3 l;
        vec3 weight = tsu_light_sample(light, i, l);
        report.x += weight.y;
        report.z = max(report.z, abs(length(l) - 1.0));
        if (dot(weight, vec3(1.0)) > 0.0) {
            sum += weight * HAIR(t, l, v, sigma_a);
        }
    }
    report.y = dot(sum, Y);
    return sum;
}

// Radiance and solid angle by a grid on the light.
vec3 summed(out float angle)
{
    vec3 sum = vec3(0.0);
    float cell = (u_disk == 1 ? 3.14159265 : 4.0) / float(u_grid * u_grid);
    vec3 n = cross(u_x, u_y);
    angle = 0.0;
    for (int i = 0; i < u_grid; i++) {
        for (int j = 0; j < u_grid; j++) {
            vec2 at = (vec2(ivec2(i, j)) + 0.5) / float(u_grid);
            float turn = 6.28318531 * at.y;
            at = u_disk == 1 ? sqrt(at.x) * vec2(cos(turn), sin(turn)) : 2.0 * at - 1.0;
            vec3 p = u_centre + at.x * u_x + at.y * u_y - u_position;
            float near = inversesqrt(dot(p, p));
            float weight = cell * abs(dot(p, n)) * near * near * near;
            angle += weight;
            sum += weight * HAIR(t, p * near, v, sigma_a);
        }
    }
    return u_color * sum;
}

vec3 surrounded()
{
    vec3 u = tsu_light_across(t, v), w = cross(t, u), sum = vec3(0.0);
    for (int i = 0; i < 2 * u_grid; i++) {
        float theta = 3.14159265 * ((float(i) + 0.5) / float(2 * u_grid) - 0.5);
        for (int j = 0; j < 2 * u_grid; j++) {
            float phi = 3.14159265 * (float(j) + 0.5) / float(u_grid);
            vec3 l = t * sin(theta) + cos(theta) * (u * cos(phi) + w * sin(phi));
            sum += radiance(l) * cos(theta) * HAIR(t, l, v, sigma_a);
        }
    }
    return sum * 0.5 * pow(3.14159265 / float(u_grid), 2.0);
}

void main()
{
    state = uint(gl_FragCoord.x) + uint(gl_FragCoord.y) * 977u + uint(u_seed) * 104729u;
    for (int i = 0; i < 4; i++) {
        chance();
    }
    // Black, brown, blond and white hair.
    int hair = int(4.0 * chance());
    sigma_a = hair == 0   ? vec3(5.4)
              : hair == 1 ? vec3(0.49, 0.91, 1.96)
              : hair == 2 ? vec3(0.04, 0.09, 0.23)
                          : vec3(0.0);
    t = direction();
    v = direction();
    front = chance() < 0.5 ? 0.0 : 4.0 * chance();
    behind = 8.0 * chance();
    if (u_white == 1) {
        sigma_a = vec3(0.0);
        front = behind = 0.0;
    }
    direct = exp(-front);
    vec4 report;
    if (u_question == 0) {
        float angle;
        vec3 truth = summed(angle);
        vec3 sum = lit(u_position, report);
        o = vec4(dot(truth, Y), report.y, angle, report.x);
    } else if (u_question == 1) {
        vec3 sum = vec3(0.0);
        for (int i = 0; i < tsu_environment_count(u_environment); i++) {
            vec3 l;
            vec3 weight = tsu_environment_sample(u_environment, FIBER, t, v, i, l);
            sum += weight * HAIR(t, l, v, sigma_a);
        }
        float rest = dot(sum, Y);
        sum += lit(u_position, report);
        o = vec4(dot(surrounded(), Y), dot(sum, Y), rest, 1.0);
    } else {
        float nothing = uintBitsToFloat(0x7fc00000u + uint(max(u_seed - 1000000, 0)));
        vec3 position = u_position;
        t = u_fault == 1 ? normalize(u_centre - u_position) : t;      // along the strands
        v = u_fault == 2 ? t : u_fault == 3 ? -t : v;                 // seen along them
        position = u_fault == 4 ? u_centre : position;                // inside the light
        position = u_fault == 5 ? u_centre + 0.3 * u_x : position;    // in its plane
        position = u_fault == 6 ? u_centre + 3.0 * u_x : position;    // the same, outside
        position = u_fault == 7 ? vec3(nothing) : position;
        position = u_fault == 8 ? vec3(1e30) : position;
        t = u_fault == 9 ? vec3(nothing) : t;
        v = u_fault == 10 ? vec3(nothing) : v;
        lit(position, report);
        for (int i = 0; i < tsu_environment_count(u_environment); i++) {
            vec3 l;
            vec3 weight = tsu_environment_sample(u_environment, FIBER, t, v, i, l);
            report.z = max(report.z, u_fault == 9 ? 0.0 : abs(length(l) - 1.0));
        }
        o = report;
    }
}
)";

#endif
