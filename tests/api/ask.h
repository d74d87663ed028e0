// A set on a watched context, and the schema of a model by index.
#ifndef TSUYA_TESTS_API_ASK_H
#define TSUYA_TESTS_API_ASK_H

#include "watch.h"

enum { ASK_PARAMS_MOST = 512 };

struct ask {
    struct watch watch;
    tsu_context *context;
    tsu_set *set;
};

void ask_open(struct ask *a);
void ask_close(struct ask *a);

tsu_model_info ask_model(const tsu_model *model);
tsu_parameter_info ask_parameter(const tsu_model *model, uint32_t index);
tsu_value_info ask_input(const tsu_model *model, uint32_t function, uint32_t index);

// Asserts that the log holds one line, an error, with this name and both ends of the range.
void ask_log(const struct watch *w, const char *name, double minimum, double maximum);

#endif
