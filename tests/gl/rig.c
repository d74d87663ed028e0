#include "rig.h"

#include "base/half.h"
#include "base/host.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct rig rig;

static struct tsu_context context;
static struct hostile host;
static struct hostile_state before, after;

static void *allocate(void *user, void *pointer, size_t old_size, size_t size)
{
    (void)user;
    if (size && ++rig.allocations == rig.fail_at)
        return NULL;
    rig.live += size - old_size;
    if (size)
        return realloc(pointer, size);
    free(pointer);
    return NULL;
}

static void remember(void *user, int32_t level, int32_t code, const char *text)
{
    (void)user;
    (void)level;
    rig.lines++;
    rig.code = code;
    snprintf(rig.last, sizeof rig.last, "%s", text);
}

int rig_open(int argc, char **argv)
{
    if (!fixture_open(&rig.fixture, argc, argv))
        return 0;
    counted_open(offscreen_proc, rig.fixture.context);
    context.desc.allocate = allocate;
    context.desc.log = remember;
    rig.context = &context;
    return 1;
}

int rig_close(void)
{
    return fixture_close(&rig.fixture);
}

int rig_reset(void **state)
{
    (void)state;
    counted_reset();
    rig.allocations = rig.fail_at = rig.lines = 0;
    rig.last[0] = '\0';
    rig.code = 0;
    return 0;
}

int rig_pretend(int es, int version)
{
    static char text[64];
    if (!gl_at_least(&rig.fixture.gl, es, version / 10, version % 10))
        return 0;
    snprintf(text, sizeof text, es ? "OpenGL ES %d.%d pretended" : "%d.%d pretended", version / 10,
             version % 10);
    counted.fake_version = 1;
    counted.version = text;
    return 1;
}

tsu_status rig_create(uint32_t flags, tsu_gl **out)
{
    tsu_gl_desc desc;
    assert_int_equal(tsu_gl_desc_init(&desc), TSU_OK);
    desc.flags = flags;
    desc.get_proc_address = counted_proc;
    return tsu_gl_create(rig.context, &desc, out);
}

tsu_gl *rig_gl(void)
{
    tsu_gl *gl = NULL;
    assert_int_equal(rig_create(0, &gl), TSU_OK);
    assert_non_null(gl);
    return gl;
}

GLuint rig_program(const char *body)
{
    char source[2048];
    snprintf(source, sizeof source, "%s%s", rig.fixture.version, body);
    const GLuint program = fixture_program(&rig.fixture, NULL, source);
    assert_int_not_equal(program, 0);
    return program;
}

void rig_check_error(void)
{
    assert_int_equal(rig.fixture.gl.GetError(), GL_NO_ERROR);
}

void rig_sync(tsu_gl *gl, const tsu_set *set)
{
    counted_reset();
    rig.allocations = 0;
    assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
    assert_int_equal(rig.allocations, 0);
    assert_int_equal(counted.gets, 0);
}

void rig_check_unchanged(tsu_gl *gl, tsu_set *set)
{
    set->describe_calls = set->read_calls = 0;
    rig_sync(gl, set);
    assert_int_equal(counted.calls, 0);
    assert_int_equal(set->describe_calls, 1);
    assert_int_equal(set->read_calls, 0);
}

static float *draw(GLuint program, int width, int height)
{
    struct fixture_target target;
    float *const out = malloc((size_t)width * (size_t)height * 4 * sizeof *out);
    assert_non_null(out);
    rig.fixture.gl.ActiveTexture(GL_TEXTURE0);
    assert_true(fixture_target_create(&rig.fixture, &target, width, height));
    fixture_draw(&rig.fixture, program, &target);
    fixture_read(&rig.fixture, &target, out);
    fixture_target_destroy(&rig.fixture, &target);
    return out;
}

// A not-a-number stays one, but hardware may change its payload on the way through a shader.
static void compare_texels(const tsu_set *set, const float *seen)
{
    for (size_t i = 0; i < (size_t)4 * set->width * set->height; i++) {
        const float wanted = tsu_i_half_float(set->texels[i]);
        if (isnan(wanted) ? !isnan(seen[i]) : memcmp(&wanted, &seen[i], sizeof wanted) != 0)
            fail_msg("texel %u of %u x %u, channel %u: %a in GL, %a in the set", (unsigned)(i / 4),
                     set->width, set->height, (unsigned)(i % 4), (double)seen[i], (double)wanted);
    }
}

