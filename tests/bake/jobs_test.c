// Baking on the host's threads gives the bytes that baking alone gives.
#include "rig.h"

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct rig r;

struct share {
    void (*job)(void *data, uint32_t index);
    void *data;
    uint32_t count, worker, workers;
};

static uint32_t jobs_run;

// Worker w takes every index that is w modulo the workers, the last first.
static void *work(void *user)
{
    const struct share *s = user;
    for (uint32_t i = s->count; i-- > 0;)
        if (i % s->workers == s->worker)
            s->job(s->data, i);
    return NULL;
}

static void threads(void *user, void (*job)(void *data, uint32_t index), void *data, uint32_t count)
{
    assert_ptr_equal(user, &r);
    enum { WORKERS = 4 };
    pthread_t thread[WORKERS];
    struct share share[WORKERS];
    jobs_run += count;
    for (uint32_t w = 0; w < WORKERS; w++) {
        share[w] = (struct share){job, data, count, w, WORKERS};
        assert_int_equal(pthread_create(thread + w, NULL, work, share + w), 0);
    }
    for (uint32_t w = 0; w < WORKERS; w++)
        assert_int_equal(pthread_join(thread[w], NULL), 0);
}

static void threads_give_the_same_bytes(void **state)
{
    (void)state;
    static const float eta[] = {1.2f, 1.37f, 1.55f, 1.8f, 2.0f};
    static const float beta_az[] = {0.0873f, 0.11f, 0.17f, 0.35f, 0.52f};
    jobs_run = 0;
    rig_open(&r, 0, threads);
    for (int i = 0; i < 5; i++)
        rig_add(&r, eta[i], beta_az[i]);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    assert_true(jobs_run >= 5);
    for (uint32_t i = 0; i < 5; i++) {
        uint16_t *got = rig_texels(&r, rig_region_of(&r, i));
        uint16_t *alone = rig_alone(eta[i], beta_az[i]);
        assert_memory_equal(got, alone, RIG_TABLE_BYTES);
        free(got);
        free(alone);
    }
    rig_close(&r);
}

int jobs_tests(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(threads_give_the_same_bytes)};
    return cmocka_run_group_tests_name("jobs", tests, NULL, NULL);
}
