#include "hair_shadow/hair_shadow.h"

#include <math.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Unit vector along `v`, or +y for one too short to have a direction.
static void direction(const double v[3], double out[3])
{
    const double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        out[i] = length > 1e-12 ? v[i] / length : (i == 1 ? 1.0 : 0.0);
}

// A frame around `axis` that does not jump for small turns, but at one point: -z.
// Source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
static void frame(const double axis[3], double u[3], double v[3])
{
    const double sign = axis[2] < 0.0 ? -1.0 : 1.0;
    const double a = -1.0 / (sign + axis[2]), b = axis[0] * axis[1] * a;
    u[0] = 1.0 + sign * axis[0] * axis[0] * a;
    u[1] = sign * b;
    u[2] = -sign * axis[0];
    v[0] = b;
    v[1] = sign + axis[1] * axis[1] * a;
    v[2] = -axis[1];
}

// Where the light stands and what it sees.
struct view {
    double u[3], v[3], ahead[3]; // right, up, from the light into the hair
    double eye[3];               // place of the light, or a point on its plane
    double near, far;            // along `ahead` from `eye`
    double half;                 // half width of what it sees: at distance 1, or everywhere
    double width;                // full width at the centre of the hair
    int point, partial;
};

// Tangent of half the widest angle that a point light's map has: 76 degrees.
static const double widest = 4.0;

static struct view look(const tsu_hair_shadow_desc *desc)
{
    struct view view = {.point = (desc->flags & TSU_HAIR_SHADOW_POINT) != 0};
    // A little deeper than the sphere: fibres have a width.
    const double radius = 1.02 * (double)desc->radius, across = (double)desc->radius;
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = view.point ? (double)desc->centre[i] - (double)desc->light[i]
                            : -(double)desc->light[i];
    const double distance = sqrt(dot(way, way));
    direction(way, view.ahead);
    frame(view.ahead, view.u, view.v);
    if (view.point) {
        for (int i = 0; i < 3; i++)
            view.eye[i] = (double)desc->light[i];
        const double outside = distance * distance - across * across;
        const double tangent = outside > 0.0 ? across / sqrt(outside) : 2.0 * widest;
        view.partial = tangent > widest;
        view.half = view.partial ? widest : tangent;
        view.near = fmax(distance - radius, 0.01 * radius);
        view.far = distance + radius;
        view.width = 2.0 * view.half * fmax(distance, 0.5 * radius);
    } else {
        for (int i = 0; i < 3; i++)
            view.eye[i] = (double)desc->centre[i] - radius * view.ahead[i];
        view.half = across;
        view.far = 2.0 * radius;
        view.width = 2.0 * across;
    }
    return view;
}

// Row of an affine map: dot(v, p - eye) * scale + add * w, as a vec4 for (p, 1).
static void put_row(const struct view *view, const double v[3], double scale, double add, double w,
                    const double w_row[4], double out[4])
{
    for (int i = 0; i < 3; i++)
        out[i] = v[i] * scale;
    out[3] = -dot(v, view->eye) * scale + w;
    for (int i = 0; i < 4; i++)
        out[i] += add * w_row[i];
}

static void put_matrices(const tsu_hair_shadow_desc *desc, const struct view *view,
                         tsu_hair_shadow_plan *plan)
{
    static const double none[4] = {0};
    double w[4] = {0, 0, 0, 1}, x[4], y[4], z[4], distance[4];
    if (view->point)
        put_row(view, view->ahead, 1.0, 0.0, 0.0, none, w);
    put_row(view, view->u, 1.0 / view->half, 0.0, 0.0, none, x);
    put_row(view, view->v, 1.0 / view->half, 0.0, 0.0, none, y);
    put_row(view, view->ahead, 1.0, 0.0, -view->near, none, distance);
    // Stored depth is far (e - near) / (e (far - near)) with the light's distance e, or linear.
    const double depth = view->far - view->near;
    const double to_z = (view->point ? view->far : 1.0) / depth;
    const int zero_to_one = (desc->flags & TSU_HAIR_SHADOW_ZERO_TO_ONE) != 0;
    for (int i = 0; i < 4; i++) {
        z[i] = zero_to_one ? to_z * distance[i] : 2.0 * to_z * distance[i] - w[i];
        plan->to_light[4 * i] = (float)x[i];
        plan->to_light[4 * i + 1] = (float)y[i];
        plan->to_light[4 * i + 2] = (float)z[i];
        plan->to_light[4 * i + 3] = (float)w[i];
        const double half = 0.5 * plan->size;
        plan->record[TSU_I_SHADOW_X + i] = (float)(half * (x[i] + w[i]));
        plan->record[TSU_I_SHADOW_Y + i] = (float)(half * (y[i] + w[i]));
        plan->record[TSU_I_SHADOW_W + i] = (float)w[i];
        plan->record[TSU_I_SHADOW_DISTANCE + i] = (float)distance[i];
    }
    float *stored = plan->record + TSU_I_SHADOW_STORED;
    stored[0] = (float)(view->point ? view->near * depth : depth);
    stored[2] = (float)(view->point ? -depth : 0.0);
    stored[3] = (float)(view->point ? view->far : 1.0);
}

