#include "hostile.h"

#include <stdio.h>
#include <string.h>

enum { ALL = 0, DESKTOP = 1, GL45 = 2, DEBUG = 3 };
enum { INTEGER, FLOAT };

struct query {
    const char *name;
    GLenum value;
    int kind, where, count;
};

#define Q(name, kind, where, count) {#name, name, kind, where, count}
#define I(name) {#name, name, INTEGER, ALL, 1}
#define S(name) {#name, name, INTEGER, DESKTOP, 1}

static const struct query queries[] = {
    // Bindings
    I(GL_ACTIVE_TEXTURE), I(GL_CURRENT_PROGRAM), I(GL_VERTEX_ARRAY_BINDING),
    I(GL_ARRAY_BUFFER_BINDING), I(GL_ELEMENT_ARRAY_BUFFER_BINDING), I(GL_COPY_READ_BUFFER_BINDING),
    I(GL_COPY_WRITE_BUFFER_BINDING), I(GL_PIXEL_PACK_BUFFER_BINDING),
    I(GL_PIXEL_UNPACK_BUFFER_BINDING), I(GL_UNIFORM_BUFFER_BINDING),
    I(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING), I(GL_DRAW_FRAMEBUFFER_BINDING),
    I(GL_READ_FRAMEBUFFER_BINDING), I(GL_RENDERBUFFER_BINDING), I(GL_DRAW_BUFFER0),
    I(GL_DRAW_BUFFER1), I(GL_DRAW_BUFFER2), I(GL_DRAW_BUFFER3), I(GL_READ_BUFFER),
    // Switches
    I(GL_BLEND), I(GL_CULL_FACE), I(GL_DEPTH_TEST), I(GL_DITHER), I(GL_POLYGON_OFFSET_FILL),
    I(GL_RASTERIZER_DISCARD), I(GL_SAMPLE_ALPHA_TO_COVERAGE), I(GL_SAMPLE_COVERAGE),
    I(GL_SCISSOR_TEST), I(GL_STENCIL_TEST), S(GL_COLOR_LOGIC_OP), S(GL_DEPTH_CLAMP),
    S(GL_FRAMEBUFFER_SRGB), S(GL_LINE_SMOOTH), S(GL_MULTISAMPLE), S(GL_POLYGON_SMOOTH),
    S(GL_PRIMITIVE_RESTART), S(GL_PROGRAM_POINT_SIZE), S(GL_TEXTURE_CUBE_MAP_SEAMLESS),
    // Pixel store
    I(GL_UNPACK_ALIGNMENT), I(GL_UNPACK_ROW_LENGTH), I(GL_UNPACK_SKIP_PIXELS),
    I(GL_UNPACK_SKIP_ROWS), I(GL_UNPACK_IMAGE_HEIGHT), I(GL_UNPACK_SKIP_IMAGES),
    I(GL_PACK_ALIGNMENT), I(GL_PACK_ROW_LENGTH), I(GL_PACK_SKIP_PIXELS), I(GL_PACK_SKIP_ROWS),
    S(GL_UNPACK_SWAP_BYTES), S(GL_UNPACK_LSB_FIRST), S(GL_PACK_IMAGE_HEIGHT),
    S(GL_PACK_SKIP_IMAGES), S(GL_PACK_SWAP_BYTES), S(GL_PACK_LSB_FIRST),
    // Fragments
    Q(GL_VIEWPORT, INTEGER, ALL, 4), Q(GL_SCISSOR_BOX, INTEGER, ALL, 4),
    Q(GL_COLOR_WRITEMASK, INTEGER, ALL, 4), I(GL_DEPTH_WRITEMASK), I(GL_DEPTH_FUNC),
    Q(GL_DEPTH_RANGE, FLOAT, ALL, 2), Q(GL_DEPTH_CLEAR_VALUE, FLOAT, ALL, 1),
    Q(GL_COLOR_CLEAR_VALUE, FLOAT, ALL, 4), I(GL_STENCIL_CLEAR_VALUE), I(GL_BLEND_SRC_RGB),
    I(GL_BLEND_DST_RGB), I(GL_BLEND_SRC_ALPHA), I(GL_BLEND_DST_ALPHA), I(GL_BLEND_EQUATION_RGB),
    I(GL_BLEND_EQUATION_ALPHA), Q(GL_BLEND_COLOR, FLOAT, ALL, 4), I(GL_STENCIL_FUNC),
    I(GL_STENCIL_REF), I(GL_STENCIL_VALUE_MASK), I(GL_STENCIL_FAIL), I(GL_STENCIL_PASS_DEPTH_FAIL),
    I(GL_STENCIL_PASS_DEPTH_PASS), I(GL_STENCIL_WRITEMASK), I(GL_STENCIL_BACK_FUNC),
    I(GL_STENCIL_BACK_REF), I(GL_STENCIL_BACK_VALUE_MASK), I(GL_STENCIL_BACK_FAIL),
    I(GL_STENCIL_BACK_PASS_DEPTH_FAIL), I(GL_STENCIL_BACK_PASS_DEPTH_PASS),
    I(GL_STENCIL_BACK_WRITEMASK), I(GL_CULL_FACE_MODE), I(GL_FRONT_FACE),
    Q(GL_LINE_WIDTH, FLOAT, ALL, 1), Q(GL_POLYGON_OFFSET_FACTOR, FLOAT, ALL, 1),
    Q(GL_POLYGON_OFFSET_UNITS, FLOAT, ALL, 1), Q(GL_SAMPLE_COVERAGE_VALUE, FLOAT, ALL, 1),
    I(GL_SAMPLE_COVERAGE_INVERT), S(GL_LOGIC_OP_MODE), Q(GL_POINT_SIZE, FLOAT, DESKTOP, 1),
    S(GL_POLYGON_MODE), S(GL_PRIMITIVE_RESTART_INDEX), S(GL_PROVOKING_VERTEX),
    I(GL_FRAGMENT_SHADER_DERIVATIVE_HINT), Q(GL_CLIP_ORIGIN, INTEGER, GL45, 1),
    Q(GL_CLIP_DEPTH_MODE, INTEGER, GL45, 1), Q(GL_DEBUG_GROUP_STACK_DEPTH, INTEGER, DEBUG, 1),
};