void rig_check(tsu_gl *gl, const tsu_set *set)
{
    const struct gl_api *const api = &rig.fixture.gl;
    const GLuint texels =
        rig_program("uniform sampler2D tsu_tables; out vec4 o;\n"
                    "void main() { o = texelFetch(tsu_tables, ivec2(gl_FragCoord.xy), 0); }\n");
    const GLuint page = rig_program(
        "layout(std140) uniform tsu_materials { vec4 tsu_page[1024]; }; out vec4 o;\n"
        "void main() { o = tsu_page[int(gl_FragCoord.x) + 256 * int(gl_FragCoord.y)]; }\n");
    assert_int_equal(tsu_gl_program_setup(gl, texels, RIG_UNIT, RIG_BINDING), TSU_OK);
    assert_int_equal(tsu_gl_program_setup(gl, page, RIG_UNIT, RIG_BINDING), TSU_OK);
    const uint32_t step = set->page_count / 16 + 1;
    for (uint32_t i = 0; i < set->page_count; i += step) {
        assert_int_equal(tsu_gl_bind(gl, i, RIG_UNIT, RIG_BINDING), TSU_OK);
        float *const seen = draw(page, 256, 4);
        assert_memory_equal(seen, set->pages + (size_t)i * set->page_stride, TSU_PAGE_BYTES);
        free(seen);
    }
    if (set->width) {
        float *const seen = draw(texels, (int)set->width, (int)set->height);
        compare_texels(set, seen);
        free(seen);
    }
    api->UseProgram(0);
    api->DeleteProgram(texels);
    api->DeleteProgram(page);
    rig_check_bytes(gl, set);
    rig_check_error();
}

void rig_check_bytes(const tsu_gl *gl, const tsu_set *set)
{
    const struct gl_api *const api = &rig.fixture.gl;
    tsu_gl_bindings_info info = {.struct_size = sizeof info};
    for (uint32_t i = 0; i < set->page_count; i++) {
        assert_int_equal(tsu_gl_bindings(gl, i, &info), TSU_OK);
        assert_int_equal(info.offset, (uint64_t)i * TSU_PAGE_BYTES);
        assert_int_equal(info.size, TSU_PAGE_BYTES);
        api->BindBuffer(GL_COPY_READ_BUFFER, info.buffer);
        const void *seen = api->MapBufferRange(GL_COPY_READ_BUFFER, (GLintptr)info.offset,
                                               (GLsizeiptr)info.size, GL_MAP_READ_BIT);
        assert_non_null(seen);
        const int same =
            memcmp(seen, set->pages + (size_t)i * set->page_stride, TSU_PAGE_BYTES) == 0;
        api->UnmapBuffer(GL_COPY_READ_BUFFER);
        api->BindBuffer(GL_COPY_READ_BUFFER, 0);
        if (!same)
            fail_msg("page %u differs", i);
    }
    if (!api->es && set->page_count && set->width) {
        uint16_t *const seen = malloc((size_t)8 * set->width * set->height);
        assert_non_null(seen);
        api->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        api->PixelStorei(GL_PACK_ALIGNMENT, 1);
        api->BindTexture(GL_TEXTURE_2D, info.texture);
        api->GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_HALF_FLOAT, seen);
        api->BindTexture(GL_TEXTURE_2D, 0);
        api->PixelStorei(GL_PACK_ALIGNMENT, 4);
        assert_memory_equal(seen, set->texels, (size_t)8 * set->width * set->height);
        free(seen);
    }
    rig_check_error();
}

void rig_hostile_begin(void)
{
    assert_true(hostile_set(&rig.fixture.gl, &host));
    hostile_snapshot(&rig.fixture.gl, &before);
}

static int may_change(int i, int unit, int binding, int generic)
{
    const char *const name = after.values[i].name;
    const int index = after.values[i].index;
    if (unit >= 0 && index == unit &&
        (strcmp(name, "GL_TEXTURE_BINDING_2D") == 0 || strcmp(name, "GL_SAMPLER_BINDING") == 0))
        return 1;
    // The witness reads the parameters of what is bound on the active unit, which is 7.
    if (unit == 7 && index == 0 &&
        (strncmp(name, "GL_TEXTURE_WRAP", 15) == 0 || strstr(name, "_FILTER") ||
         strstr(name, "_LEVEL")))
        return 1;
    if (binding >= 0 && index == binding && strcmp(name, "GL_UNIFORM_BUFFER_BINDING") == 0)
        return 1;
    return generic && index == -1 &&
           (strcmp(name, "GL_UNIFORM_BUFFER_BINDING") == 0 ||
            strcmp(name, "GL_BUFFER_SIZE of GL_UNIFORM_BUFFER") == 0);
}

void rig_hostile_end(const char *call, int unit, int binding, int generic)
{
    char why[256];
    hostile_snapshot(&rig.fixture.gl, &after);
    for (int i = 0; i < after.count; i++)
        if (may_change(i, unit, binding, generic))
            memcpy(before.values[i].value, after.values[i].value, sizeof after.values[i].value);
    const int same = hostile_compare(&before, &after, why, sizeof why);
    hostile_clear(&rig.fixture.gl, &host);
    if (!same)
        fail_msg("%s: %s", call, why);
    rig_check_error();
}
