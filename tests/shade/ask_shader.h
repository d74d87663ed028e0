// A shader on a watched context, asked for in one line.
#ifndef TSUYA_TESTS_SHADE_ASK_SHADER_H
#define TSUYA_TESTS_SHADE_ASK_SHADER_H

#include "watch.h"

enum { TARGETS = 6, MODELS_MOST = 32 };
extern const char *const target_names[TARGETS];

struct ask {
    struct watch watch;
    tsu_context *context;
    const tsu_model *models[MODELS_MOST];
    tsu_shader_desc desc; // defaults, with all models
};

// `read` may be NULL; its user is `user`.
void ask_open(struct ask *a, tsu_read_fn read, void *user);
void ask_close(struct ask *a);
tsu_shader *ask_shader(struct ask *a);
// Asserts that the descriptor as it stands is refused with this status and a line with this word.
void ask_refused(struct ask *a, tsu_status status, const char *word);
const char *model_name(const tsu_model *model);

// Groups of tests.
int text_tests(void);
int read_tests(void);
int compile_tests(void);
int shadow_tests(void);
int drop_tests(void);
int only_tests(void);

#endif
