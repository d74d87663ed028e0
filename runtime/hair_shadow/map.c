// The maps in memory, in the shader's arithmetic.
#include "hair_shadow/hair_shadow.h"

#include <math.h>
#include <string.h>

struct map {
    const tsu_hair_shadow_plan *plan;
    int size;
    float to_texels; // of one world unit at w = 1
    float *front;    // distance of the first fibre behind the near plane
    float *layers;   // image after image
};

// A segment in the map, in texels, with its distances behind the near plane.
struct ribbon {
    float x, y, along[2], length, half;
    float sides[2];    // absolute components of `along`, the greater first
    float w[2], at[2]; // of both ends
};

static float row(const float *r, const float *p)
{
    return r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3];
}

static float clamp01(float x)
{
    return x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x;
}

static struct map open(const tsu_hair_shadow_plan *plan, float *texels)
{
    const size_t area = (size_t)plan->size * plan->size;
    const float *x = plan->record + TSU_I_SHADOW_X, *w = plan->record + TSU_I_SHADOW_W;
    const float half = 0.5f * (float)plan->size;
    float sum = 0.0f;
    for (int i = 0; i < 3; i++)
        sum += (x[i] - half * w[i]) * (x[i] - half * w[i]);
    return (struct map){plan, (int)plan->size, sqrtf(sum), texels, texels + area};
}

// Share of a unit square on one side of a line at distance x from its centre. The square's shadow
// on the line's normal is a trapezoid.
static float side_of(float x, const float sides[2])
{
    const float outer = 0.5f * (sides[0] + sides[1]), inner = 0.5f * (sides[0] - sides[1]);
    const float y = fminf(fabsf(x), outer), rest = outer - y;
    const float h = y < inner ? y / sides[0]
                              : 0.5f - rest * rest / (2.0f * sides[0] * fmaxf(sides[1], 1e-5f));
    return 0.5f + copysignf(h, x);
}

// 0 for a segment that covers nothing: not finite, behind a point light, or along its light.
static int set_ribbon(const struct map *map, const float *a, const float *b, struct ribbon *r)
{
    const float *record = map->plan->record, *ends[2] = {a, b};
    const float least = 1e-3f * map->plan->near_plane;
    float x[2], y[2];
    for (int i = 0; i < 2; i++) {
        r->w[i] = row(record + TSU_I_SHADOW_W, ends[i]);
        if (!(r->w[i] > least))
            return 0;
        x[i] = row(record + TSU_I_SHADOW_X, ends[i]) / r->w[i];
        y[i] = row(record + TSU_I_SHADOW_Y, ends[i]) / r->w[i];
        r->at[i] = row(record + TSU_I_SHADOW_DISTANCE, ends[i]);
    }
    const float dx = x[1] - x[0], dy = y[1] - y[0];
    r->length = sqrtf(dx * dx + dy * dy);
    r->half = 0.25f * (a[3] / r->w[0] + b[3] / r->w[1]) * map->to_texels;
    if (!(r->length > 1e-6f && r->length < 1e6f && r->half >= 0.0f && r->half < 1e6f))
        return 0;
    r->x = x[0];
    r->y = y[0];
    r->along[0] = dx / r->length;
    r->along[1] = dy / r->length;
    r->sides[0] = fmaxf(fabsf(r->along[0]), fabsf(r->along[1]));
    r->sides[1] = fminf(fabsf(r->along[0]), fabsf(r->along[1]));
    return 1;
}

// Share of a texel that the ribbon covers, and how far behind the near plane it does.
static float share(const struct ribbon *r, int x, int y, float *distance)
{
    const float px = (float)x + 0.5f - r->x, py = (float)y + 0.5f - r->y;
    const float across = r->along[0] * py - r->along[1] * px;
    const float along = r->along[0] * px + r->along[1] * py;
    const float covered = side_of(across + r->half, r->sides) - side_of(across - r->half, r->sides);
    const float ends = side_of(along, r->sides) + side_of(r->length - along, r->sides) - 1.0f;
    // Linear in the world, not on the map: perspective's weights.
    const float t = clamp01(along / r->length);
    const float u = t * r->w[0] / (t * r->w[0] + (1.0f - t) * r->w[1]);
    *distance = r->at[0] + (r->at[1] - r->at[0]) * u;
    return fmaxf(covered, 0.0f) * fmaxf(ends, 0.0f);
}

static int layer_of(const tsu_hair_shadow_plan *plan, float depth)
{
    int layer = 0;
    while (layer + 1 < (int)plan->layers && depth >= plan->boundary[layer + 1])
        layer++;
    return layer;
}

static int clamped(float x, int last)
{
    return x < 0.0f ? 0 : x > (float)last ? last : (int)x;
}

