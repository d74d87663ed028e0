// Baked tables as bytes: they come back, and nothing but them does.
#include "rig.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct rig r;

// Offsets that runtime/bake/cache.h documents.
enum { VERSION = 8, LIBRARY = 12, WHOLE = 16, COUNT = 24, ZERO = 28, FIRST = 32 };

struct block {
    unsigned char *bytes;
    size_t size;
};

static struct block block_of(const tsu_set *set)
{
    struct block block = {NULL, tsu_set_cache_size(set)};
    block.bytes = malloc(block.size);
    assert_non_null(block.bytes);
    assert_int_equal(tsu_set_cache_write(set, block.bytes, block.size), TSU_OK);
    return block;
}

// Hash of the whole written anew, so that only structure can betray a change.
static void seal(struct block block)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < block.size - 8; i++)
        hash = (hash ^ block.bytes[i]) * 0x100000001b3u;
    for (int i = 0; i < 8; i++)
        block.bytes[block.size - 8 + (size_t)i] = (unsigned char)(hash >> 8 * i);
}

static void refuse(struct block block, tsu_status status)
{
    uint32_t taken = 9;
    const tsu_set_info before = rig_describe(&r);
    watch_quiet(&r.watch);
    assert_int_equal(tsu_set_cache_read(r.set, block.bytes, block.size, &taken), status);
    assert_int_equal(taken, 0);
    assert_int_equal(r.watch.log_count, 1);
    assert_non_null(strstr(r.watch.log, "block"));
    const tsu_set_info after = rig_describe(&r);
    assert_memory_equal(&before, &after, sizeof before);
}

static uint32_t read_block(struct block block)
{
    uint32_t taken = 9;
    assert_int_equal(tsu_set_cache_read(r.set, block.bytes, block.size, &taken), TSU_OK);
    return taken;
}

static struct block one_table(void)
{
    rig_open(&r, 0, NULL);
    rig_add(&r, 1.55f, 0.17f);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    const struct block block = block_of(r.set);
    assert_true(block.size > RIG_TABLE_BYTES && block.size < RIG_TABLE_BYTES + 256);
    rig_close(&r);
    return block;
}

static void tables_come_back(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    rig_add(&r, 1.55f, 0.17f);
    const uint32_t second = rig_add(&r, 1.4f, 0.2f);
    uint32_t dual;
    tsu_dual_scattering_params params;
    assert_int_equal(tsu_dual_scattering_params_init(&params), TSU_OK);
    assert_int_equal(tsu_set_add(r.set, tsu_dual_scattering(), &params, &dual), TSU_OK);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    const uint32_t count = rig_describe(&r).table_count;
    assert_true(count >= 3);
    const struct block block = block_of(r.set);
    const tsu_set_info info = rig_describe(&r);
    const size_t texels = (size_t)info.width * info.height * 4 * sizeof(uint16_t);
    uint16_t *expected = malloc(texels);
    assert_non_null(expected);
    memcpy(expected, tsu_set_texels(r.set), texels);
    rig_close(&r);

    // The same materials in the same order: the same image, and no bake to do.
    rig_open(&r, 0, NULL);
    assert_int_equal(read_block(block), 0);
    rig_add(&r, 1.55f, 0.17f);
    rig_add(&r, 1.4f, 0.2f);
    assert_int_equal(tsu_set_add(r.set, tsu_dual_scattering(), &params, &dual), TSU_OK);
    assert_int_equal(rig_describe(&r).stale_count, count);
    const uint64_t before = rig_describe(&r).texture_generation;
    assert_int_equal(read_block(block), count);
    assert_int_equal(rig_describe(&r).stale_count, 0);
    assert_true(rig_describe(&r).texture_generation > before);
    assert_memory_equal(tsu_set_texels(r.set), expected, texels);
    for (uint32_t i = 0; i < count; i++)
        assert_true(rig_region(&r, i).generation > before);
    assert_int_equal(read_block(block), 0); // they are there
    const struct block again = block_of(r.set);
    assert_int_equal(again.size, block.size);
    assert_memory_equal(again.bytes, block.bytes, block.size);
    rig_close(&r);

    // Another place in the image, beside a table that the block does not have.
    rig_open(&r, 0, NULL);
    rig_add(&r, 1.7f, 0.3f);
    assert_int_equal(rig_add(&r, 1.4f, 0.2f), second);
    assert_int_equal(tsu_set_cache_read(r.set, block.bytes, block.size, NULL), TSU_OK);
    assert_int_equal(rig_describe(&r).stale_count, 1);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    uint16_t *there = rig_texels(&r, rig_region_of(&r, second)), *alone = rig_alone(1.4f, 0.2f);
    assert_memory_equal(there, alone, RIG_TABLE_BYTES);
    rig_close(&r);
    free(there);
    free(alone);
    free(expected);
    free(again.bytes);
    free(block.bytes);
}

static void stale_tables_are_left_out(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    const size_t empty = tsu_set_cache_size(r.set);
    rig_add(&r, 1.55f, 0.17f);
    assert_int_equal(tsu_set_cache_size(r.set), empty);
    const struct block block = block_of(r.set);
    assert_int_equal(read_block(block), 0);
    assert_int_equal(rig_describe(&r).stale_count, 1);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    assert_true(tsu_set_cache_size(r.set) > empty + RIG_TABLE_BYTES);
    const tsu_marschner_params hair = rig_hair(1.5f, 0.17f);
    assert_int_equal(tsu_set_update(r.set, 0, &hair, NULL), TSU_OK);
    assert_int_equal(tsu_set_cache_size(r.set), empty);
    rig_close(&r);
    free(block.bytes);
}