static const struct query unit_queries[] = {
    I(GL_TEXTURE_BINDING_2D), I(GL_TEXTURE_BINDING_2D_ARRAY), I(GL_TEXTURE_BINDING_3D),
    I(GL_TEXTURE_BINDING_CUBE_MAP), I(GL_SAMPLER_BINDING),
};

#define B(target) {"GL_BUFFER_SIZE of " #target, target, target##_BINDING}

static const struct {
    const char *name;
    GLenum target, binding;
} buffers[] = {
    B(GL_ARRAY_BUFFER),        B(GL_COPY_READ_BUFFER),          B(GL_COPY_WRITE_BUFFER),
    B(GL_PIXEL_PACK_BUFFER),   B(GL_PIXEL_UNPACK_BUFFER),       B(GL_UNIFORM_BUFFER),
    B(GL_ELEMENT_ARRAY_BUFFER), B(GL_TRANSFORM_FEEDBACK_BUFFER),
};

static const struct query texture_parameters[] = {
    I(GL_TEXTURE_MIN_FILTER), I(GL_TEXTURE_MAG_FILTER), I(GL_TEXTURE_WRAP_S),
    I(GL_TEXTURE_WRAP_T), I(GL_TEXTURE_WRAP_R), I(GL_TEXTURE_BASE_LEVEL),
    I(GL_TEXTURE_MAX_LEVEL), I(GL_TEXTURE_COMPARE_MODE), I(GL_TEXTURE_SWIZZLE_R),
};

static const struct query attribute_queries[] = {
    I(GL_VERTEX_ATTRIB_ARRAY_ENABLED), I(GL_VERTEX_ATTRIB_ARRAY_SIZE),
    I(GL_VERTEX_ATTRIB_ARRAY_STRIDE), I(GL_VERTEX_ATTRIB_ARRAY_TYPE),
    I(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING), I(GL_VERTEX_ATTRIB_ARRAY_DIVISOR),
};

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

// The tables above fill about 340 of the places.
static double *add(struct hostile_state *state, const char *name, int index)
{
    const int at = state->count < HOSTILE_VALUES ? state->count++ : HOSTILE_VALUES - 1;
    state->values[at].name = name;
    state->values[at].index = index;
    return state->values[at].value;
}

static int applies(const struct gl_api *gl, int where)
{
    switch (where) {
    case DESKTOP:
        return !gl->es;
    case GL45:
        return gl_at_least(gl, 0, 4, 5);
    case DEBUG:
        return gl_at_least(gl, 0, 4, 3) || gl_at_least(gl, 1, 3, 2);
    default:
        return 1;
    }
}