static void put_layers(const struct tsu_i_shadow_params *params, double depth,
                       tsu_hair_shadow_plan *plan)
{
    // With eight layers behind the first fibre 1.6 had the least error in straight, wavy and curly
    // hair; fewer layers must grow faster to be as thin in front.
    const double chosen = params->from_front ? 1.0 + 4.8 / (double)params->layers : 1.0;
    const double growth = params->growth > 0.0f ? (double)params->growth : chosen;
    double sum = 0.0, part = 1.0;
    plan->layers = (uint32_t)params->layers;
    for (uint32_t k = 0; k < plan->layers; k++, part *= growth)
        sum += part;
    double begin = 0.0;
    part = depth / sum;
    for (uint32_t k = 0; k < TSU_HAIR_SHADOW_LAYERS; k++, part *= growth) {
        float *scale = plan->record + TSU_I_SHADOW_SCALE + k;
        float *offset = plan->record + TSU_I_SHADOW_OFFSET + k;
        if (k >= plan->layers) {
            *scale = 0.0f;
            *offset = -1.0f; // no distance reaches it
            plan->boundary[k + 1] = (float)depth;
            continue;
        }
        *scale = (float)(1.0 / part);
        *offset = (float)(-begin / part);
        begin += part;
        plan->boundary[k + 1] = (float)begin;
    }
}

// Texels at both sides together into which no fibre of the sphere reaches: a read outside of the map
// is clamped to them.
static const double border = 3.0;

static uint32_t chosen_size(const tsu_hair_shadow_desc *desc, double width, double texel)
{
    if (desc->size)
        return desc->size;
    const double size = texel > 0.0 ? ceil(width / texel) + border : 0.0;
    return size < desc->least_size  ? desc->least_size
           : size > desc->most_size ? desc->most_size
                                    : (uint32_t)size;
}

void tsu_i_shadow_plan(const tsu_hair_shadow_desc *desc, const struct tsu_i_shadow_params *params,
                       tsu_hair_shadow_plan *plan)
{
    struct view view = look(desc);
    const double radius = (double)desc->radius;
    const double sphere = 4.18879020478639 * radius * radius * radius;
    const double volume = desc->volume > 0.0f ? (double)desc->volume : 0.15 * sphere;
    const int empty = !(desc->length > 0.0f && desc->width > 0.0f);
    const double spacing = desc->spacing > 0.0f ? (double)desc->spacing
                           : empty              ? 0.0
                                                : sqrt(volume / (double)desc->length);
    plan->flags = (empty ? TSU_HAIR_SHADOW_EMPTY : 0u) |
                  (view.partial ? TSU_HAIR_SHADOW_PARTIAL : 0u);
    plan->size = chosen_size(desc, view.width, (double)params->spacings * spacing);
    const double wider = plan->size / (plan->size - border);
    view.half *= wider;
    view.width *= wider;
    plan->spacing = (float)spacing;
    plan->texel = (float)(view.width / plan->size);
    plan->near_plane = (float)view.near;
    plan->far_plane = (float)view.far;
    plan->opacity = params->opacity;
    plan->color = desc->flags & TSU_HAIR_SHADOW_BLEND_32F   ? TSU_FORMAT_RGBA32F
                  : desc->flags & TSU_HAIR_SHADOW_BLEND_16F ? TSU_FORMAT_RGBA16F
                                                            : TSU_FORMAT_RGBA8;
    put_matrices(desc, &view, plan);
    put_layers(params, view.far - view.near, plan);

    float *tile = plan->record + TSU_I_SHADOW_TILE;
    tile[0] = (float)desc->tile_x;
    tile[1] = (float)desc->tile_y;
    tile[2] = (float)plan->size;
    tile[3] = 1.0f / (float)plan->size;
    float *opacity = plan->record + TSU_I_SHADOW_OPACITY;
    const int bytes = plan->color == TSU_FORMAT_RGBA8;
    opacity[0] = params->opacity;
    opacity[1] = bytes ? 32.0f : 1.0f;
    opacity[2] = bytes ? 32.0f / 255.0f : 0.0f;
    opacity[3] = (float)(view.far - view.near);

    plan->target_count = (plan->layers > 4 ? 2u : 1u) + (params->from_front ? 1u : 0u);
    plan->pass_count = params->from_front ? 2u : 1u;
}

int tsu_i_shadow_from_front(const tsu_hair_shadow_plan *plan)
{
    return plan->pass_count == 2;
}