static void every_changed_byte_is_found(void **state)
{
    (void)state;
    const struct block block = one_table();
    const size_t step = getenv("TSUYA_LONG") ? 1 : 97;
    rig_open(&r, 0, NULL);
    rig_add(&r, 1.55f, 0.17f);
    for (size_t i = 0; i < block.size; i += i < 256 || i + 256 > block.size ? 1 : step) {
        const unsigned char was = block.bytes[i];
        block.bytes[i] = (unsigned char)(was ^ (i % 2 ? 0xff : 1 << i / 2 % 8));
        refuse(block, i >= VERSION && i < WHOLE ? TSU_E_VERSION : TSU_E_PARAMETER);
        block.bytes[i] = was;
    }
    assert_int_equal(read_block(block), 1);
    rig_close(&r);
    free(block.bytes);
}

static void every_truncation_is_found(void **state)
{
    (void)state;
    const struct block block = one_table();
    rig_open(&r, 0, NULL);
    rig_add(&r, 1.55f, 0.17f);
    for (size_t size = 0; size < block.size; size++)
        refuse((struct block){block.bytes, size}, TSU_E_PARAMETER);
    // One that ends where memory does: nothing past it may be read.
    for (size_t size = 1; size < 200; size++) {
        struct block copy = {malloc(size), size};
        assert_non_null(copy.bytes);
        memcpy(copy.bytes, block.bytes, size);
        refuse(copy, TSU_E_PARAMETER);
        free(copy.bytes);
    }
    struct block longer = {malloc(block.size + 1), block.size + 1};
    assert_non_null(longer.bytes);
    memcpy(longer.bytes, block.bytes, block.size);
    longer.bytes[block.size] = 0;
    refuse(longer, TSU_E_PARAMETER);
    free(longer.bytes);
    assert_int_equal(read_block(block), 1);
    rig_close(&r);
    free(block.bytes);
}

// Fields that lie under a hash that is right.
static void structure_is_checked_apart_from_the_hash(void **state)
{
    (void)state;
    const struct block block = one_table();
    rig_open(&r, 0, NULL);
    rig_add(&r, 1.55f, 0.17f);
    unsigned char *const copy = malloc(block.size);
    assert_non_null(copy);
    const struct block forged = {copy, block.size};
    // Number of tables, the zero, lengths of name and key, width, height: each wrong in each byte.
    static const size_t fields[] = {COUNT, ZERO, FIRST + 8, FIRST + 12, FIRST + 16, FIRST + 20};
    for (size_t f = 0; f < sizeof fields / sizeof *fields; f++)
        for (size_t b = 0; b < 4; b++)
            for (int bit = 0; bit < 8; bit++) {
                memcpy(copy, block.bytes, block.size);
                copy[fields[f] + b] = (unsigned char)(copy[fields[f] + b] ^ 1 << bit);
                seal(forged);
                refuse(forged, TSU_E_PARAMETER);
            }
    // Whole but of no table here: hash of the definition, name, key.
    for (size_t at = FIRST; at < FIRST + 24 + 16; at++) {
        if (at == FIRST + 8)
            at = FIRST + 24;
        memcpy(copy, block.bytes, block.size);
        copy[at] ^= 0x20;
        seal(forged);
        assert_int_equal(read_block(forged), 0);
    }
    // Cut at every place and told so: the hash is right, the tables do not fill it.
    for (size_t size = FIRST + 9; size < FIRST + 300; size++) {
        struct block cut = {copy, size};
        memcpy(copy, block.bytes, size);
        for (int i = 0; i < 8; i++)
            copy[WHOLE + i] = (unsigned char)((uint64_t)size >> 8 * i);
        seal(cut);
        refuse(cut, TSU_E_PARAMETER);
    }
    assert_int_equal(rig_describe(&r).stale_count, 1);
    assert_int_equal(read_block(block), 1);
    rig_close(&r);
    free(copy);
    free(block.bytes);
}

static void bad_calls_are_refused(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    rig_add(&r, 1.55f, 0.17f);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    const struct block block = block_of(r.set);
    assert_int_equal(tsu_set_cache_size(NULL), 0);
    assert_int_equal(tsu_set_cache_write(NULL, block.bytes, block.size), TSU_E_PARAMETER);
    assert_int_equal(tsu_set_cache_write(r.set, NULL, block.size), TSU_E_PARAMETER);
    watch_quiet(&r.watch);
    memset(block.bytes, 5, block.size);
    assert_int_equal(tsu_set_cache_write(r.set, block.bytes, block.size - 1), TSU_E_PARAMETER);
    assert_non_null(strstr(r.watch.log, "tsu_set_cache_size()"));
    for (size_t i = 0; i < block.size; i++)
        assert_int_equal(block.bytes[i], 5);
    uint32_t taken = 9;
    assert_int_equal(tsu_set_cache_read(NULL, block.bytes, block.size, &taken), TSU_E_PARAMETER);
    assert_int_equal(taken, 0);
    assert_int_equal(tsu_set_cache_read(r.set, NULL, block.size, &taken), TSU_E_PARAMETER);
    rig_close(&r);
    free(block.bytes);
}

int cache_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables_come_back),
        cmocka_unit_test(stale_tables_are_left_out),
        cmocka_unit_test(every_changed_byte_is_found),
        cmocka_unit_test(every_truncation_is_found),
        cmocka_unit_test(structure_is_checked_apart_from_the_hash),
        cmocka_unit_test(bad_calls_are_refused),
    };
    return cmocka_run_group_tests_name("cache", tests, NULL, NULL);
}