static void add_query(const struct gl_api *gl, struct hostile_state *state, const struct query *q,
                      int index)
{
    GLint integers[4] = {0, 0, 0, 0};
    GLfloat floats[4] = {0, 0, 0, 0};
    if (q->kind == INTEGER) {
        gl->GetIntegerv(q->value, integers);
    } else {
        gl->GetFloatv(q->value, floats);
    }
    double *value = add(state, q->name, index);
    for (int k = 0; k < q->count; k++) {
        value[k] = q->kind == INTEGER ? (double)integers[k] : (double)floats[k];
    }
}

static void add_units(const struct gl_api *gl, struct hostile_state *state)
{
    static const GLenum targets[] = {GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_3D};
    GLint active = 0;
    gl->GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (int unit = 0; unit < HOSTILE_UNITS; unit++) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        for (int i = 0; i < COUNT(unit_queries); i++) {
            add_query(gl, state, &unit_queries[i], unit);
        }
    }
    gl->ActiveTexture((GLenum)active);
    for (int t = 0; t < COUNT(targets); t++) {
        for (int i = 0; i < COUNT(texture_parameters); i++) {
            GLint value = 0;
            gl->GetTexParameteriv(targets[t], texture_parameters[i].value, &value);
            add(state, texture_parameters[i].name, t)[0] = value;
        }
    }
}

static void add_buffers(const struct gl_api *gl, struct hostile_state *state)
{
    for (int i = 0; i < COUNT(buffers); i++) {
        GLint bound = 0, size = 0;
        gl->GetIntegerv(buffers[i].binding, &bound);
        if (bound) {
            gl->GetBufferParameteriv(buffers[i].target, GL_BUFFER_SIZE, &size);
        }
        add(state, buffers[i].name, -1)[0] = size;
    }
    static const struct {
        const char *name;
        GLenum binding, start, size;
        int count;
    } points[] = {
        {"GL_UNIFORM_BUFFER_BINDING", GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START,
         GL_UNIFORM_BUFFER_SIZE, 16},
        {"GL_TRANSFORM_FEEDBACK_BUFFER_BINDING", GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
         GL_TRANSFORM_FEEDBACK_BUFFER_START, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, 4},
    };
    for (int p = 0; p < COUNT(points); p++) {
        for (int i = 0; i < points[p].count; i++) {
            GLint buffer = 0;
            GLint64 start = 0, size = 0;
            gl->GetIntegeri_v(points[p].binding, (GLuint)i, &buffer);
            gl->GetInteger64i_v(points[p].start, (GLuint)i, &start);
            gl->GetInteger64i_v(points[p].size, (GLuint)i, &size);
            double *value = add(state, points[p].name, i);
            value[0] = buffer;
            value[1] = (double)start;
            value[2] = (double)size;
        }
    }
}

void hostile_snapshot(const struct gl_api *gl, struct hostile_state *state)
{
    memset(state, 0, sizeof *state);
    add(state, "glGetError", -1)[0] = gl->GetError();
    for (int i = 0; i < COUNT(queries); i++) {
        if (applies(gl, queries[i].where)) {
            add_query(gl, state, &queries[i], -1);
        }
    }
    add_units(gl, state);
    add_buffers(gl, state);
    for (int a = 0; a < 4; a++) {
        for (int i = 0; i < COUNT(attribute_queries); i++) {
            GLint value = 0;
            gl->GetVertexAttribiv((GLuint)a, attribute_queries[i].value, &value);
            add(state, attribute_queries[i].name, a)[0] = value;
        }
    }
    GLint query = 0;
    gl->GetQueryiv(GL_ANY_SAMPLES_PASSED, GL_CURRENT_QUERY, &query);
    add(state, "GL_CURRENT_QUERY", -1)[0] = query;
    add(state, "glGetError after the snapshot", -1)[0] = gl->GetError();
}

int hostile_compare(const struct hostile_state *before, const struct hostile_state *after,
                    char *why, size_t why_size)
{
    why[0] = '\0';
    for (int i = 0; i < before->count; i++) {
        const double *b = before->values[i].value, *a = after->values[i].value;
        if (memcmp(b, a, sizeof before->values[i].value) != 0) {
            char where[24] = "";
            if (before->values[i].index >= 0) {
                snprintf(where, sizeof where, " of %d", before->values[i].index);
            }
            snprintf(why, why_size, "%s%s was %g %g %g %g and is %g %g %g %g",
                     before->values[i].name, where, b[0], b[1], b[2], b[3], a[0], a[1], a[2], a[3]);
            return 0;
        }
    }
    return 1;
}
