// What every GL test needs: a context of the rung, a host that counts and remembers, and readers
// that compare what is in GL with what is in the set.
#ifndef TSUYA_TESTS_GL_RIG_H
#define TSUYA_TESTS_GL_RIG_H

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "counted.h"
#include "fake_set.h"

#include "../support/fixture.h"
#include "../support/hostile.h"

#include <tsuya/gl.h>

enum { RIG_UNIT = 3, RIG_BINDING = 5 };

struct rig {
    struct fixture fixture;
    tsu_context *context; // allocates and logs through the fields below
    unsigned allocations; // since rig_reset()
    unsigned fail_at;     // this allocation fails, counted from 1; 0 for none
    size_t live;          // bytes not freed
    unsigned lines;       // log lines since rig_reset()
    char last[1024];      // the last one
    int32_t code;         // and its code
};
extern struct rig rig;

int rig_open(int argc, char **argv);
int rig_close(void);
// Before each test: no lies, all counts zero.
int rig_reset(void **state);

// Another version of GL, at most the true one, for the library only: GL_VERSION for the loader.
// Returns: 0 when the context is not of this kind or older. `version` is 10 * major + minor.
int rig_pretend(int es, int version);

// tsu_gl_create() through the counting loader.
tsu_status rig_create(uint32_t flags, tsu_gl **out);
// The same, must succeed.
tsu_gl *rig_gl(void);

// Sync: must succeed, allocates nothing and asks for no error. Counts of GL calls start anew.
void rig_sync(tsu_gl *gl, const tsu_set *set);
// Sync of an unchanged set: no GL call, and the set is asked for nothing but its generation.
void rig_check_unchanged(tsu_gl *gl, tsu_set *set);

// Bind the pages (16 of them when there are many) at RIG_UNIT and RIG_BINDING, draw with each, and
// compare with the set: every texel and every value. Uses tsu_gl_program_setup(), tsu_gl_bind().
void rig_check(tsu_gl *gl, const tsu_set *set);
// Compare the bytes of the store with the set's, without drawing.
void rig_check_bytes(const tsu_gl *gl, const tsu_set *set);

// Source that follows the fixture's version line: a program, or the test fails.
GLuint rig_program(const char *body);
// No GL error is pending.
void rig_check_error(void);

// A hostile host around one call. `unit` and `binding` are what the call may bind, -1 for nothing.
void rig_hostile_begin(void);
void rig_hostile_end(const char *call, int unit, int binding, int generic);

#endif