static void draw(const struct map *map, const struct ribbon *r, int front_pass)
{
    const float reach = r->half + 1.0f;
    const float x1 = r->x + r->along[0] * r->length, y1 = r->y + r->along[1] * r->length;
    const int last = map->size - 1;
    const int begin = clamped(fminf(r->y, y1) - reach, last);
    const int end = clamped(fmaxf(r->y, y1) + reach, last);
    const int left = clamped(fminf(r->x, x1) - reach, last);
    const int right = clamped(fmaxf(r->x, x1) + reach, last);
    const int from_front = tsu_i_shadow_from_front(map->plan);
    const size_t area = (size_t)map->size * (size_t)map->size;
    for (int y = begin; y <= end; y++)
        for (int x = left; x <= right; x++) {
            float distance;
            const float amount = share(r, x, y, &distance);
            if (!(amount > 0.0f))
                continue;
            const size_t texel = (size_t)y * (size_t)map->size + (size_t)x;
            if (front_pass) {
                map->front[texel] = fminf(map->front[texel], fmaxf(distance, 0.0f));
                continue;
            }
            const float depth = from_front ? distance - map->front[texel] : distance;
            map->layers[area * (size_t)layer_of(map->plan, depth) + texel] += amount;
        }
}

void tsu_i_shadow_write(const tsu_hair_shadow_plan *plan, const float *points,
                        const uint32_t *first, uint32_t strands, float *texels)
{
    const struct map map = open(plan, texels);
    const size_t area = (size_t)plan->size * plan->size;
    for (size_t i = 0; i < area; i++)
        map.front[i] = plan->record[TSU_I_SHADOW_OPACITY + 3];
    memset(map.layers, 0, area * plan->layers * sizeof *map.layers);
    for (int pass = tsu_i_shadow_from_front(plan) ? 1 : 0; pass >= 0; pass--)
        for (uint32_t s = 0; s < strands; s++)
            for (size_t i = first[s]; i + 1 < first[s + 1]; i++) {
                struct ribbon ribbon;
                if (set_ribbon(&map, points + 4 * i, points + 4 * i + 4, &ribbon))
                    draw(&map, &ribbon, pass);
            }
}

// One texel's answer, added with its weight. Outermost texels, which hold no hair, stand for what is
// outside.
static void tap(const struct map *map, float column, float line, float distance, float weight,
                float sum[4])
{
    const float *record = map->plan->record;
    const size_t area = (size_t)map->size * (size_t)map->size;
    const int x = clamped(column, map->size - 1), y = clamped(line, map->size - 1);
    const size_t texel = (size_t)y * (size_t)map->size + (size_t)x;
    const float depth = tsu_i_shadow_from_front(map->plan) ? distance - map->front[texel]
                                                           : distance;
    float front = 0.0f, all = 0.0f;
    for (uint32_t k = 0; k < map->plan->layers; k++) {
        const float amount = map->layers[area * k + texel];
        front += amount * clamp01(depth * record[TSU_I_SHADOW_SCALE + k] +
                                  record[TSU_I_SHADOW_OFFSET + k]);
        all += amount;
    }
    sum[0] += weight * front;
    sum[1] += weight * fmaxf(all - front, 0.0f);
    sum[2] += weight * expf(-front);
    sum[3] += weight * expf(-map->plan->opacity * front);
}

void tsu_i_shadow_read(const tsu_hair_shadow_plan *plan, const float *texels,
                       const float position[3], float shadow[4])
{
    const float none[4] = {0.0f, (float)TSU_HAIR_SHADOW_UNKNOWN, 1.0f, 1.0f};
    // The map is only read; one struct serves both ways.
    const struct map map = open(plan, (float *)(uintptr_t)texels);
    const float w = row(plan->record + TSU_I_SHADOW_W, position);
    const float x = row(plan->record + TSU_I_SHADOW_X, position) / w - 0.5f;
    const float y = row(plan->record + TSU_I_SHADOW_Y, position) / w - 0.5f;
    const float distance = row(plan->record + TSU_I_SHADOW_DISTANCE, position);
    memcpy(shadow, none, sizeof none);
    if (!(w > 0.0f && fabsf(x) < 16384.0f && fabsf(y) < 16384.0f && fabsf(distance) < 1e30f))
        return;
    const float column = floorf(x), line = floorf(y), fx = x - column, fy = y - line;
    memset(shadow, 0, sizeof none);
    for (int i = 0; i < 4; i++)
        tap(&map, column + (float)(i & 1), line + (float)(i >> 1), distance,
            (i & 1 ? fx : 1.0f - fx) * (i >> 1 ? fy : 1.0f - fy), shadow);
}
