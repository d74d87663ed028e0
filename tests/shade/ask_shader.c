#include "ask_shader.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

const char *const target_names[TARGETS] = {"330", "410", "450", "300es", "310es", "vulkan"};

void ask_open(struct ask *a, tsu_read_fn read, void *user)
{
    watch_begin(&a->watch);
    tsu_context_desc desc = watch_desc(&a->watch);
    desc.read = read;
    desc.read_user = user;
    assert_int_equal(tsu_context_create(&desc, &a->context), TSU_OK);
    assert_true(tsu_model_count() <= MODELS_MOST / 2);
    for (uint32_t i = 0; i < MODELS_MOST; i++)
        a->models[i] = tsu_model_at(i % tsu_model_count());
    assert_int_equal(tsu_shader_desc_init(&a->desc), TSU_OK);
    a->desc.models = a->models;
    a->desc.model_count = tsu_model_count();
}

void ask_close(struct ask *a)
{
    tsu_context_destroy(a->context);
    watch_close(&a->watch);
}

tsu_shader *ask_shader(struct ask *a)
{
    tsu_shader *shader = NULL;
    const tsu_status status = tsu_shader_create(a->context, &a->desc, &shader);
    if (status != TSU_OK)
        fail_msg("%s: %s", tsu_status_text(status), a->watch.log);
    size_t size;
    const char *text = tsu_shader_text(shader, &size);
    assert_int_equal(strlen(text), size);
    return shader;
}

void ask_refused(struct ask *a, tsu_status status, const char *word)
{
    tsu_shader *shader = (tsu_shader *)a;
    const size_t live = a->watch.live;
    watch_quiet(&a->watch);
    assert_int_equal(tsu_shader_create(a->context, &a->desc, &shader), status);
    assert_null(shader);
    assert_int_equal(a->watch.log_count, 1);
    assert_int_equal(a->watch.log_level, TSU_LOG_ERROR);
    if (!strstr(a->watch.log, word))
        fail_msg("the line \"%s\" does not name %s", a->watch.log, word);
    assert_int_equal(a->watch.live, live);
}

const char *model_name(const tsu_model *model)
{
    tsu_model_info info;
    assert_int_equal(tsu_model_info_init(&info), TSU_OK);
    assert_int_equal(tsu_model_describe(model, &info), TSU_OK);
    return info.name;
}
